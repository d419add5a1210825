#include "planner/rendezvous/replan.hpp"

#include <algorithm>
#include <array>

#include "planner/core/geometry/distance.hpp"
#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"
#include "planner/rendezvous/cost/dense_check.hpp"

namespace skein::rendezvous {
namespace {

constexpr double kSeparationReserve = 1.25;
constexpr int kHeadings = 24;
/// m0 and m1 that are tried, in chords.
constexpr std::array<double, 7> kChords{0.25, 0.5, 0.8, 1.2, 1.8, 2.7, 4.0};
/// Of the paths that are not refuted, how many are proved before a UAV gives up.
constexpr int kProofs = 200;

/// The k-th heading: outwards from a wanted one, to both sides in turn.
double heading_number(int k, double wanted_rad) {
  const int away = (k + 1) / 2;
  const double side = k % 2 == 0 ? -1.0 : 1.0;
  return math::wrap_angle(wanted_rad + side * away * math::kTwoPi / kHeadings);
}

double way_to_slot(const Mission& mission, AgentId self, const Vec3& place_m) {
  const Vec3 to_slot = slot_pose(mission, vehicle_of(mission, self)).position_m - place_m;
  return heading_of(to_slot.head<2>());
}

Mission alone(const Mission& mission, AgentId self, const Vec3& place_m, std::span<const Track> obstacles) {
  Revision revision;
  revision.pose.position_m = place_m;
  revision.speed_mps = vehicle_of(mission, self).speed_mps;
  revision.obstacles.assign(obstacles.begin(), obstacles.end());
  const Joiner joiner{self, revision};
  return revised(mission, std::span(&joiner, 1), 0);
}

struct Candidate {
  double length_m;
  int heading;
  double heading_rad;
  ph::Controls controls;
};

template <typename Space>
std::optional<Departure> shortest(Mission mission, AgentId self, double wanted_rad, double wanted_m) {
  std::vector<Candidate> candidates;
  std::vector<ProblemIn<Space>> problems;
  for (int k = 0; k < kHeadings; ++k) {
    const double heading_rad = heading_number(k, wanted_rad);
    mission.vehicles.front().start.heading_rad = heading_rad;
    problems.push_back(make_problem<Space>(mission, self));
    const ParticipantIn<Space>& own = problems.back().own();
    for (const double m0 : kChords) {
      for (const double m1 : kChords) {
        const double chord_m = own.hermite.chord_m();
        const ph::Controls controls{own.range_m.clamp(m0 * chord_m), own.range_m.clamp(m1 * chord_m)};
        candidates.push_back({own.hermite.length_m(controls), k, heading_rad, controls});
      }
    }
  }
  std::ranges::stable_sort(candidates, [&](const Candidate& a, const Candidate& b) {
    const bool a_reaches = a.length_m >= wanted_m;
    const bool b_reaches = b.length_m >= wanted_m;
    if (a_reaches != b_reaches) return a_reaches;
    return a_reaches ? a.length_m < b.length_m : a.length_m > b.length_m;
  });
  int proofs = 0;
  for (const Candidate& candidate : candidates) {
    const ProblemIn<Space>& problem = problems[static_cast<std::size_t>(candidate.heading)];
    const typename Space::Path path = problem.own().hermite.path(candidate.controls);
    if (refute<Space>(problem, path) != Constraint::None) continue;
    if (check_alone(problem, path) == Constraint::None) return Departure{candidate.heading_rad, candidate.length_m};
    if (++proofs == kProofs) break;
  }
  return std::nullopt;
}

}  // namespace

Cylinder column_of(const Track& track) {
  Cylinder column{track.position_m.head<2>(), track.radius_m};
  if (track.column) return column;
  column.z_min_m = track.position_m.z() - track.radius_m;
  column.z_max_m = track.position_m.z() + track.radius_m;
  return column;
}

std::vector<Track> united(std::span<const Joiner> joiners) {
  std::vector<Track> all;
  for (const Joiner& joiner : joiners) {
    for (const Track& track : joiner.revision.obstacles) {
      const auto place = std::ranges::lower_bound(all, track.id, {}, &Track::id);
      if (place == all.end() || place->id != track.id) all.insert(place, track);
    }
  }
  return all;
}

Mission revised(const Mission& mission, std::span<const Joiner> joiners, std::uint32_t attempt) {
  Mission next = mission;
  next.vehicles.clear();
  double least_mps = joiners.front().revision.speed_mps;
  for (const Joiner& joiner : joiners) least_mps = std::min(least_mps, joiner.revision.speed_mps);
  for (const Joiner& joiner : joiners) {
    VehicleSpec vehicle = vehicle_of(mission, joiner.agent);
    vehicle.start = joiner.revision.pose;
    vehicle.speed_mps = least_mps;
    next.vehicles.push_back(vehicle);
  }
  for (const Track& track : united(joiners)) next.zones.push_back({column_of(track), false});
  next.seed = StateHash().add(mission.seed).add(attempt).value();
  return next;
}

Mission with_reserve(const Mission& mission) {
  double factor = kSeparationReserve;
  for (const VehicleSpec& a : mission.vehicles) {
    for (const VehicleSpec& b : mission.vehicles) {
      const double needed_m = a.safety_radius_m + b.safety_radius_m;
      if (a.id >= b.id || needed_m == 0.0) continue;
      const double slots_m = (slot_pose(mission, a).position_m - slot_pose(mission, b).position_m).norm();
      const double starts_m = (a.start.position_m - b.start.position_m).norm();
      factor = std::min(factor, 0.999 * std::min(slots_m, starts_m) / needed_m);
    }
  }
  Mission next = mission;
  for (VehicleSpec& vehicle : next.vehicles) vehicle.safety_radius_m *= std::max(1.0, factor);
  return next;
}

std::optional<Departure> best_departure(const Mission& mission, AgentId self, const Vec3& place_m,
                                        std::span<const Track> obstacles, double wanted_m) {
  const Mission own = alone(mission, self, place_m, obstacles);
  if (slot_pose(own, own.vehicles.front()).position_m == place_m) return std::nullopt;
  const double wanted_rad = way_to_slot(mission, self, place_m);
  return is_planar(own) ? shortest<Planar>(own, self, wanted_rad, wanted_m)
                        : shortest<Spatial>(own, self, wanted_rad, wanted_m);
}

double clearance_m(const Mission& mission, std::span<const Track> obstacles, const Vec3& place_m) {
  double least_m = 1e6;
  for (const Zone& zone : mission.zones) {
    least_m =
        std::min(least_m, std::visit([&](const auto& shape) { return signed_distance(place_m, shape); }, zone.shape));
  }
  for (const Track& track : obstacles) least_m = std::min(least_m, signed_distance(place_m, column_of(track)));
  return least_m;
}

double clearest_heading(const Mission& mission, AgentId self, const Vec3& place_m, std::span<const Track> obstacles,
                        double reach_m) {
  const VehicleSpec& own = vehicle_of(mission, self);
  const double keep_out_m = own.radius_m + mission.planner.clearance_margin_m;
  const double wanted_rad = way_to_slot(mission, self, place_m);
  constexpr int kPieces = 32;
  double best_rad = wanted_rad;
  int most = -1;
  for (int k = 0; k < kHeadings; ++k) {
    const double heading_rad = heading_number(k, wanted_rad);
    const Vec2 along = direction_of_heading(heading_rad);
    int clear = 0;
    while (clear < kPieces) {
      const double ahead_m = reach_m * (clear + 1) / kPieces;
      const Vec3 there_m = place_m + ahead_m * Vec3(along.x(), along.y(), 0.0);
      if (clearance_m(mission, obstacles, there_m) < keep_out_m) break;
      ++clear;
    }
    if (clear <= most) continue;
    most = clear;
    best_rad = heading_rad;
  }
  return best_rad;
}

}  // namespace skein::rendezvous
