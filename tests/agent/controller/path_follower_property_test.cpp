// The path follower on random Pythagorean-hodograph paths that the vehicle can fly, from a start a few metres off.
#include <gtest/gtest.h>

#include <cmath>

#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/ph/joined_hermite.hpp"
#include "tests/agent/controller/flight.hpp"

namespace skein {
namespace {

using rendezvous::ph::Hermite;
using rendezvous::ph::PlanarPath;

double sampled_curvature_per_m(const PlanarPath& path) {
  double most = 0.0;
  for (int i = 0; i <= 2000; ++i) most = std::max(most, std::fabs(path.curvature(i / 2000.0)));
  return most;
}

/// A path of 6 to 40 km whose curvature stays under a share of what the vehicle can turn.
PlanarPath random_path(RandomStream& random, double share) {
  while (true) {
    const Vec2 end_m(random.uniform(5000.0, 30000.0), random.uniform(-15000.0, 15000.0));
    const double chord_m = end_m.norm();
    const double bearing_rad = std::atan2(end_m.y(), end_m.x());
    const Hermite hermite({Vec2::Zero(), bearing_rad + random.uniform(-1.2, 1.2)},
                          {end_m, bearing_rad + random.uniform(-1.2, 1.2)});
    const PlanarPath path = hermite.path({random.uniform(0.3, 3.0) * chord_m, random.uniform(0.3, 3.0) * chord_m});
    if (sampled_curvature_per_m(path) < share * test::kSpec.max_curvature_per_m) return path;
  }
}

TEST(PathFollowerProperty, ArrivesAtTheEndOfRandomPaths) {
  RandomStream random(31, 1, Purpose::Test, 0);
  for (int i = 0; i < 300; ++i) {
    const PlanarPath path = random_path(random, 0.9);
    const test::Flown flown = test::fly(path, {Vec3::Zero(), path.heading(0.0), 0.0});
    ASSERT_NEAR(flown.steps, path.length_m() / 25.0, 2.0) << i;
    ASSERT_LT(flown.end_error_m, 0.2) << i;
    ASSERT_LT(flown.settled_error_m, 0.5) << i;
    ASSERT_LE(flown.max_curvature_per_m, test::kSpec.max_curvature_per_m * (1.0 + 1e-12)) << i;
  }
}

TEST(PathFollowerProperty, ArrivesAtTheEndOfJoinedSegments) {
  RandomStream random(33, 1, Purpose::Test, 0);
  for (int flights = 0; flights < 100;) {
    const Vec2 end_m(random.uniform(5000.0, 30000.0), random.uniform(-15000.0, 15000.0));
    const double chord_m = end_m.norm();
    const rendezvous::ph::JoinedHermite hermite({Vec2::Zero(), random.uniform(-1.0, 1.0)},
                                                {end_m, random.uniform(-1.0, 1.0)});
    rendezvous::ph::Controls m{random.uniform(0.5, 2.0) * chord_m, random.uniform(0.5, 2.0) * chord_m};
    for (m.interior.size = 0; m.interior.size < 2 * (1 + random.below(3));) {
      m.interior.values[m.interior.size++] = random.uniform(0.5, 2.0) * chord_m;
      m.interior.values[m.interior.size++] = random.uniform(-1.0, 1.0);
    }
    const rendezvous::ph::JoinedPlanarPath path = hermite.path(m);
    if (!curvature_within(path, 0.9 * test::kSpec.max_curvature_per_m)) continue;
    const test::Flown flown = test::fly(path, {Vec3::Zero(), path.heading(0.0), 0.0});
    ASSERT_NEAR(flown.steps, path.length_m() / 25.0, 2.0) << flights;
    ASSERT_LT(flown.end_error_m, 0.2) << flights;
    ASSERT_LT(flown.settled_error_m, 0.5) << flights;
    ++flights;
  }
}

TEST(PathFollowerProperty, ConvergesFromAStartAFewMetresOff) {
  RandomStream random(32, 1, Purpose::Test, 0);
  for (int i = 0; i < 300; ++i) {
    const PlanarPath path = random_path(random, 0.7);
    const Pose start{Vec3(random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0), 0.0),
                     path.heading(0.0) + random.uniform(-0.02, 0.02), 0.0};
    const test::Flown flown = test::fly(path, start);
    ASSERT_LT(flown.settled_error_m, 0.5) << i;
    ASSERT_LT(flown.end_error_m, 0.2) << i;
  }
}

}  // namespace
}  // namespace skein
