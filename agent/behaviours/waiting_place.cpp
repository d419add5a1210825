#include "agent/behaviours/waiting_place.hpp"

#include <algorithm>
#include <cmath>

#include "agent/behaviours/plan_check.hpp"
#include "planner/core/geometry/distance.hpp"
#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"
#include "planner/rendezvous/cost/problem.hpp"
#include "planner/rendezvous/replan.hpp"

namespace skein {
namespace {

constexpr double kSlack = 1.02;          ///< of the swarm's length, what a path that can be varied should have
constexpr double kStraightPart = 1.005;  ///< of the distance: a path that cannot
constexpr double kReserve_m = 0.25;      ///< beyond the planner's distance
constexpr double kSample_m = 0.5;        ///< of a path, and of rings around a place
constexpr double kHardest_part = 0.95;   ///< of what the vehicle can brake
constexpr double kReach_radii = 3.0;     ///< turning radii that should be clear ahead
constexpr double kShort = 0.99;          ///< of the swarm's length: enough of it
constexpr int kFarRings = 10;            ///< around a place that is too near to the slot
constexpr double kFarRing_m = 5.0;
constexpr double kMostPerChord = 1.25;  ///< the length of a path of one segment
constexpr int kRings = 60;
constexpr int kDirections = 16;
constexpr int kTries = 6;  ///< places behind that are asked for a way to the slot

struct Chooser {
  const WaitingQuery& query;
  const VehicleSpec& own;

  explicit Chooser(const WaitingQuery& asked) : query(asked), own(vehicle_of(asked.mission, asked.self)) {}

