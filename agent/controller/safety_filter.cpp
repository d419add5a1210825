#include "agent/controller/safety_filter.hpp"

#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <vector>

#include "agent/controller/fan.hpp"
#include "agent/controller/scratch.hpp"
#include "agent/controller/separation.hpp"
#include "planner/core/geometry/distance.hpp"

namespace skein {
namespace {

/// Above what a manoeuvre can be, for rounding.
constexpr double kRounding_m = 1e-9;

Vec3 level(const Vec3& v) {
  return {v.x(), v.y(), 0.0};
}

double clearance_m(const Vec3& a, const Vec3& b, const ZoneShape& zone) {
  return std::visit([&](const auto& shape) { return signed_distance(a, b, shape); }, zone);
}

}  // namespace

/// What is near in one step, and whether a manoeuvre keeps clear of it.
class SafetyFilter::Judge {
 public:
  Judge(const SafetyFilter& filter, const Scene& scene);
  [[nodiscard]] bool safe(const Manoeuvre& m) const;

 private:
  struct Fixed {
    const ZoneShape* zone = nullptr;  ///< or
    const Track* track = nullptr;
    double keep_m = 0.0;  ///< to its surface, or to its centre
  };
  struct Moving {
    Vec3 position_m;
    double keep_m;     ///< rho
    double speed_mps;  ///< u
    bool column;
  };
  struct Plane {
    Vec3 normal;
    double least_m;  ///< of normal . x
  };

  [[nodiscard]] bool can_meet(const Neighbour& other, double reach_m) const;
  void add(const Neighbour& other, const Segment& tail);
  void add(const Track& track, const Segment& tail, double reach_m, double time_s);
  [[nodiscard]] static double distance_m(const Fixed& thing, const Segment& way);
  [[nodiscard]] static double distance_m(const Fixed& thing, const Manoeuvre& m) {
    return std::min(distance_m(thing, Segment{m.start_m, m.turn_m}) - m.bow_m,
                    distance_m(thing, Segment{m.turn_m, m.end_m}));
  }
  [[nodiscard]] bool clear_of(const Moving& it, const Manoeuvre& m) const;
  [[nodiscard]] bool clear_of(const Moving& it, const Manoeuvre& m, double from, double to) const;
  [[nodiscard]] Vec3 place(const Manoeuvre& m, double step) const {
    return m.turn_m + braked_m(filter_.brakes_, m.speed_mps, step - 1.0) * m.direction;
  }

