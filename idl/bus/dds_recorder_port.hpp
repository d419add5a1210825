// The bus as a recorder sees it: every sample of a swarm, of all topics, as the bytes that DDS carried.
//
// Nothing is decoded: the types of its readers copy the payload, with its 4 bytes of encapsulation. It hears what each
// agent senses too. Reading best effort it slows nobody, and loses what comes faster than it is taken; the number that
// DDS gave each sample tells how much. Reading reliably, it gets everything that writers still hold (depth 16 of each
// instance): nothing is lost while something waits for it (docs/recording.md).
// Source: DDS 1.4, RTPS 2.2 (sequence numbers). Departs from source: none. Complexity: O(bytes).
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "idl/bus/dds_port.hpp"
#include "idl/bus/topics.hpp"

namespace skein::bus {

/// A DDS writer: the prefix of its process (12 bytes) and what tells it apart there.
using WriterKey = std::array<std::uint8_t, 16>;

struct RawSample {
  TopicId topic = TopicId::Tick;
  WriterKey writer{};
  std::uint64_t sequence = 0;  ///< of that writer, from 1, by one more each time
  std::vector<std::uint8_t> payload;
};

struct RecorderReads {
  bool reliable = false;                     ///< else best effort, but for the mission, which is latched
  std::size_t inbox = std::size_t{1} << 16;  ///< samples that may wait to be taken; older ones go
};

class DdsRecorderPort {
 public:
  /// Of swarm `config.swarm`, as an observer. Throws as DdsAgentPort does.
  explicit DdsRecorderPort(const DdsConfig& config, RecorderReads reads = {});
  ~DdsRecorderPort();
  DdsRecorderPort(const DdsRecorderPort&) = delete;
  DdsRecorderPort& operator=(const DdsRecorderPort&) = delete;

  /// Moves everything that has arrived to the end of `into`; returns at once.
  void take(std::vector<RawSample>& into);
  /// As DdsAgentGroup::renew(); has_world() is false until the world is found again, and the mission comes once more.
  void renew();
  /// Readable when something arrived or a process came or went since the last take().
  [[nodiscard]] int wake_fd() const;
  /// Whether a world of the swarm is there.
  [[nodiscard]] bool has_world() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::bus
