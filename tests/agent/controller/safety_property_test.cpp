// What docs/safety.md says, on random cases: at the edge of the inequality, and beyond it; crowds that mean no good.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "agent/controller/safety_filter.hpp"
#include "planner/core/geometry/closest_approach.hpp"
#include "planner/core/geometry/distance.hpp"
#include "planner/core/random/random_stream.hpp"
#include "tests/agent/controller/closed_loop.hpp"

namespace skein {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// A UAV at the speed that the filter allows for a sensor's range, which meets what comes at u from just out of sight,
/// straight at it wherever it goes; the sensor reaches `part` of what the filter believes.
/// @return whether they touch while the UAV moves
bool hit(std::uint64_t n, double part) {
  RandomStream random(6, 0, Purpose::Test, n);
  VehicleSpec spec = test::multirotor_spec(1, random.uniform(0.1, 1.0), random.uniform(2.0, 20.0));
  spec.max_acceleration_mps2 = random.uniform(1.0, 10.0);
  const double dt_s = random.uniform(0.05, 0.5);
  ControllerOptions options;
  options.margin_m = 1e-6;
  options.obstacle_speed_mps = random.uniform(0.0, 10.0);
  const Brakes brakes{spec.max_acceleration_mps2, dt_s};
  const double speed_mps = random.uniform(0.2, 1.0) * spec.speed_mps;
  options.sensor_range_m = spec.radius_m + options.margin_m + stopping_distance_m(brakes, speed_mps) +
                           options.obstacle_speed_mps * stopping_time_s(brakes, speed_mps);
  const SafetyFilter filter(options, spec, dt_s, kFar);
  Track track;
  track.radius_m = random.uniform(0.1, 3.0);
  const double sees_m = part * options.sensor_range_m + track.radius_m;
  VehicleState state{Vec3::Zero(), Vec3(filter.speed_cap_mps(), 0, 0)};
  track.position_m = Vec3(sees_m + 1e-9, 0, 0);
  for (int step = 0; step < 500; ++step) {
    const Vec3 apart_m = state.position_m - track.position_m;
    if (apart_m.norm() > 1e-9) track.velocity_mps = options.obstacle_speed_mps * apart_m.normalized();
    const bool seen = apart_m.norm() <= sees_m;
    const Scene scene{state.position_m, state.velocity_mps, {}, {&track, seen ? 1U : 0U}, {}};
    const VehicleStep next = advance_multirotor(spec, state, filter.pass(scene, Vec3(100, 0, 0)).velocity_mps, dt_s);
    if (state.velocity_mps.isZero(0.0) && next.after.velocity_mps.isZero(0.0)) return false;
    const Vec3 later_m = track.position_m + dt_s * track.velocity_mps;
    for (std::size_t i = 1; i < kMotionPoints; ++i) {
      const double from = static_cast<double>(i - 1) / (kMotionPoints - 1);
      const double to = static_cast<double>(i) / (kMotionPoints - 1);
      const Vec3 a_m = track.position_m + from * (later_m - track.position_m);
      const Vec3 b_m = track.position_m + to * (later_m - track.position_m);
      const double least_m =
          closest_approach(next.motion.points_m[i - 1], next.motion.points_m[i], a_m, b_m).distance_m;
      if (least_m < spec.radius_m + track.radius_m) return true;
    }
    state = next.after;
    track.position_m = later_m;
  }
  return false;
}

TEST(SafetyEdge, NobodyIsHitWhileMovingWithTheSensorOfTheInequality) {
  for (std::uint64_t n = 0; n < 20000; ++n) ASSERT_FALSE(hit(n, 1.0)) << n;
}

TEST(SafetyEdge, WithThreePercentLessSomeAre) {
  int hits = 0;
  for (std::uint64_t n = 0; n < 2000; ++n) hits += hit(n, 0.97) ? 1 : 0;
  EXPECT_GT(hits, 500);
}

struct Walker {
  VehicleSpec spec;
  VehicleState state;
  Vec3 wish_mps = Vec3::Zero();
};

/// Walkers of all sizes that head for each other, among a zone and a fixed track, everything nearer than it should be.
std::vector<Walker> crowd(RandomStream& random, const Track& track, const ZoneShape& zone) {
  std::vector<Walker> walkers;
  while (walkers.size() < 12) {
    Walker w;
    w.spec = test::multirotor_spec(static_cast<AgentId>(walkers.size() + 1), random.uniform(0.2, 1.5));
    w.spec.max_acceleration_mps2 = random.uniform(1.0, 8.0);
    w.state.position_m = Vec3(random.uniform(-15, 15), random.uniform(-15, 15), random.uniform(-4, 4));
    const Vec3& p = w.state.position_m;
    bool clear = (p - track.position_m).norm() > w.spec.radius_m + track.radius_m;
    clear = clear && std::visit([&](const auto& s) { return signed_distance(p, s); }, zone) > w.spec.radius_m;
    for (const Walker& other : walkers) {
      clear = clear && (p - other.state.position_m).norm() > w.spec.radius_m + other.spec.radius_m + 0.01;
    }
    if (clear) walkers.push_back(w);
  }
  return walkers;
}

std::vector<Neighbour> others(const std::vector<Walker>& walkers, std::size_t n) {
  std::vector<Neighbour> found;
  for (std::size_t k = 0; k < walkers.size(); ++k) {
    const Walker& w = walkers[k];
    if (k == n) continue;
    found.push_back(
        {w.spec.id, w.state.position_m, w.state.velocity_mps, w.spec.radius_m, w.spec.max_acceleration_mps2});
  }
  return found;
}

/// One step of all; the least distance between surfaces in it.
double advance(std::vector<Walker>& walkers, const Track& track, const ZoneShape& zone) {
  std::vector<VehicleStep> next;
  for (std::size_t n = 0; n < walkers.size(); ++n) {
    const Walker& w = walkers[n];
    const std::vector<Neighbour> neighbours = others(walkers, n);
    const SafetyFilter filter(ControllerOptions{}, w.spec, 0.1, kFar);
    const Scene scene{w.state.position_m, w.state.velocity_mps, neighbours, {&track, 1}, {&zone, 1}};
    next.push_back(advance_multirotor(w.spec, w.state, filter.pass(scene, w.wish_mps).velocity_mps, 0.1));
  }
  double least_m = kFar;
  for (std::size_t n = 0; n < walkers.size(); ++n) {
    const auto& a = next[n].motion.points_m;
    const double radius_m = walkers[n].spec.radius_m;
    for (std::size_t i = 1; i < kMotionPoints; ++i) {
      least_m = std::min(least_m, point_to_segment(track.position_m, a[i - 1], a[i]) - track.radius_m - radius_m);
      least_m = std::min(
          least_m, std::visit([&](const auto& s) { return signed_distance(a[i - 1], a[i], s); }, zone) - radius_m);
      for (std::size_t k = n + 1; k < walkers.size(); ++k) {
        const auto& b = next[k].motion.points_m;
        least_m = std::min(
            least_m, closest_approach(a[i - 1], a[i], b[i - 1], b[i]).distance_m - radius_m - walkers[k].spec.radius_m);
      }
    }
  }
  for (std::size_t n = 0; n < walkers.size(); ++n) walkers[n].state = next[n].after;
  return least_m;
}

TEST(SafetyCrowd, WhoeverRunsTheFilterTouchesNothingWhateverItWants) {
  Track track;
  track.position_m = Vec3(6, 0, 0);
  track.radius_m = 2.0;
  track.fixed = true;
  const ZoneShape zone = Cylinder{Vec2(-6, 0), 3.0, -2.0, 2.0};
  double flown_m = 0.0;
  for (std::uint64_t round = 0; round < 20; ++round) {
    RandomStream random(7, 0, Purpose::Test, round);
    std::vector<Walker> walkers = crowd(random, track, zone);
    for (int step = 0; step < 400; ++step) {
      for (Walker& w : walkers) {
        if (step % 20 == 0 && random.uniform() < 0.7) {  // at another, at the middle, or anywhere
          const Vec3 target_m = random.uniform() < 0.7 ? walkers[random.below(walkers.size())].state.position_m
                                                       : Vec3(random.uniform(-9, 9), 0, 0);
          w.wish_mps = 10.0 * (target_m - w.state.position_m).stableNormalized();
        }
        flown_m += 0.1 * w.state.velocity_mps.norm();
      }
      ASSERT_GE(advance(walkers, track, zone), 0.0) << "round " << round << " step " << step;
    }
  }
  EXPECT_GT(flown_m, 20000.0);  // of at most 96000: nobody stands for long
}

}  // namespace
}  // namespace skein
