// The one velocity controller of all missions whose vehicles can hover: what the plan wants, kept clear of all that is
// near, and never faster than braking allows.
//
//   wish (of the plan: attraction to a moving reference or to a goal)
//     -> apf or orca (repulsion from neighbours, tracks and zones; mission.controller.name)
//     -> safety filter (mission.controller.filter) -> command
// A pure function of the scene: nothing is remembered from step to step. A vehicle of constant speed gets its wish.
#pragma once

#include "agent/controller/safety_filter.hpp"
#include "agent/controller/scene.hpp"

namespace skein {

class VelocityController {
 public:
  /// @param peer_range_m within which every live peer is heard: beyond it one may be anywhere
  /// @pre spec.speed_mps and step_s are positive; of a multirotor max_acceleration_mps2 as well
  VelocityController(const ControllerOptions& options, const VehicleSpec& spec, double step_s, double peer_range_m)
      : options_(options), spec_(spec), step_s_(step_s), filter_(options, spec, step_s, peer_range_m) {}

  /// The velocity to have at the end of the step. @param wish_mps what the plan wants
  [[nodiscard]] Steering command(const Scene& scene, const Vec3& wish_mps) const;

  /// The speed (m/s) that is ever commanded: the vehicle's, or what its sensor carries if that is less.
  [[nodiscard]] double top_speed_mps() const;

 private:
  ControllerOptions options_;
  VehicleSpec spec_;
  double step_s_;
  SafetyFilter filter_;
};

}  // namespace skein
