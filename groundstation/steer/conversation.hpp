// What became of a command, as ticks and beacons tell it: taken up or refused, and by whom it was acknowledged.
//
// The world says what it took up in the tick of the round, and in its answers for some seconds; an agent acknowledges
// in its beacon of that round, and the answers repeat it. Any of these may be missed: each alone is enough. Source:
// docs/steering.md. Departs from source: none. Complexity: O(agents) a sample.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "idl/bus/dds_observer_port.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein {

class Conversation {
 public:
  /// @param agent that it concerns; kAllAgents: all that are live when it takes effect
  /// @param acknowledges agents do; else the world's answer is all (injections)
  Conversation(std::uint64_t id, AgentId agent, bool acknowledges)
      : id_(id), agent_(agent), acknowledges_(acknowledges) {}

  void take(const bus::ObserverInbound& sample);

  /// Of the swarm's run; nothing before a tick was heard.
  [[nodiscard]] std::optional<std::uint64_t> run() const { return run_; }
  /// The world's answer; nothing while there is none.
  [[nodiscard]] const std::optional<OrderAnswer>& answer() const { return answer_; }
  [[nodiscard]] bool accepted() const { return answer_ && answer_->result == OrderResult::Accepted; }
  [[nodiscard]] const std::set<AgentId>& acknowledged() const { return acknowledged_; }
  /// Whom it concerns and who has not said so.
  [[nodiscard]] std::vector<AgentId> missing() const;
  /// Refused, or taken up and acknowledged by all whom it concerns.
  [[nodiscard]] bool complete() const;

 private:
  void on_tick(const Tick& tick);
  void on_beacon(const Beacon& beacon);

  std::uint64_t id_;
  AgentId agent_;
  bool acknowledges_;
  std::optional<std::uint64_t> run_;
  std::optional<OrderAnswer> answer_;
  std::set<AgentId> acknowledged_;
  std::vector<AgentId> live_;     ///< by the newest tick, or that of the round in which it took effect
  bool knows_concerned_ = false;  ///< live_ is of that round
};

}  // namespace skein
