// Keeps what the potential field wants clear of what moves and may turn: in time, not at the last moment.
//
// The safety filter only ever brakes or holds off; a UAV that stands in the way of something is run over. So
//   1. the speed is one from which a vehicle can turn back before what comes at u from the rim of the sensor's range:
//        v <= sqrt(2 a (r - own radius - m - 0.6 tau u)) - u, but not below 0.4 of what the vehicle can do
//   2. nearing a mover is bounded: with d its distance less D_safe and d0 = 0.16 tau u + 0.6 tau |v_o|, n towards it,
//        (v - min(0, v_o . n) n) . n <= sqrt(2 a (d - d0)), or within d0 (d - d0) / 0.2 tau, not below -u:
//      whoever comes is run from as fast as it comes
//   3. if what is left comes nearer than (0.2 to 1, by |v_o| / u) * 0.56 tau u to a mover within H = 2 tau, going
//      straight on after the change of velocity, the velocity of least potential is taken out of a fan,
//        |c - v| + 10 v_max * sum over movers of the largest (1 - gap / reach)^2 (1 - t / 2 H), every H / 8,
//      where the gap shrinks by 0.2 u more, as nobody knows what it does next. A slow wish, v < a * 1 s, is taken to
//      lead no farther than v / (1 - v / a) seconds: it fades out at a goal.
// tau = v_max / a is the time in which the vehicle stops: what the filter lets it do beside a mover grows with u tau.
// With nothing that moves in sight, and no limit from 1, the answer is what was wanted, bit by bit.
// Source: own; the constants are tuned on random scenes (docs/safety.md). Complexity: O(movers), in 3 times fan.
#pragma once

#include "agent/controller/scene.hpp"

namespace skein {

/// @param wanted_mps of the field (m/s). @param level the answer is level, as wanted_mps is
/// @pre spec.speed_mps > 0
[[nodiscard]] Vec3 evading(const ControllerOptions& options, const VehicleSpec& spec, const Scene& scene,
                           const Vec3& wanted_mps, bool level);

/// The bound of 1 (m/s): the vehicle's speed if nothing is sensed or nothing moves; never below 0.4 of that.
[[nodiscard]] double wary_speed_mps(const ControllerOptions& options, const VehicleSpec& spec);

}  // namespace skein
