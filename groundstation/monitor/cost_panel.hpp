// Best cost by generation of the selected agent, as a curve; logarithmic if it spans more than two decades.
//
// Source: none needed. Departs from source: none. Complexity: O(points).
#pragma once

#include "groundstation/monitor/controls.hpp"

namespace skein::monitor {

void draw_costs(Grid& grid, const Area& area, const watch::SwarmView& view, const Choices& choices, Symbols symbols);

}  // namespace skein::monitor
