// Options of the rendezvous planners (papers/001), carried typed in the mission.
//
// Every field has a default, a unit and a legal range; `kRendezvousFields` lists them once, for the scenario loader,
// the wire check and the documentation. A planner's name chooses its search and the defaults of its other options
// (`defaults_of`); each of these may be set to another value. Source: papers/001, section 4.1 (M, T, w1, Np, Nph) and
// Eq. 8-16. Departs from source: search range in chords, velocity limit, re-initialisation and equalisation, which the
// paper leaves open (docs/families/rendezvous.md).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "planner/core/options/option_field.hpp"

namespace skein {

struct RendezvousOptions {
  std::string name = "dcpso";             ///< the planner, by name: one of kRendezvousPlanners
  std::int32_t particles = 20;            ///< M, particles of a sub-swarm
  std::int32_t generations = 50;          ///< T
  double length_weight = 0.5;             ///< w1 of Eq. 11, in [0, 1]
  double inertia_start = 0.9;             ///< omega_start of Eq. 10
  double inertia_end = 0.4;               ///< omega_end of Eq. 10
  double cognitive = 2.0;                 ///< c1 of Eq. 8
  double social = 2.0;                    ///< c2 of Eq. 8
  double search_min_chords = 0.03;        ///< lower bound of m0, m1, in lengths of the chord from start to slot
  double search_max_chords = 6.0;         ///< upper bound of m0, m1, in chords
  double velocity_limit = 0.1;            ///< Vmax as a fraction of the search range
  double reinitialise_probability = 0.1;  ///< of each particle in each generation
  std::int32_t check_points = 50;         ///< Np = Nph, points of a path at which constraints are checked in the search
  std::int32_t dense_points = 1000;       ///< points of a path at which the final path is checked again
  double penalty = 1e5;                   ///< cost of each violated constraint (Eq. 11, 12, 15); more than 0
  double length_penalty = 100.0;          ///< factor of |L - Lref|^2 in Eq. 16, per length unit
  double clearance_margin_m = 5.0;        ///< kept from obstacles and no-fly zones beyond the vehicle's radius
  std::int32_t equalise_directions = 64;  ///< directions of (m0, m1) tried to reach the common length (Remark 3)
  std::int32_t equalise_rounds = 40;      ///< rounds within which the swarm must agree on the common length
  std::int32_t cooperate = 1;             ///< 1: the penalties of Eq. 15 and 16 count; 0: every UAV for itself
  std::int32_t own_reference = 1;         ///< Lref of Eq. 16: 1 of the bests by own cost, 0 of the representatives
  std::int32_t refresh_costs = 1;         ///< 1: stored costs follow the representatives; 0: as when they were stored
  std::int32_t equalise = 1;              ///< 1: exactly one length in the end; 0: the search's own lengths are flown
  double length_tolerance_m = 350.0;      ///< largest difference of lengths of a plan that counts as a success
  double crossover_probability = 0.9;     ///< of each pair of parents (ccga)
  double mutation_probability = 0.1;      ///< of each of m0 and m1 of each child (ccga)
  std::int32_t max_segments = 4;          ///< joined segments of a path at most (Remark 4), if fewer find no plan
  std::int32_t replan = 0;                ///< 1: the swarm plans anew under way when a plan does not hold
  std::int32_t rounds_per_step = 10;      ///< planning rounds of a flight step while it does

  bool operator==(const RendezvousOptions&) const = default;
};

/// One option: its key in a scenario, its place, its unit ("" for none) and its closed legal range.
struct RendezvousField {
  std::string_view key;
  std::variant<double RendezvousOptions::*, std::int32_t RendezvousOptions::*> member;
  std::string_view unit;
  double min;
  double max;
};

inline constexpr std::array<RendezvousField, 28> kRendezvousFields{{
    {"particles", &RendezvousOptions::particles, "", 2, 10000},
    {"generations", &RendezvousOptions::generations, "", 1, 10000},
    {"length_weight", &RendezvousOptions::length_weight, "", 0, 1},
    {"inertia_start", &RendezvousOptions::inertia_start, "", 0, 2},
    {"inertia_end", &RendezvousOptions::inertia_end, "", 0, 2},
    {"cognitive", &RendezvousOptions::cognitive, "", 0, 10},
    {"social", &RendezvousOptions::social, "", 0, 10},
    {"search_min_chords", &RendezvousOptions::search_min_chords, "chords", 1e-6, 100},
    {"search_max_chords", &RendezvousOptions::search_max_chords, "chords", 1e-6, 100},
    {"velocity_limit", &RendezvousOptions::velocity_limit, "", 1e-6, 1},
    {"reinitialise_probability", &RendezvousOptions::reinitialise_probability, "", 0, 1},
    {"check_points", &RendezvousOptions::check_points, "", 3, 1000},
    {"dense_points", &RendezvousOptions::dense_points, "", 100, 100000},
    {"penalty", &RendezvousOptions::penalty, "", 1e-3, 1e12},
    {"length_penalty", &RendezvousOptions::length_penalty, "", 0, 1e12},
    {"clearance_margin_m", &RendezvousOptions::clearance_margin_m, "m", 0, 1e6},
    {"equalise_directions", &RendezvousOptions::equalise_directions, "", 4, 4096},
    {"equalise_rounds", &RendezvousOptions::equalise_rounds, "", 1, 1000},
    {"cooperate", &RendezvousOptions::cooperate, "", 0, 1},
    {"own_reference", &RendezvousOptions::own_reference, "", 0, 1},
    {"refresh_costs", &RendezvousOptions::refresh_costs, "", 0, 1},
    {"equalise", &RendezvousOptions::equalise, "", 0, 1},
    {"length_tolerance_m", &RendezvousOptions::length_tolerance_m, "m", 0, 1e9},
    {"crossover_probability", &RendezvousOptions::crossover_probability, "", 0, 1},
    {"mutation_probability", &RendezvousOptions::mutation_probability, "", 0, 1},
    {"max_segments", &RendezvousOptions::max_segments, "", 1, 4},
    {"replan", &RendezvousOptions::replan, "", 0, 1},
    {"rounds_per_step", &RendezvousOptions::rounds_per_step, "", 1, 1000},
}};
/// The first fields, which every mission hash holds; a later one enters it where it differs from its default, so that
/// a new option leaves the hashes of missions without it as they were.
inline constexpr std::size_t kAlwaysHashedFields = 18;

/// dcpso: the paper's method with exact lengths. dcpso-paper: as printed. dcpso-solo: without cooperation. ccga: a
/// conventional cooperative co-evolutionary genetic algorithm.
inline constexpr std::array<std::string_view, 4> kRendezvousPlanners{"dcpso", "dcpso-paper", "dcpso-solo", "ccga"};

/// The options of a planner by name, each at that planner's default, or nothing if there is no such planner.
[[nodiscard]] std::optional<RendezvousOptions> defaults_of(std::string_view planner);

/// The first fault of the options, or nothing. Checked once, where options enter (scenario, wire, planner).
[[nodiscard]] std::optional<OptionFault> validate(const RendezvousOptions& options);

}  // namespace skein
