// Formation rendezvous: plan with the peers, then fly the path and arrive with them.
//
//   phase     mode of the round                        publishes            commands
//   planning  Planning, until the swarm agrees         representative       nothing
//   planning  Ready: all live agents hold a clear      representative       nothing
//             path of one common length
//   planning  Failed: names the constraint             representative       nothing
//   flying    Flying, until the path is flown          nothing              velocity along the path
//   flying    Arrived                                  nothing              straight on; multirotor: hover
//   finished  as before                                nothing              nothing
// Source: papers/001, sections 2.1 and 3.2.5.
#pragma once

#include "agent/behaviours/behaviour.hpp"
#include "agent/controller/moving_reference.hpp"
#include "agent/controller/path_follower.hpp"
#include "planner/rendezvous/planner.hpp"

namespace skein {

class RendezvousBehaviour final : public Behaviour {
 public:
  /// @throws std::invalid_argument if the mission has no such vehicle or its options are not legal.
  RendezvousBehaviour(const Mission& mission, AgentId self);

  [[nodiscard]] bool can_use(const Representative& peer) const override { return planner_.can_use(peer); }
  RoundOutput on_round(const RoundInput& input) override;
  void add_to(StateHash& hash) const override;

 private:
  void plan(const RoundInput& input);
  void fly(const Sense& sense);

  rendezvous::Planner planner_;
  VehicleType vehicle_;
  PathFollower follower_;      ///< of a constant-speed vehicle
  MovingReference reference_;  ///< of a multirotor
  RoundOutput last_;
};

}  // namespace skein