  [[nodiscard]] double keep_out_m() const { return own.radius_m + query.mission.planner.clearance_margin_m; }
  [[nodiscard]] bool clear_of_obstacles(const Vec3& place_m) const {
    return std::ranges::all_of(query.obstacles, [&](const Track& track) {
      return signed_distance(place_m, rendezvous::column_of(track)) >= keep_out_m() + kReserve_m;
    });
  }
  /// Paths pass zones as closely as may be, so that nothing is kept beyond that.
  [[nodiscard]] bool clear(const Vec3& place_m) const {
    return rendezvous::clearance_m(query.mission, {}, place_m) >= keep_out_m() && clear_of_obstacles(place_m);
  }
  /// How much nearer to a peer than allowed, at most; negative: clear of all.
  [[nodiscard]] double too_near_m(const Vec3& place_m) const {
    double most_m = -1e6;
    for (const PeerPlace& peer : query.peers) {
      const double off_m = point_to_segment(place_m, peer.from_m, peer.to_m);
      most_m = std::max(most_m, peer.apart_m + kReserve_m - off_m);
    }
    return most_m;
  }
  [[nodiscard]] bool may_wait(const Vec3& place_m) const { return clear(place_m) && too_near_m(place_m) <= 0.0; }
  /// In a planar mission everybody stays at the height of its slot, to the bit.
  [[nodiscard]] Vec3 levelled(Vec3 place_m) const {
    if (rendezvous::is_planar(query.mission)) place_m.z() = slot_pose(query.mission, own).position_m.z();
    return place_m;
  }
  /// With the heading of a way of one segment, of a length (m) if there is such a one.
  [[nodiscard]] std::optional<WaitingPlace> with_way_out(const Vec3& place_m, double wanted_m = 0.0) const {
    const auto departure = rendezvous::best_departure(query.mission, query.self, place_m, query.obstacles, wanted_m);
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
  [[nodiscard]] WaitingPlace leaving(const Vec3& place_m, double wanted_m = 0.0) const {
    const auto place = with_way_out(place_m, wanted_m);
    return place ? *place : somehow(place_m);
  }
  /// Whether what is to come of a path is blocked.
  [[nodiscard]] bool blocked(const FlightPath& path, double from_m) const {
    return std::ranges::any_of(query.obstacles,
                               [&](const Track& track) { return blocks(path, from_m, track, keep_out_m()); });
  }
  /// A place from which the path is flown on as it is.
  [[nodiscard]] WaitingPlace along(const FlightPath& path, double at_m) const {
    const Vec3 direction = path.direction_at(at_m);
    return {
        {levelled(path.position_at(at_m)), heading_of(direction.head<2>()), 0.0}, path.length_m() - at_m, std::nullopt};
  }
  /// Whether a straight flight comes no nearer to a peer than it is or may be.
  [[nodiscard]] bool passes_peers(const Vec3& from_m, const Vec3& to_m) const {
    const double length_m = (to_m - from_m).norm();
    double before_m = too_near_m(from_m);
    for (double s_m = kSample_m; s_m < length_m; s_m += kSample_m) {
      const double near_m = too_near_m(from_m + s_m / length_m * (to_m - from_m));
      if (near_m > 0.0 && near_m > before_m) return false;
      before_m = near_m;
    }
    return true;
  }
  /// The nearest clear place around, the one itself first.
  [[nodiscard]] Vec3 around(const Vec3& place_m) const {
    for (int ring = 0; ring <= kRings; ++ring) {
      for (int k = 0; k < (ring == 0 ? 1 : kDirections); ++k) {
        const Vec2 aside = kSample_m * ring * direction_of_heading(math::kTwoPi * k / kDirections);
        const Vec3 there_m = place_m + Vec3(aside.x(), aside.y(), 0.0);
        if (may_wait(there_m) && passes_peers(place_m, there_m)) return there_m;
      }
    }
    return place_m;
  }
};

/// The end of what is clear of a path from one arc length to another; nothing if the beginning is not.
std::optional<double> clear_until(const Chooser& chooser, const FlightPath& path, double from_m, double to_m) {
  std::optional<double> last_m;
  for (double s_m = from_m;; s_m = std::min(to_m, s_m + kSample_m)) {
    if (!chooser.clear_of_obstacles(path.position_at(s_m))) return last_m;
    last_m = s_m;
    if (s_m >= to_m) return last_m;
  }
}

/// How far back, at most to an arc length (m), a path leads without coming too near to a peer.
double free_back_to(const Chooser& chooser, const FlightPath& path, double from_m, double to_m) {
  double last_m = from_m;
  double before_m = chooser.too_near_m(path.position_at(from_m));
  for (double s_m = from_m; s_m > to_m;) {
    s_m = std::max(to_m, s_m - kSample_m);
    const double near_m = chooser.too_near_m(path.position_at(s_m));
    if (near_m > 0.0 && near_m > before_m) break;
    before_m = near_m;
    last_m = s_m;
  }
  return last_m;
}

/// A clear place of a blocked path at or behind an arc length, if possible one with a way out of at least a length (m).
WaitingPlace behind(const Chooser& chooser, const FlightPath& path, double from_m, double wanted_m) {
  const double apart_m = 0.5 / chooser.own.max_curvature_per_m;
  std::optional<WaitingPlace> best;
  double next_m = from_m;
  int tries = 0;
  const double least_m = free_back_to(chooser, path, from_m, 0.0);
  for (double s_m = from_m; s_m >= least_m && tries < kTries; s_m -= kSample_m) {
    if (s_m > next_m) continue;
    const Vec3 place_m = chooser.levelled(path.position_at(s_m));
    if (!chooser.may_wait(place_m)) continue;
    WaitingPlace place = chooser.somehow(place_m);
    const auto way = chooser.with_way_out(place_m, wanted_m);
    if (way) place = *way;
    place.stop = WaitingPlace::Stop{0.0, s_m, true};
    if (way && way->to_come_m >= wanted_m) return place;
    if (!best || (way && way->to_come_m > best->to_come_m)) best = place;
    next_m = s_m - apart_m;
    ++tries;
  }
  if (best) return *best;
  return chooser.leaving(chooser.around(chooser.levelled(path.position_at(from_m))), wanted_m);
}

}  // namespace

WaitingPlace place_on_path(const WaitingQuery& query, const FlightPath& path, const MovingReference& reference) {
  const Chooser chooser(query);
  const double length_m = path.length_m();
  const double now_m = reference.travelled_m(length_m, reference.now_s());
  const double speed_mps = reference.brakes() ? 0.0 : reference.speed_mps(length_m, reference.now_s());
  const double usual_mps2 = 0.5 * chooser.own.max_acceleration_mps2;
  const double usual_m =
      reference.brakes() ? reference.rest_m() : std::min(length_m, now_m + speed_mps * speed_mps / (2.0 * usual_mps2));
  const bool ahead = usual_m > now_m && chooser.blocked(path, now_m);
  const double end_m = ahead ? clear_until(chooser, path, now_m, usual_m).value_or(now_m) : usual_m;
  const double hardest_mps2 = kHardest_part * chooser.own.max_acceleration_mps2;
  const double room_m = std::max(end_m - now_m, 1e-3);
  const double brake_mps2 =
      end_m < usual_m ? std::clamp(speed_mps * speed_mps / (2.0 * room_m), usual_mps2, hardest_mps2) : usual_mps2;
  if (chooser.blocked(path, end_m)) {
    WaitingPlace place = behind(chooser, path, end_m, 0.0);  // for its way; where it waits is decided in turn
    place.pose.position_m = chooser.levelled(path.position_at(end_m));
    place.stop = WaitingPlace::Stop{brake_mps2, end_m, true};
    return place;
  }
  WaitingPlace place = chooser.along(path, end_m);
  place.stop = WaitingPlace::Stop{brake_mps2, end_m, false};
  return place;
}

WaitingPlace place_off_path(const WaitingQuery& query, const Vec3& position_m, const Vec3& velocity_mps) {
  const Chooser chooser(query);
  const double usual_mps2 = 0.5 * chooser.own.max_acceleration_mps2;
  const Vec3 way_m = velocity_mps * (velocity_mps.norm() / (2.0 * usual_mps2));
  return chooser.leaving(chooser.around(chooser.levelled(position_m + way_m)));
}

namespace {

/// Whether a straight flight keeps clear of everything.
bool may_cross(const Chooser& chooser, const Vec3& from_m, const Vec3& to_m) {
  const double length_m = (to_m - from_m).norm();
  for (double s_m = kSample_m; s_m < length_m; s_m += kSample_m) {
    if (!chooser.clear(from_m + s_m / length_m * (to_m - from_m))) return false;
  }
  if (!chooser.passes_peers(from_m, to_m)) return false;
  return chooser.may_wait(to_m);
}

/// A place around from which a way of a length (m) leads to the slot, or nothing.
std::optional<WaitingPlace> elsewhere(const Chooser& chooser, const Vec3& from_m, double wanted_m) {
  const Vec3 slot_m = slot_pose(chooser.query.mission, chooser.own).position_m;
  for (int ring = 1; ring <= kFarRings; ++ring) {
    for (int k = 0; k < kDirections; ++k) {
      const Vec2 aside = kFarRing_m * ring * direction_of_heading(math::kTwoPi * k / kDirections);
      const Vec3 there_m = from_m + Vec3(aside.x(), aside.y(), 0.0);
      const double chord_m = (slot_m - there_m).norm();
      if (chord_m > wanted_m || kMostPerChord * chord_m < wanted_m || !may_cross(chooser, from_m, there_m)) continue;
      const auto way = chooser.with_way_out(there_m, wanted_m);
      if (way && way->to_come_m >= wanted_m) return way;
    }
  }
  return std::nullopt;
}

/// On the path that it flew, if it is not blocked, from where the rest of it has the length.
std::optional<WaitingPlace> farther_back(const Chooser& chooser, const WaitingPlace& first, const FlightPath& path,
                                         double length_m) {
  const WaitingPlace::Stop& stop = *first.stop;
  const double chord_m = (path.position_at(path.length_m()) - first.pose.position_m).norm();
  const double wanted_m = first.to_come_m > kStraightPart * chord_m ? kSlack * length_m : length_m;
  const double best_m = std::clamp(path.length_m() - wanted_m, 0.0, stop.at_m);
  const double least_m = free_back_to(chooser, path, stop.at_m, 0.0);
  for (double off_m = 0.0; off_m <= stop.at_m - least_m + kSample_m; off_m += kSample_m) {
    for (const double s_m : {best_m - off_m, best_m + off_m}) {
      if (s_m < least_m || s_m > stop.at_m || chooser.too_near_m(path.position_at(s_m)) > 0.0) continue;
      WaitingPlace place = chooser.along(path, s_m);
      if (place.to_come_m < length_m) {  // a peer is in the way: a longer way may begin with another heading
        if (const auto way = chooser.with_way_out(place.pose.position_m, length_m)) place = *way;
      }
      place.stop = WaitingPlace::Stop{stop.brake_mps2, s_m, false};
      return place;
    }
  }
  return std::nullopt;
}

}  // namespace

WaitingPlace place_for_length(const WaitingQuery& query, const WaitingPlace& first, const FlightPath& path,
                              double length_m) {
  const Chooser chooser(query);
  std::optional<WaitingPlace> place;
  if (first.stop && (first.stop->blocked || chooser.blocked(path, first.stop->at_m))) {  // also by what peers know
    place = behind(chooser, path, first.stop->at_m, length_m);
    if (place->stop) place->stop->brake_mps2 = first.stop->brake_mps2;
  } else if (first.stop) {
    place = farther_back(chooser, first, path, length_m);
  }
  if (!place) place = chooser.leaving(chooser.around(first.pose.position_m), length_m);
  if (place->to_come_m >= kShort * length_m) return *place;
  const auto other = elsewhere(chooser, first.pose.position_m, length_m);
  return other ? *other : *place;
}

}  // namespace skein
