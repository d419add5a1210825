// The barrier of one round: what the live agents answered to the open tick, kept in order of id.
//
// A round is complete when every expected agent's closing beacon is here with the samples it counts. Copies of a sample
// (agent, incarnation, round) change nothing; samples of other rounds or incarnations are not of this round.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "planner/core/lockstep/map_sample.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein {

/// An agent's answer to a round.
struct Answer {
  std::optional<Beacon> beacon;  ///< its closing beacon
  std::optional<Representative> representative;
  std::optional<ObstacleMapSample> obstacle_map;
};

class Barrier {
 public:
  /// Opens a round for the agents of `tick.roster`; all answers to the round before are forgotten.
  void open(const Tick& tick, double now_s);
  /// @return whether the beacon closes its agent's part of the open round for the first time.
  bool accept(const Beacon& beacon);
  bool accept(const Representative& sample);
  bool accept(const ObstacleMapSample& sample);
  /// The agent no longer has to answer.
  void excuse(AgentId agent);

  [[nodiscard]] bool complete() const;
  /// Agents that the round still waits for, ascending.
  [[nodiscard]] std::vector<AgentId> waiting_for() const;
  /// How many beacons the round still waits for.
  [[nodiscard]] std::size_t lacking_beacons() const;
  [[nodiscard]] const Answer* answer_of(AgentId agent) const;
  [[nodiscard]] double opened_s() const { return opened_s_; }

 private:
  struct Part {
    std::uint32_t incarnation = 0;
    bool excused = false;
    Answer answer;
  };
  [[nodiscard]] static bool closed(const Part& part);
  [[nodiscard]] Part* part_of(AgentId agent, std::uint32_t incarnation, std::uint32_t round);

  std::uint32_t round_ = 0;
  double opened_s_ = 0.0;
  std::map<AgentId, Part> parts_;
};

}  // namespace skein
