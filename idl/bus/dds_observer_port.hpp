// The bus as one who has no part in a run sees it: the latched mission, ticks and beacons of one swarm, and on request
// what agents share.
//
// All but the mission is read best effort. An observer slows nobody: nothing waits for it, and it may come, hang and go
// at any time. What it misses is gone. What the world tells one agent alone (sense) is not read.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "idl/bus/dds_port.hpp"
#include "idl/bus/topics.hpp"

namespace skein::bus {

using ObserverInbound = std::variant<wire::Mission, wire::Tick, wire::Beacon, wire::Representative, wire::ObstacleMap>;

enum class Observed : std::uint8_t {
  Progress,  ///< mission, ticks and beacons
  Shared,    ///< representatives and obstacle maps too
};

/// Who writes and reads a topic of the swarm, as discovery says; this process is not counted.
struct TopicEndpoints {
  std::uint32_t writers = 0;
  std::uint32_t readers = 0;
};

class DdsObserverPort {
 public:
  /// An observer of swarm `config.swarm`. Throws as DdsAgentPort does.
  explicit DdsObserverPort(const DdsConfig& config, Observed what = Observed::Progress);
  ~DdsObserverPort();
  DdsObserverPort(const DdsObserverPort&) = delete;
  DdsObserverPort& operator=(const DdsObserverPort&) = delete;

  /// Moves everything that has arrived to the end of `into`; returns at once.
  void take(std::vector<ObserverInbound>& into);
  /// As DdsAgentGroup::renew(); has_world() is false until the world is found again.
  void renew();
  /// Readable when something arrived or a process came or went since the last take().
  [[nodiscard]] int wake_fd() const;
  /// Whether a world of the swarm is there.
  [[nodiscard]] bool has_world() const;
  /// Why nothing of the swarm can be read, in one line: its world has another wire version.
  [[nodiscard]] std::optional<std::string> conflict() const;
  /// By TopicId.
  [[nodiscard]] std::array<TopicEndpoints, kTopics.size()> endpoints() const;
  /// Samples that came faster than they were taken.
  [[nodiscard]] std::uint64_t lost() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Hears which swarms a domain has, without endpoints of its own.
class DdsSwarmFinder {
 public:
  /// `config.swarm` is not used. Throws as DdsAgentPort does.
  explicit DdsSwarmFinder(DdsConfig config);
  ~DdsSwarmFinder();
  DdsSwarmFinder(const DdsSwarmFinder&) = delete;
  DdsSwarmFinder& operator=(const DdsSwarmFinder&) = delete;

  /// Those heard so far, ascending.
  [[nodiscard]] std::vector<std::string> swarms() const;
  /// As DdsAgentGroup::renew(): hears anew.
  void renew();
  /// Readable when a process came or went since the last call of swarms().
  [[nodiscard]] int wake_fd() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::bus
