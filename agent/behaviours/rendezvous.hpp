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
// Where something is sensed (controller.sensor_range_m) or plans are made under way (planner.replan), under_way.hpp
// says what it does in flight. One that came back waits for the next plan of the swarm: mode Rejoined on the ground,
// and in flight while its vehicle is not its own. Source: papers/001, sections 2.1 and 3.2.5.
#pragma once

#include "agent/behaviours/behaviour.hpp"
#include "agent/behaviours/under_way.hpp"
#include "agent/controller/moving_reference.hpp"
#include "agent/controller/path_follower.hpp"
#include "planner/rendezvous/planner.hpp"

namespace skein {

class RendezvousBehaviour final : public Behaviour {
 public:
  /// @param rejoined it came back after a loss, and has no plan
  /// @throws std::invalid_argument if the mission has no such vehicle or its options are not legal.
  RendezvousBehaviour(const Mission& mission, AgentId self, bool rejoined = false);

  /// With planner.replan 1 any: which ones count depends on the plan under way, and is sorted out in the round.
  [[nodiscard]] bool can_use(const Representative& peer) const override;
  RoundOutput on_round(const RoundInput& input) override;
  /// Where the swarm plans under way it asks for a new plan if its own is stale.
  void resume(bool stale) override {
    if (stale && replans_ && under_way_) under_way_->drop_plan();
  }
  [[nodiscard]] bool resumes_anywhere(bool stale) const override { return stale && replans_; }
  void add_to(StateHash& hash) const override;

 private:
  /// @param said what it published in the round before
  void plan(const RoundInput& input, const std::optional<Representative>& said);
  void fly(const RoundInput& input);
  void follow(const Sense& sense);

  rendezvous::Planner planner_;
  VehicleType vehicle_;
  bool replans_;
  bool rejoined_;
  bool took_off_ = false;
  PathFollower follower_;      ///< of a constant-speed vehicle
  MovingReference reference_;  ///< of a multirotor
  std::optional<UnderWay> under_way_;
  RoundOutput last_;
};

}  // namespace skein
