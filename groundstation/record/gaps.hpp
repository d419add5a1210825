// How much of each DDS writer's samples a recording has: exact, between the first and the last one that it heard.
//
// A writer numbers its samples 1, 2, 3, ... (RTPS), so that of those from the first to the last heard one
//   lost = last - first + 1 - kept.
// What it sent before the first is not lost: nobody was there to hear it. Source: RTPS 2.2, 8.3.5.4 (SequenceNumber).
// Departs from source: none. Complexity: O(log writers) a sample.
#pragma once

#include <algorithm>
#include <map>
#include <string>

#include "groundstation/mcap/records.hpp"
#include "idl/bus/dds_recorder_port.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

class Gaps {
 public:
  struct Writer {
    bus::TopicId topic = bus::TopicId::Tick;
    bool is_world = false;
    AgentId agent = kWorldId;  ///< of its first sample; a process of several agents has one writer for all
    std::uint64_t first = 0;
    std::uint64_t last = 0;
    std::uint64_t kept = 0;
    [[nodiscard]] std::uint64_t lost() const { return std::max(last - first + 1, kept) - kept; }
  };

  void note(const bus::RawSample& sample, bool is_world, AgentId agent);

  [[nodiscard]] std::uint64_t lost() const;
  [[nodiscard]] const std::map<bus::WriterKey, Writer>& writers() const { return writers_; }
  /// For the recording: `lost`, and of each writer from and to which number it was heard, what was kept and lost.
  [[nodiscard]] mcap::Texts texts() const;

 private:
  std::map<bus::WriterKey, Writer> writers_;
};

/// "skein/beacon of agent 3"
[[nodiscard]] std::string name_of(const Gaps::Writer& writer);

}  // namespace skein
