// The whole screen as a grid: a pure function of what is known, what was chosen and how large the terminal is.
//
//   +------------------------------------------------------+
//   | swarm, phase, step, time, pace, live, scenario, seed |
//   +---------------------------+--------------------------+
//   | map                       | agents                   |
//   +---------------------------+--------------------------+
//   | events                    | cost by generation       |
//   +---------------------------+--------------------------+
//   | keys                                                 |
//   +------------------------------------------------------+
// Source: none needed. Departs from source: none. Complexity: that of its panels.
#pragma once

#include <string>

#include "groundstation/monitor/controls.hpp"

namespace skein::monitor {

/// What the screen says beside the swarm's figures.
struct Surroundings {
  std::string swarm;
  Symbols symbols = Symbols::Braille;
  std::string notice;  ///< in place of the keys, if not empty: what is wrong
};

/// Smaller than this a terminal shows nothing but that it is too small.
inline constexpr int kLeastWidth = 40;
inline constexpr int kLeastHeight = 12;

[[nodiscard]] Grid draw_screen(const watch::SwarmView& view, const Choices& choices, const Surroundings& surroundings,
                               int width, int height);

}  // namespace skein::monitor
