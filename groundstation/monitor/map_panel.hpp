// The map: cells that the swarm has mapped, zones, radio links, plans, flown trails, goals and vehicles.
//
//   zones     outlines; no-fly ones and announced ones dotted    mapped cells   occupied ones full, free ones sparse
//   plans     dotted lines     trails   full lines               goals x, vehicles by number
// Source: none needed. Departs from source: none. Complexity: O(dots + points + cells).
#pragma once

#include "groundstation/monitor/controls.hpp"

namespace skein::monitor {

/// The style of an agent in all panels.
[[nodiscard]] Style style_of(AgentId agent);

void draw_map(Grid& grid, const Area& area, const watch::SwarmView& view, const Choices& choices, Symbols symbols);

}  // namespace skein::monitor
