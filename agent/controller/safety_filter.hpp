// The last word on a command: it is flown only if what it leads to can still be braked off.
//
// Judged is the manoeuvre 'this step towards the command, then full braking to rest' (manoeuvre.hpp), against
//   a fixed thing      distance >= r + m
//   a moving one       distance of the part flown from t_i to t_j >= rho + u t_j, u = max(obstacle_speed_mps, its
//   speed) what is not seen   r + m + length + u time <= sensor_range_m, if anything is sensed at all a neighbour on
//   the own side of the plane between both braking tails, (r + r' + m) / 2 from it peers not heard    length <=
//   (peer_range_m - 2 r - m) / 2
// with own radius r, sum of radii and margin rho, margin m. Who is nearer than that to a fixed thing or a neighbour
// already, by its braking, may come no nearer: so nobody is frozen for ever. Where the wish does not pass, the nearest
// to it in a fan of velocities within reach does; where none passes, the vehicle brakes, which by induction is safe.
// docs/safety.md has the proof, and what it leaves out.
// Source: own. Departs from source: none. Complexity: O(candidates x things within reach).
#pragma once

#include <vector>

#include "agent/controller/manoeuvre.hpp"
#include "agent/controller/scene.hpp"

namespace skein {

class SafetyFilter {
 public:
  /// @param peer_range_m between centres, within which every live peer is heard (infinite: all are); of a peer with a
  /// larger body than the own, less what its radius has more
  /// @pre spec.speed_mps and step_s are positive; of a multirotor max_acceleration_mps2 as well
  SafetyFilter(const ControllerOptions& options, const VehicleSpec& spec, double step_s, double peer_range_m);

  /// The wish (m/s), or what is nearest to it and safe. Only `overruled` and `braking` are set beside the velocity.
  [[nodiscard]] Steering pass(const Scene& scene, const Vec3& wish_mps) const;

  /// Whether a command (m/s) is safe.
  [[nodiscard]] bool safe(const Scene& scene, const Vec3& command_mps) const;

  /// The speed (m/s) that sensor and radio carry: no command above it is safe.
  [[nodiscard]] double speed_cap_mps() const { return cap_mps_; }

 private:
  class Judge;

  [[nodiscard]] bool carried(const Manoeuvre& m) const;
  [[nodiscard]] Vec3 nearest_safe(const Judge& judge, const Scene& scene, const Vec3& v1_mps, bool& found) const;

  ControllerOptions options_;
  Brakes brakes_;
  double radius_m_;
  double speed_mps_;
  double peer_range_m_;
  double cap_mps_;
};

}  // namespace skein
