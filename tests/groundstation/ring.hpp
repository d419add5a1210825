// A swarm on a ring, whose paths all tend to cross: starts 10 km from the centre, each slot opposite its start, 2 km
// from it, start headings turned 1 rad from the centre.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <string>

namespace skein::test {

/// The scenario's text. @param on_agent_loss of the vehicles: remove, hover, continue
inline std::string ring_yaml(unsigned count, const std::string& on_agent_loss = "remove") {
  constexpr double kTurn_rad = 6.283185307179586;
  std::string starts;
  std::string slots;
  for (unsigned id = 1; id <= count; ++id) {
    const double angle_rad = kTurn_rad * (id - 1) / count;
    const double x = std::cos(angle_rad);
    const double y = std::sin(angle_rad);
    const double heading_rad = std::remainder(angle_rad + kTurn_rad / 2.0 + 1.0, kTurn_rad);
    starts += fmt::format("    - {{id: {}, x_m: {:.3f}, y_m: {:.3f}, heading_rad: {:.6f}}}\n", id, 1e4 * x, 1e4 * y,
                          heading_rad);
    slots += fmt::format("    - {{id: {}, x_m: {:.3f}, y_m: {:.3f}}}\n", id, -2e3 * x, -2e3 * y);
  }
  return fmt::format(
      "name: ring\nkind: rendezvous\nseed: 1\nlength_unit_m: 1000\nstep_s: 1\narrival_radius_m: 1\n"
      "vehicles:\n  type: constant_speed\n  speed_mps: 50\n  max_curvature_per_m: 0.002\n  radius_m: 2\n"
      "  safety_radius_m: 100\n  on_agent_loss: {}\n  starts:\n{}"
      "formation:\n  x_m: 0\n  y_m: 0\n  heading_rad: 0\n  slots:\n{}"
      "planner:\n  generations: 25\n",
      on_agent_loss, starts, slots);
}

}  // namespace skein::test
