// The recorder of `skein run --record` over DDS: reliable, and part of the barrier, so that every sample is kept.
//
// Writers hold the last 16 samples of each instance, whoever has not got them. The world opens no round before the
// recorder has the one that is open (it says so over the launcher's channel), so that nothing is overwritten that it
// lacks; what got lost on the way the bus repairs, and a tick that is unrecorded for a second is sent again and
// answered again. Without a word for `lockstep.deadline_s` the world goes on without it. Source: none. Departs from
// source: none. Complexity: O(bytes), and a message a round.
#pragma once

#include <optional>

#include "groundstation/record/bus_recorder.hpp"
#include "groundstation/record/recording_file.hpp"
#include "idl/process/common_flags.hpp"
#include "idl/process/network_watch.hpp"

namespace skein {

class BarrierRecorder {
 public:
  /// @param flags with the swarm's name. Block signals before. @throws std::runtime_error
  BarrierRecorder(const CommonFlags& flags, const std::string& path, const Scenario& scenario, bool fail_fast);

  /// Readable when something arrived.
  [[nodiscard]] int wake_fd() const { return port_.wake_fd(); }
  /// Records what arrived. @return what the world is to be told: {"recorded": ROUND, "lacking": IDS}, that nothing is
  /// recorded any more ({"unrecorded": REASON}), or nothing
  [[nodiscard]] std::optional<nlohmann::json> serve();
  /// Takes the rest and ends the file. @param report is attached
  void finish(const nlohmann::ordered_json& report);
  /// Why nothing is recorded any more (a full disk), in one line; empty while all is well.
  [[nodiscard]] const std::string& failure() const { return file_.failure(); }
  [[nodiscard]] std::uint64_t lost() const { return recorder_.gaps().lost(); }

 private:
  void take();

  RecordingFile file_;
  NetworkWatch network_;
  bus::DdsRecorderPort port_;
  BusRecorder recorder_;
  bool failure_told_ = false;
  std::uint32_t told_round_ = 0;
  bool told_whole_ = false;
  double told_s_ = 0.0;
  double heard_s_;
  double flushed_s_;
};

}  // namespace skein
