// What a recording has to be played: its mission, and its samples in their order.
//
// One run is played, the one that the file's first tick of a round belongs to, with the introductions of its agents
// (which name no run). Samples come by log_time, those of equal time as they were recorded. The mission comes first,
// whatever is played, and once: it is latched. Source: docs/recording.md. Departs from source: none.
// Complexity: O(samples log samples); memory for a chunk and the places of the samples.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "groundstation/mcap/reader.hpp"
#include "idl/bus/dds_replay_port.hpp"

namespace skein::replay {

struct Note {
  bus::ReplayWriter writer;
  std::uint64_t log_time = 0;  ///< ns
  std::span<const std::uint8_t> payload;
};

class Score {
 public:
  /// @param file outlives it. @throws mcap::Damaged; std::runtime_error with one line if it cannot be played: of
  /// another wire version, without a round of a run, or without its mission
  explicit Score(const mcap::Reader& file);

  /// Each writer of what is played, once.
  [[nodiscard]] const std::vector<bus::ReplayWriter>& writers() const { return writers_; }
  [[nodiscard]] const mcap::Bytes& mission() const { return mission_; }
  /// log_time of the run's last sample.
  [[nodiscard]] std::uint64_t end() const { return end_; }
  /// Samples of other runs, and those that are none: not played.
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }
  /// What the planning rounds of its scenario stand for, s; the default without one.
  [[nodiscard]] double round_s() const { return round_s_; }

  /// Plays all but missions, from `from` (log_time) on. @param play returns whether to go on. @throws mcap::Damaged
  void play(std::uint64_t from, const std::function<bool(const Note&)>& play) const;

 private:
  struct Voice {
    const bus::TopicSpec* topic = nullptr;
    bus::ReplayWriter writer;
  };
  void take_channels();
  void take_run();
  [[nodiscard]] bool is_of_run(const Voice& voice, std::span<const std::uint8_t> payload) const;

  const mcap::Reader& file_;
  std::map<std::uint16_t, Voice> voices_;  ///< by channel
  std::vector<bus::ReplayWriter> writers_;
  mcap::Bytes mission_;
  std::uint64_t run_ = 0;
  std::uint64_t end_ = 0;
  std::uint64_t left_out_ = 0;
  double round_s_;
};

}  // namespace skein::replay
