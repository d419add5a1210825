// Options of the transit planners, of the radio and of the obstacle sensors (papers/004), carried typed in the mission.
//
// Every field has a default, a unit and a legal range; the tables list them once, for the scenario loader, the wire and
// the documentation. Source: papers/004, sections III and IV and its appendix; what the paper leaves to its reference
// [10] is a named option here.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "planner/core/options/option_field.hpp"

namespace skein {

struct TransitOptions {
  std::string name = "peach3d";      ///< the planner, by name: one of kTransitPlanners
  double cell_m = 4.0;               ///< edge of a cell's square base
  double cell_height_m = 4.0;        ///< of a level, if the area is higher than one
  double decision_s = 1.0;           ///< between two decisions where to fly; a whole number of flight steps
  double obstacle_potential = 10.0;  ///< alpha of Eq. 2, in cells of goal distance
  double minimum_raise = 0.5;        ///< by which the potential of a local minimum grows, in alphas
  double patience = 40.0;            ///< decisions without progress after which a UAV goes to the back of the order
  double share_maps = 1.0;           ///< 1: obstacle maps go on air; 0: every UAV keeps its own
  double known_line = 1.0;  ///< peach3d-paper, mode 1: 1: the line is free as far as known; 0: as a sensor reaches

  bool operator==(const TransitOptions&) const = default;
};

/// The radio (papers/004, appendix). The default is ideal.
struct RadioOptions {
  double range_m = 1e6;         ///< within which samples are heard
  double bit_rate_bps = 1e12;   ///< of the channel, which all senders share
  double send_period_s = 1.0;   ///< a frame: each UAV has one slot of it for its map
  double loss = 0.0;            ///< probability that one receiver misses one sample
  double latency_rounds = 0.0;  ///< after which a sample is heard, beyond the next round
  double header_bits = 192.0;   ///< of each sample, beside its CDR payload

  bool operator==(const RadioOptions&) const = default;
};

/// What sees obstacles. The default sees all around (papers/004, Fig. 3), without fault.
struct SensorOptions {
  double range_m = 24.0;
  double horizontal_fov_rad = 6.283185307179586;  ///< about the vehicle's heading
  double vertical_fov_rad = 3.141592653589793;    ///< about the horizontal plane
  double period_s = 0.0;                          ///< between two looks; 0: every flight step
  double miss = 0.0;                              ///< probability that a look does not report a cell that it sees
  double false_alarm = 0.0;                       ///< probability that a look takes a free cell for an occupied one

  bool operator==(const SensorOptions&) const = default;
};

inline constexpr std::array<OptionField<TransitOptions>, 8> kTransitFields{{
    {"cell_m", &TransitOptions::cell_m, "m", 0.1, 1000},
    {"cell_height_m", &TransitOptions::cell_height_m, "m", 0.1, 1000},
    {"decision_s", &TransitOptions::decision_s, "s", 1e-3, 60},
    {"obstacle_potential", &TransitOptions::obstacle_potential, "cells", 0, 1e6},
    {"minimum_raise", &TransitOptions::minimum_raise, "", 1e-3, 1e3},
    {"patience", &TransitOptions::patience, "", 1, 1e6},
    {"share_maps", &TransitOptions::share_maps, "", 0, 1},
    {"known_line", &TransitOptions::known_line, "", 0, 1},
}};
inline constexpr std::array<OptionField<RadioOptions>, 6> kRadioFields{{
    {"range_m", &RadioOptions::range_m, "m", 0, 1e6},
    {"bit_rate_bps", &RadioOptions::bit_rate_bps, "bit/s", 1, 1e12},
    {"send_period_s", &RadioOptions::send_period_s, "s", 1e-3, 3600},
    {"loss", &RadioOptions::loss, "", 0, 1},
    {"latency_rounds", &RadioOptions::latency_rounds, "rounds", 0, 1000},
    {"header_bits", &RadioOptions::header_bits, "bit", 0, 1e6},
}};
inline constexpr std::array<OptionField<SensorOptions>, 6> kSensorFields{{
    {"range_m", &SensorOptions::range_m, "m", 0.1, 1e4},
    {"horizontal_fov_rad", &SensorOptions::horizontal_fov_rad, "rad", 0.01, 6.283185307179586},
    {"vertical_fov_rad", &SensorOptions::vertical_fov_rad, "rad", 0.01, 3.141592653589793},
    {"period_s", &SensorOptions::period_s, "s", 0, 3600},
    {"miss", &SensorOptions::miss, "", 0, 0.999},
    {"false_alarm", &SensorOptions::false_alarm, "", 0, 0.5},
}};

/// The planner that has neither cells nor maps: each UAV heads straight for its goal, and its controller does the rest.
inline constexpr std::string_view kStraight = "straight";

/// peach: one of 9 (27) cells a decision. peach3d-paper: waypoints in three modes, as printed. peach3d: complete.
inline constexpr std::array<std::string_view, 4> kTransitPlanners{"peach3d", "peach3d-paper", "peach", kStraight};

/// The options of a planner by name, each at that planner's default, or nothing if there is no such planner.
[[nodiscard]] std::optional<TransitOptions> transit_defaults_of(std::string_view planner);

/// The first fault of the options, or nothing. Checked once, where options enter (scenario, wire, planner).
[[nodiscard]] std::optional<OptionFault> validate(const TransitOptions& options);
[[nodiscard]] std::optional<OptionFault> validate(const RadioOptions& options);
[[nodiscard]] std::optional<OptionFault> validate(const SensorOptions& options);

}  // namespace skein
