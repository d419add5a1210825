// Zones and announced zones, between plain value and wire.
#pragma once

#include "idl/convert/checker.hpp"

namespace skein {

[[nodiscard]] wire::Area wire_area(const Zone& zone);
/// Of an area that was checked.
[[nodiscard]] Zone plain_zone(const wire::Area& area);
void check_area(Checker& check, const wire::Area& area, std::string_view where);

[[nodiscard]] wire::Announced wire_announced(const Announcement& announced);
[[nodiscard]] Announcement plain_announced(const wire::Announced& announced);

}  // namespace skein
