// Options of the velocity controller, of the safety filter above it and of the run-time monitor, carried typed in the
// mission.
//
// Every field has a default, a unit and a legal range; kControllerFields lists them once, for the scenario loader, the
// wire and the documentation. Source: papers/002, Eq. 1 to 6, for the shape of the forces; the rest is own
// (docs/safety.md).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "planner/core/options/option_field.hpp"

namespace skein {

struct ControllerOptions {
  std::string name = "apf";     ///< the controller, by name: one of kControllers
  double filter = 1.0;          ///< 1: the safety filter stands above the controller; 0: its wish is flown
  double sensor_range_m = 0.0;  ///< within which what is no cell of a map is seen (Track), by its surface; 0: nothing
  double obstacle_speed_mps = 0.0;  ///< u: what may move is taken to move at most so fast
  double margin_m = 0.25;           ///< kept beyond the radii of bodies
  double horizon_s = 6.0;           ///< how far ahead controller and monitor predict
  double deviation_m = 10.0;        ///< from the moving reference of a plan, beyond which the plan does not hold

  bool operator==(const ControllerOptions&) const = default;
};

inline constexpr std::array<OptionField<ControllerOptions>, 6> kControllerFields{{
    {"filter", &ControllerOptions::filter, "", 0, 1},
    {"sensor_range_m", &ControllerOptions::sensor_range_m, "m", 0, 1e6},
    {"obstacle_speed_mps", &ControllerOptions::obstacle_speed_mps, "m/s", 0, 1000},
    {"margin_m", &ControllerOptions::margin_m, "m", 0, 1e4},
    {"horizon_s", &ControllerOptions::horizon_s, "s", 0, 3600},
    {"deviation_m", &ControllerOptions::deviation_m, "m", 1e-3, 1e6},
}};

/// apf: artificial potential field. orca: optimal reciprocal collision avoidance, the yardstick.
inline constexpr std::array<std::string_view, 2> kControllers{"apf", "orca"};

/// The first fault of the options, or nothing. Checked once, where options enter (scenario, wire).
[[nodiscard]] std::optional<OptionFault> validate(const ControllerOptions& options);

}  // namespace skein
