// What an agent does in a round, whatever its mission kind: from tick, sense and peers' samples to what it publishes.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "planner/core/lockstep/map_sample.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein {

/// Everything that a round's decision may depend on, besides the behaviour's own state.
struct RoundInput {
  const Tick& tick;
  const Sense* sense = nullptr;                  ///< given in flight
  std::span<const Representative> peers = {};    ///< of the round before, of all live peers that published, by id
  std::span<const ObstacleMapSample> maps = {};  ///< the same; what of them the radio carries, the behaviour finds out
};

struct RoundOutput {
  AgentMode mode = AgentMode::Waiting;
  Constraint constraint = Constraint::None;
  AgentId constraint_peer = 0;
  Vec3 commanded_velocity_mps = Vec3::Zero();
  double planned_length_m = 0.0;
  double cost = 0.0;
  std::uint32_t generation = 0;
  std::uint64_t map_hash = 0;   ///< of its obstacle map; 0 without one
  std::uint64_t plan_view = 0;  ///< of the plan that it flies; 0: of none that the swarm agreed on
  SafetyMode safety_mode = SafetyMode::Autonomous;
  SafetyReason safety_reason = SafetyReason::None;
  double deviation_m = 0.0;                       ///< as in Beacon
  double predicted_separation_m = 1e6;            ///< as in Beacon
  std::optional<Representative> representative;   ///< run, incarnation and round are filled in by the runtime
  std::optional<ObstacleMapSample> obstacle_map;  ///< the same
};

class Behaviour {
 public:
  virtual ~Behaviour() = default;
  /// Whether a peer's representative is one that the peer's own planner can have published. One that is not is left
  /// out, by all who hear it alike.
  [[nodiscard]] virtual bool can_use(const Representative& peer) const = 0;
  /// One round, planning or flight; rounds come in order, each once.
  virtual RoundOutput on_round(const RoundInput& input) = 0;
  /// From this round on, if it obeys the operator itself; of several orders of a round the last one stands.
  /// @return whether it does; else one that does goes around it (commanded.hpp)
  virtual bool obey(const Order& /*order*/) { return false; }
  /// Its rounds go on after some that it was left out of, while its vehicle obeyed the operator.
  /// @param stale its peers may have planned without it since
  virtual void resume(bool /*stale*/) {}
  /// Whether it needs not be where it was left to do so.
  [[nodiscard]] virtual bool resumes_anywhere(bool /*stale*/) const { return false; }
  /// All that decides later rounds: mode, plan, sub-swarm, progress.
  virtual void add_to(StateHash& hash) const = 0;
};

/// The behaviour of the mission's kind for one agent. @throws std::invalid_argument if the mission has no such vehicle.
[[nodiscard]] std::unique_ptr<Behaviour> make_behaviour(const Mission& mission, AgentId self);

/// That of an agent that came back after a loss: one that holds its course and shares its map, or where the swarm
/// plans anew under way, one that calls for that.
[[nodiscard]] std::unique_ptr<Behaviour> make_rejoined_behaviour(const Mission& mission, AgentId self);

}  // namespace skein
