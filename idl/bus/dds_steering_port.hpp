// The bus as an operator has it: reads what an observer reads, and tells the world of one swarm what to do.
//
// Its readers are best effort, its writers reliable and volatile. It has no part in the matching that starts a swarm.
// What it publishes before the world's readers are found reaches nobody: ask ready() first. A port of its own, so that
// who only watches announces no writers.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "idl/bus/dds_observer_port.hpp"

namespace skein::bus {

class DdsSteeringPort {
 public:
  /// In swarm `config.swarm`. Throws as DdsAgentPort does.
  explicit DdsSteeringPort(const DdsConfig& config);
  ~DdsSteeringPort();
  DdsSteeringPort(const DdsSteeringPort&) = delete;
  DdsSteeringPort& operator=(const DdsSteeringPort&) = delete;

  /// False if DDS did not accept the sample.
  [[nodiscard]] bool publish(const wire::Command& sample);
  [[nodiscard]] bool publish(const wire::Inject& sample);
  /// Moves everything that has arrived to the end of `into`; returns at once.
  void take(std::vector<ObserverInbound>& into);
  /// Readable when something arrived or a process came or went since the last take().
  [[nodiscard]] int wake_fd() const;
  /// Whether a world of the swarm is there, and readers of both topics are.
  [[nodiscard]] bool ready() const;
  /// As that of DdsObserverPort.
  [[nodiscard]] std::optional<std::string> conflict() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::bus
