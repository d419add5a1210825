// The bus as a replay of a recording plays it: samples as the bytes that were recorded, in the places of their writers.
//
// Two participants stand for all processes of the recorded swarm: one in the world's place, which says so in its
// USER_DATA, so that the swarm has a world for whoever observes it and a second world is refused; and one in the places
// of the agents, which takes no part in anything, so that what came from an agent does not come from the world's
// process. QoS is that of the topic table. Nothing is read.
// Source: none. Departs from source: none. Complexity: O(bytes).
#pragma once

#include <compare>
#include <memory>
#include <span>

#include "idl/bus/dds_port.hpp"
#include "idl/bus/topics.hpp"

namespace skein::bus {

/// A writer of the recorded swarm; one stands for those of all agents, and one of a topic with a partition an agent.
struct ReplayWriter {
  TopicId topic = TopicId::Tick;
  bool from_world = false;
  AgentId agent = kWorldId;  ///< of a topic with a partition an agent; else not used
  auto operator<=>(const ReplayWriter&) const =
      default;  // NOLINT(modernize-use-nullptr): a false alarm of clang-tidy 14
};

class DdsReplayPort {
 public:
  /// In swarm `config.swarm`, with these writers (each once counts). Throws as DdsAgentPort does.
  DdsReplayPort(const DdsConfig& config, std::span<const ReplayWriter> writers);
  ~DdsReplayPort();
  DdsReplayPort(const DdsReplayPort&) = delete;
  DdsReplayPort& operator=(const DdsReplayPort&) = delete;

  /// The payload with its encapsulation. @return false if there is no such writer, or DDS did not accept the bytes
  [[nodiscard]] bool publish(ReplayWriter writer, std::span<const std::uint8_t> payload);
  /// How many readers of ticks there are.
  [[nodiscard]] std::uint32_t tick_readers() const;
  /// How many readers all writers have together: it changes while readers are being found.
  [[nodiscard]] std::uint32_t readers() const;
  /// Why this process must not play, in one line: another world of the swarm that started earlier.
  [[nodiscard]] std::optional<std::string> conflict() const;
  /// Waits until every reliable reader has acknowledged everything; false if that took longer than `limit`.
  [[nodiscard]] bool flush(std::chrono::milliseconds limit);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::bus
