// The bus as one who has no part in a run sees it: the latched mission, ticks and beacons of one swarm.
//
// Ticks and beacons are read best effort. An observer slows nobody: nothing waits for it, and it may come, hang and go
// at any time. What it misses is gone.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "idl/bus/dds_port.hpp"

namespace skein::bus {

using ObserverInbound = std::variant<wire::Mission, wire::Tick, wire::Beacon>;

class DdsObserverPort {
 public:
  /// An observer of swarm `config.swarm`. Throws as DdsAgentPort does.
  explicit DdsObserverPort(const DdsConfig& config);
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
