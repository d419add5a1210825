// Transit without maps: each UAV heads straight for its goal, and its controller keeps it clear of all that it senses.
//
//   phase     mode of the round                                    publishes  commands
//   planning  Ready: there is nothing to plan before               nothing    nothing
//   flying    Flying; Arrived; Deadlock: no progress for so long   nothing    the controller's velocity
//   flying    Rejoined, while its vehicle does not obey it         nothing    nothing that counts
//   finished  as before                                            nothing    nothing
// The goal attracts (agent/controller/apf.hpp). It is progress to come `goal_radius_m` nearer than ever; who waits for
// a zone to be confirmed loses no patience. Source: papers/002, Eq. 4. Departs from source: none beyond the
// controller's. Complexity: a step of the controller.
#pragma once

#include "agent/behaviours/behaviour.hpp"
#include "agent/behaviours/surroundings.hpp"
#include "agent/controller/velocity_controller.hpp"

namespace skein {

class StraightBehaviour final : public Behaviour {
 public:
  /// @throws std::invalid_argument if the mission is no straight transit of multirotors, or has no such vehicle.
  StraightBehaviour(const Mission& mission, AgentId self);

  [[nodiscard]] bool can_use(const Representative& /*peer*/) const override { return false; }
  RoundOutput on_round(const RoundInput& input) override;
  [[nodiscard]] bool resumes_anywhere(bool /*stale*/) const override { return true; }
  void add_to(StateHash& hash) const override;

 private:
  void fly(const Tick& tick, const Sense& sense);
  void note_progress(double to_go_m, bool waits);

  VehicleSpec own_;
  Vec3 goal_m_;
  double goal_radius_m_;
  double step_s_;
  ControllerOptions options_;
  double patience_s_;
  Surroundings surroundings_;
  VelocityController controller_;
  double nearest_m_;     ///< distance to the goal at the last progress
  double waited_s_ = 0;  ///< since then
  RoundOutput last_;
};

}  // namespace skein
