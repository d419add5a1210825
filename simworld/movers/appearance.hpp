// How near to a vehicle something may suddenly be there: never so near that the vehicle cannot avoid it any more.
//
// With v the vehicle's speed, dt the step and u the obstacle's speed, the way between the surfaces of the two bodies is
// more than
//   multirotor      S(v) + u T(v)                                     one step's way, then full braking (braking.hpp)
//   holonomic       v dt + u 2 dt                                     it stops at once
//   constant speed  v dt + 2 R + u (dt + pi R / v), R = 1 / kappa     it cannot stop: room for half a circle
// at the moment of appearance, whatever the direction. A constant-speed vehicle has no guarantee: a body on its circle
// may still be hit. Source: the usual braking inequality; docs/safety.md. Departs from source: none. Complexity: O(1).
#pragma once

#include "planner/core/mission/mission.hpp"

namespace skein {

/// The way (m) that a vehicle of that speed (m/s) needs. @pre step_s is positive, and what the vehicle's type has is
/// too
[[nodiscard]] double least_appearance_m(const VehicleSpec& spec, double speed_mps, double obstacle_speed_mps,
                                        double step_s);

}  // namespace skein
