// Whether the recorder of a run has the open round, which the world waits for as for an agent's answer.
//
// The recorder says which round it heard last and whose part of it is not whole. Who is lost has no part in it. A
// recorder that lacks something of an answered round until the deadline is given up: the run goes on, and the recording
// says what it lacks. Source: none. Departs from source: none. Complexity: O(agents) a question.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "planner/core/lockstep/samples.hpp"

namespace skein {

class RecorderGate {
 public:
  /// @param awaited whether there is a recorder
  explicit RecorderGate(bool awaited) : awaited_(awaited) {}

  /// What the recorder says.
  void say(std::uint32_t round, std::vector<AgentId> lacking) {
    round_ = round;
    lacking_ = std::move(lacking);
  }

  /// Whether the recorder has the parts of all `is_live` agents in the tick's round; without one, true.
  [[nodiscard]] bool passes(const Tick& tick, const std::function<bool(AgentId)>& is_live) const {
    if (!awaited_) return true;
    return round_ == tick.round && std::ranges::none_of(lacking_, is_live);
  }

  /// Whether the recorder lacks the agent's part of the tick's round.
  [[nodiscard]] bool lacks(const Tick& tick, AgentId agent) const {
    if (!awaited_) return false;
    return round_ != tick.round || std::ranges::find(lacking_, agent) != lacking_.end();
  }

  /// How long the answered round has waited for the recorder, counted from the first call of it (s).
  [[nodiscard]] double waits_s(std::uint32_t round, double now_s) {
    if (waiting_round_ != round) {
      waiting_round_ = round;
      since_s_ = now_s;
    }
    return now_s - since_s_;
  }

  /// From now on the world does not wait for it.
  void give_up() {
    given_up_ = given_up_ || awaited_;
    awaited_ = false;
  }
  [[nodiscard]] bool given_up() const { return given_up_; }

 private:
  bool awaited_;
  bool given_up_ = false;
  std::uint32_t waiting_round_ = 0;
  double since_s_ = 0.0;
  std::uint32_t round_ = 0;
  std::vector<AgentId> lacking_;
};

}  // namespace skein
