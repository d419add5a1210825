// The table of agents: one row each, as many columns as there is room for, the most useful first.
//
// Source: none needed. Departs from source: none. Complexity: O(rows x columns).
#pragma once

#include "groundstation/monitor/controls.hpp"

namespace skein::monitor {

/// Scrolls so that the selected agent is on it, and says how many are not.
void draw_agents(Grid& grid, const Area& area, const watch::SwarmView& view, const Choices& choices);

}  // namespace skein::monitor
