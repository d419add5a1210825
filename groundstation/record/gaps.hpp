// How much of each DDS writer's samples a recording has: exact, between the first and the last one that it heard.
//
// A writer numbers its samples 1, 2, 3, ... (RTPS), so that of those from the first to the last heard one
//   lost = last - first + 1 - kept.
// What it sent before the first is not lost: nobody was there to hear it. What it sent after the last is in no number:
// conclude() adds what else tells of it (heard_ends.hpp), and says whether that is all. Source: RTPS 2.2, 8.3.5.4
// (SequenceNumber). Departs from source: none. Complexity: O(log writers) a sample.
#pragma once

#include <algorithm>
#include <map>
#include <string>

#include "groundstation/mcap/records.hpp"
#include "groundstation/record/heard_ends.hpp"
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
    Tail tail{};
    /// At least so many, if its end was not heard.
    [[nodiscard]] std::uint64_t lost() const { return std::max(last - first + 1, kept) - kept + tail.lost; }
  };

  void note(const bus::RawSample& sample, bool is_world, AgentId agent);

  /// Nothing more will be noted.
  void conclude(const HeardEnds& ends);

  [[nodiscard]] std::uint64_t lost() const;
  /// Whether the end of every writer was heard that has one; else lost() is a lower bound. @pre conclude()
  [[nodiscard]] bool end_heard() const;
  [[nodiscard]] const std::map<bus::WriterKey, Writer>& writers() const { return writers_; }
  /// For the recording: `lost`, `end_heard` once it is known, and of each writer from and to which number it was heard,
  /// what was kept and lost.
  [[nodiscard]] mcap::Texts texts() const;

 private:
  std::map<bus::WriterKey, Writer> writers_;
  bool concluded_ = false;
};

/// "skein/beacon of agent 3"
[[nodiscard]] std::string name_of(const Gaps::Writer& writer);

}  // namespace skein