  const SafetyFilter& filter_;
  const Scene& scene_;
  Scratch scratch_;
  std::pmr::vector<Fixed> fixed_{scratch_.memory()};
  std::pmr::vector<Moving> moving_{scratch_.memory()};
  std::pmr::vector<Plane> planes_{scratch_.memory()};
};

SafetyFilter::Judge::Judge(const SafetyFilter& filter, const Scene& scene) : filter_(filter), scene_(scene) {
  const Brakes& brakes = filter.brakes_;
  const bool inert = brakes.acceleration_mps2 > 0.0;
  const double speed_mps = scene.velocity_mps.norm();
  Segment tail{scene.position_m, scene.position_m};
  if (inert && speed_mps > 0.0) {
    tail.to_m += braking_distance_m(brakes, speed_mps) / speed_mps * scene.velocity_mps;
  }
  const double gain_mps = inert ? brakes.acceleration_mps2 * brakes.step_s : filter.speed_mps_;
  const double fastest_mps = (inert ? speed_mps : 0.0) + gain_mps;
  const double reach_m = stopping_bound_m(brakes, fastest_mps) + kRounding_m;
  const double time_s = stopping_time_s(brakes, fastest_mps) + brakes.step_s;
  planes_.reserve(scene.neighbours.size());
  moving_.reserve(scene.tracks.size());
  for (const ZoneShape& zone : scene.zones) {
    const double keep_m = filter.radius_m_ + filter.options_.margin_m;
    const double here_m = std::visit([&](const auto& shape) { return signed_distance(scene.position_m, shape); }, zone);
    if (here_m > keep_m + reach_m) continue;
    Fixed thing{&zone, nullptr, keep_m};
    thing.keep_m = std::min(keep_m, distance_m(thing, tail));
    fixed_.push_back(thing);
  }
  for (const Track& track : scene.tracks) add(track, tail, reach_m, time_s);
  for (const Neighbour& other : scene.neighbours) {
    if (can_meet(other, reach_m)) add(other, tail);
  }
}

/// Whether the two can come nearer than they may within one step and the braking after it.
bool SafetyFilter::Judge::can_meet(const Neighbour& other, double reach_m) const {
  const Brakes its{other.max_acceleration_mps2, filter_.brakes_.step_s};
  if (its.acceleration_mps2 <= 0.0) return true;  // it may do anything
  const double fastest_mps = other.velocity_mps.norm() + its.acceleration_mps2 * its.step_s;
  const double near_m = reach_m + stopping_bound_m(its, fastest_mps) + filter_.radius_m_ + other.radius_m +
                        filter_.options_.margin_m + kRounding_m;
  return (other.position_m - scene_.position_m).squaredNorm() <= near_m * near_m;
}

void SafetyFilter::Judge::add(const Neighbour& other, const Segment& tail) {
  const double speed_mps = other.velocity_mps.norm();
  Segment its{other.position_m, other.position_m};
  const double its_m = braking_distance_m({other.max_acceleration_mps2, filter_.brakes_.step_s}, speed_mps);
  if (its_m > 0.0) its.to_m += its_m / speed_mps * other.velocity_mps;
  const Separation between = separation(tail, its);
  if (between.half_gap_m > 0.0) {
    const double half_m = 0.5 * (filter_.radius_m_ + other.radius_m + filter_.options_.margin_m);
    planes_.push_back({between.normal, between.offset_m + std::min(half_m, between.half_gap_m)});
  } else {  // one of them has not kept to this: away from it
    const Vec3 away = (tail.from_m - other.position_m).stableNormalized();
    planes_.push_back({away, away.dot(tail.from_m)});
  }
}

void SafetyFilter::Judge::add(const Track& track, const Segment& tail, double reach_m, double time_s) {
  const double rho_m = filter_.radius_m_ + track.radius_m + filter_.options_.margin_m;
  const double u = track.fixed ? 0.0 : std::max(filter_.options_.obstacle_speed_mps, track.velocity_mps.norm());
  const Vec3 apart_m = track.position_m - tail.from_m;
  const double here_m = (track.column ? level(apart_m) : apart_m).norm();
  if (here_m > rho_m + reach_m + u * time_s) return;
  if (track.fixed) {
    Fixed thing{nullptr, &track, rho_m};
    thing.keep_m = std::min(rho_m, distance_m(thing, tail));
    fixed_.push_back(thing);
  } else {
    moving_.push_back({track.column ? level(track.position_m) : track.position_m, rho_m, u, track.column});
  }
}

double SafetyFilter::Judge::distance_m(const Fixed& thing, const Segment& way) {
  if (thing.zone != nullptr) return clearance_m(way.from_m, way.to_m, *thing.zone);
  const Vec3& place_m = thing.track->position_m;
  if (!thing.track->column) return point_to_segment(place_m, way.from_m, way.to_m);
  return point_to_segment(level(place_m), level(way.from_m), level(way.to_m));
}

bool SafetyFilter::Judge::clear_of(const Moving& it, const Manoeuvre& m) const {
  const double dt_s = filter_.brakes_.step_s;
  const Vec3 from_m = it.column ? level(m.start_m) : m.start_m;
  const Vec3 to_m = it.column ? level(m.turn_m) : m.turn_m;
  if (point_to_segment(it.position_m, from_m, to_m) - m.bow_m < it.keep_m + it.speed_mps * dt_s) return false;
  const Vec3 end_m = it.column ? level(m.end_m) : m.end_m;
  if (m.steps > 1.0 && (end_m - it.position_m).norm() < it.keep_m + it.speed_mps * m.steps * dt_s) return false;
  return m.steps <= 1.0 || clear_of(it, m, 1.0, m.steps);
}

/// Of the braking from step `from` to step `to`: first as one piece, then halved as long as that says nothing.
bool SafetyFilter::Judge::clear_of(const Moving& it, const Manoeuvre& m, double from, double to) const {
  const Vec3 begin_m = it.column ? level(place(m, from)) : place(m, from);
  const Vec3 end_m = it.column ? level(place(m, to)) : place(m, to);
  const double due_m = it.keep_m + it.speed_mps * to * filter_.brakes_.step_s;
  if (point_to_segment(it.position_m, begin_m, end_m) >= due_m) return true;
  if (to - from <= 1.0 || (end_m - it.position_m).norm() < due_m) return false;
  const double half = std::floor(0.5 * (from + to));
  return clear_of(it, m, from, half) && clear_of(it, m, half, to);
}

bool SafetyFilter::Judge::safe(const Manoeuvre& m) const {
  if (!filter_.carried(m)) return false;
  for (const Plane& plane : planes_) {
    if (plane.normal.dot(m.turn_m) < plane.least_m || plane.normal.dot(m.end_m) < plane.least_m) return false;
  }
  for (const Moving& it : moving_)
    if (!clear_of(it, m)) return false;
  return std::ranges::all_of(fixed_, [&](const Fixed& thing) { return distance_m(thing, m) >= thing.keep_m; });
}

SafetyFilter::SafetyFilter(const ControllerOptions& options, const VehicleSpec& spec, double step_s,
                           double peer_range_m)
    : options_(options),
      brakes_{spec.type == VehicleType::Multirotor ? spec.max_acceleration_mps2 : 0.0, step_s},
      radius_m_(spec.radius_m),
      speed_mps_(spec.speed_mps),
      peer_range_m_(peer_range_m),
      cap_mps_(spec.speed_mps) {
  const auto fits = [&](double speed_mps) {
    const Vec3 steady(speed_mps, 0.0, 0.0);
    return carried(manoeuvre(brakes_, Vec3::Zero(), steady, steady));
  };
  if (fits(speed_mps_)) return;
  double low_mps = 0.0;
  double high_mps = speed_mps_;
  for (int i = 0; i < 60; ++i) {  // what is carried grows with the speed
    const double middle_mps = 0.5 * (low_mps + high_mps);
    (fits(middle_mps) ? low_mps : high_mps) = middle_mps;
  }
  cap_mps_ = (1.0 - kRounding_m) * low_mps;
}

bool SafetyFilter::carried(const Manoeuvre& m) const {
  if (m.length_m > 0.5 * (peer_range_m_ - 2.0 * radius_m_ - options_.margin_m)) return false;
  if (options_.sensor_range_m <= 0.0) return true;
  const double its_m = options_.obstacle_speed_mps * brakes_.step_s * m.steps;
  return radius_m_ + options_.margin_m + m.length_m + its_m <= options_.sensor_range_m;
}

bool SafetyFilter::safe(const Scene& scene, const Vec3& command_mps) const {
  const Vec3 v1_mps = after_step(brakes_, speed_mps_, scene.velocity_mps, command_mps);
  return Judge(*this, scene).safe(manoeuvre(brakes_, scene.position_m, scene.velocity_mps, v1_mps));
}

Vec3 SafetyFilter::nearest_safe(const Judge& judge, const Scene& scene, const Vec3& v1_mps, bool& found) const {
  const bool inert = brakes_.acceleration_mps2 > 0.0;
  const Vec3 centre_mps = inert ? scene.velocity_mps : Vec3::Zero();
  const double reach_mps = inert ? brakes_.acceleration_mps2 * brakes_.step_s : cap_mps_;
  Vec3 forward = v1_mps - centre_mps;
  if (!(forward.norm() > kRounding_m)) forward = v1_mps.norm() > kRounding_m ? v1_mps : Vec3::UnitX();
  forward.normalize();
  const bool flat = v1_mps.z() == 0.0 && scene.velocity_mps.z() == 0.0;
  Vec3 side(-forward.y(), forward.x(), 0.0);
  if (!(side.norm() > 1e-6)) side = Vec3::UnitY();
  side.normalize();
  const Vec3 up = forward.cross(side);
  Vec3 best = Vec3::Zero();
  double nearest = HUGE_VAL;
  const auto try_one = [&](const Vec3& change_mps) {
    const Vec3 tried_mps = clipped(centre_mps + change_mps, cap_mps_);
    const double off = (tried_mps - v1_mps).squaredNorm();
    if (off >= nearest) return;
    const Vec3 reached_mps = after_step(brakes_, speed_mps_, scene.velocity_mps, tried_mps);
    if (!judge.safe(manoeuvre(brakes_, scene.position_m, scene.velocity_mps, reached_mps))) return;
    nearest = off;
    best = tried_mps;
    found = true;
  };
  const auto try_turned = [&](const Turned& t) {
    try_one(reach_mps * t.size * (t.forward * forward + t.side * side + t.up * up));
  };
  try_one(Vec3::Zero());
  for (const Turned& t : kLevelFan) try_turned(t);
  if (!flat)
    for (const Turned& t : kSteepFan) try_turned(t);
  return best;
}

Steering SafetyFilter::pass(const Scene& scene, const Vec3& wish_mps) const {
  const Vec3 wanted_mps = clipped(wish_mps, cap_mps_);
  const Vec3 v1_mps = after_step(brakes_, speed_mps_, scene.velocity_mps, wanted_mps);
  const Judge judge(*this, scene);
  Steering steering;
  steering.velocity_mps = wanted_mps;
  if (judge.safe(manoeuvre(brakes_, scene.position_m, scene.velocity_mps, v1_mps))) {
    if (wish_mps.norm() <= cap_mps_ || cap_mps_ >= speed_mps_) steering.velocity_mps = wish_mps;
    return steering;
  }
  steering.overruled = true;
  bool found = false;
  steering.velocity_mps = nearest_safe(judge, scene, v1_mps, found);
  steering.braking = !found;
  return steering;
}

}  // namespace skein
