// The obstacle sensor of one vehicle: which cells one look reports, and as what.
//
// A cell is reported if its nearest point is within range, its centre within the fields of view, and it is in sight
// (simworld/sensing/line_of_sight.hpp); then it is Free or Occupied, as it really is. A vehicle knows of its own cell,
// and of the cells around it whose nearest point is where it is, whatever way it looks. Thus a UAV that sees all around
// knows at least every cell to which it may move next (TruthGrid::may_move), and all of an open space within range.
// Faults: a look leaves out a cell with probability `miss`, and takes a free one for occupied with `false_alarm` (never
// the vehicle's own), drawn for each cell from the stream (seed, agent, Sensor, step * 2^32 + cell). An occupied cell
// is never reported as free.
// Source: papers/004, section IV-B (24 m, all around). Departs from source: occlusion, faults. Complexity: O(cells in
// range * cells between).
#pragma once

#include <cstdint>

#include "planner/core/cells/cell_window.hpp"
#include "simworld/sensing/truth_grid.hpp"

namespace skein {

/// From where, which way and when a vehicle looks.
struct Look {
  AgentId agent = 0;
  std::uint32_t step = 0;  ///< the flight step that it opens
  Vec3 position_m = Vec3::Zero();
  double heading_rad = 0.0;  ///< middle of the horizontal field of view: the direction of the last motion
};

/// Whether a step, from 1, has a look: the first one, and each in which a new period begins; every step if period_s
/// is 0 or less than step_s.
[[nodiscard]] bool looks_at(std::uint32_t step, double step_s, double period_s);

/// What the sensor reports; an empty window if no cell is within range.
[[nodiscard]] CellWindow look(const TruthGrid& truth, const SensorOptions& options, std::uint64_t seed,
                              const Look& from);

}  // namespace skein
