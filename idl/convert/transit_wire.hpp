// A mission's transit part, between plain value and wire. Options travel as values in the order of their tables.
#pragma once

#include "idl/convert/checker.hpp"

namespace skein {

/// @throws std::invalid_argument if a list or text is longer than its bound on the wire.
[[nodiscard]] wire::Crossing wire_transit(const TransitMission& transit);
/// Of a part that was checked.
[[nodiscard]] TransitMission plain_transit(const wire::Crossing& transit);
/// There is one in a mission of kind transit, and in no other; a goal for each vehicle.
void check_transit(Checker& check, const wire::Mission& sample);

}  // namespace skein
