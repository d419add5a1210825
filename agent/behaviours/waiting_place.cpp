#include "agent/behaviours/waiting_place.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"
#include "planner/rendezvous/cost/problem.hpp"
#include "planner/rendezvous/replan.hpp"

namespace skein {
namespace {

constexpr double kReserve_m = 0.25;    ///< beyond the planner's distance
constexpr double kSample_m = 0.5;      ///< of a path, and of rings around a place
constexpr double kHardest_part = 0.8;  ///< of what the vehicle can brake
constexpr double kReach_radii = 3.0;   ///< turning radii that should be clear ahead
constexpr int kRings = 60;
constexpr int kDirections = 16;
constexpr int kTries = 4;  ///< places behind that are asked for a way to the slot

struct Chooser {
  const WaitingQuery& query;
  const VehicleSpec& own;

  explicit Chooser(const WaitingQuery& asked) : query(asked), own(vehicle_of(asked.mission, asked.self)) {}

  [[nodiscard]] bool clear(const Vec3& place_m) const {
    const double keep_out_m = own.radius_m + query.mission.planner.clearance_margin_m + kReserve_m;
    return rendezvous::clearance_m(query.mission, query.obstacles, place_m) >= keep_out_m;
  }
  /// In a planar mission everybody stays at the height of its slot, to the bit.
  [[nodiscard]] Vec3 levelled(Vec3 place_m) const {
    if (rendezvous::is_planar(query.mission)) place_m.z() = slot_pose(query.mission, own).position_m.z();
    return place_m;
  }
  [[nodiscard]] std::optional<WaitingPlace> with_way_out(const Vec3& place_m) const {
    const auto departure = rendezvous::best_departure(query.mission, query.self, place_m, query.obstacles);
    if (!departure) return std::nullopt;
    return WaitingPlace{{place_m, departure->heading_rad, 0.0}, departure->length_m, std::nullopt};
  }
  [[nodiscard]] WaitingPlace somehow(const Vec3& place_m) const {
    const double reach_m = kReach_radii / own.max_curvature_per_m;
    const double heading_rad =
        rendezvous::clearest_heading(query.mission, query.self, place_m, query.obstacles, reach_m);
    const double chord_m = (slot_pose(query.mission, own).position_m - place_m).norm();
    return {{place_m, heading_rad, 0.0}, chord_m, std::nullopt};
  }
  [[nodiscard]] WaitingPlace leaving(const Vec3& place_m) const {
    const auto place = with_way_out(place_m);
    return place ? *place : somehow(place_m);
  }
  /// The nearest clear place around, the one itself first.
  [[nodiscard]] Vec3 around(const Vec3& place_m) const {
    for (int ring = 0; ring <= kRings; ++ring) {
      for (int k = 0; k < (ring == 0 ? 1 : kDirections); ++k) {
        const Vec2 aside = kSample_m * ring * direction_of_heading(math::kTwoPi * k / kDirections);
        const Vec3 there_m = place_m + Vec3(aside.x(), aside.y(), 0.0);
        if (clear(there_m)) return there_m;
      }
    }
    return place_m;
  }
};

/// The end of what is clear of a path from one arc length to another; nothing if the beginning is not.
std::optional<double> clear_until(const Chooser& chooser, const FlightPath& path, double from_m, double to_m) {
  std::optional<double> last_m;
  for (double s_m = from_m;; s_m = std::min(to_m, s_m + kSample_m)) {
    if (!chooser.clear(path.position_at(s_m))) return last_m;
    last_m = s_m;
    if (s_m >= to_m) return last_m;
  }
}

/// A clear place of the path at or behind an arc length, if possible one with a way out.
WaitingPlace behind(const Chooser& chooser, const FlightPath& path, double from_m) {
  const double apart_m = 1.0 / chooser.own.max_curvature_per_m;
  std::optional<Vec3> first;
  double next_m = from_m;
  int tries = 0;
  for (double s_m = from_m; s_m >= 0.0 && tries < kTries; s_m -= kSample_m) {
    const Vec3 place_m = chooser.levelled(path.position_at(s_m));
    if (s_m > next_m || !chooser.clear(place_m)) continue;
    if (!first) first = place_m;
    if (const auto place = chooser.with_way_out(place_m)) return *place;
    next_m = s_m - apart_m;
    ++tries;
  }
  return chooser.somehow(first ? *first : chooser.around(chooser.levelled(path.position_at(from_m))));
}

}  // namespace

WaitingPlace place_on_path(const WaitingQuery& query, const FlightPath& path, const MovingReference& reference) {
  const Chooser chooser(query);
  const double length_m = path.length_m();
  const double now_m = reference.travelled_m(length_m, reference.now_s());
  const double speed_mps = reference.speed_mps(length_m, reference.now_s());
  const double usual_mps2 = 0.5 * chooser.own.max_acceleration_mps2;
  const double usual_m = std::min(length_m, now_m + speed_mps * speed_mps / (2.0 * usual_mps2));
  const auto end_m = clear_until(chooser, path, now_m, usual_m);
  if (!end_m) return behind(chooser, path, now_m);
  const double room_m = *end_m - now_m;
  const double hardest_mps2 = kHardest_part * chooser.own.max_acceleration_mps2;
  if (*end_m < usual_m && 2.0 * hardest_mps2 * room_m < speed_mps * speed_mps) {
    return behind(chooser, path, *end_m);
  }
  const double brake_mps2 = *end_m < usual_m && speed_mps > 0.0 ? speed_mps * speed_mps / (2.0 * room_m) : usual_mps2;
  const Vec3 place_m = chooser.levelled(path.position_at(*end_m));
  if (auto place = chooser.with_way_out(place_m)) {
    place->brake_mps2 = brake_mps2;
    return *place;
  }
  return behind(chooser, path, *end_m);
}

WaitingPlace place_off_path(const WaitingQuery& query, const Vec3& position_m, const Vec3& velocity_mps) {
  const Chooser chooser(query);
  const double usual_mps2 = 0.5 * chooser.own.max_acceleration_mps2;
  const Vec3 way_m = velocity_mps * (velocity_mps.norm() / (2.0 * usual_mps2));
  return chooser.leaving(chooser.around(chooser.levelled(position_m + way_m)));
}

double heading_for(const WaitingQuery& query, const Vec3& place_m, double wanted_m) {
  const auto departure = rendezvous::best_departure(query.mission, query.self, place_m, query.obstacles, wanted_m);
  return departure ? departure->heading_rad : Chooser(query).somehow(place_m).pose.heading_rad;
}

}  // namespace skein
