#include "planner/rendezvous/ph/hermite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "planner/core/math/det_math.hpp"

namespace skein::rendezvous::ph {
namespace {

TEST(Hermite, AStraightLineFromUniformSpeed) {
  const Hermite hermite({Vec2(0.0, 0.0), 0.0}, {Vec2(10.0, 0.0), 0.0});
  EXPECT_EQ(hermite.chord_m(), 10.0);
  const PlanarPath path = hermite.path({10.0, 10.0});
  EXPECT_DOUBLE_EQ(path.length_m(), 10.0);
  EXPECT_NEAR(path.speed(0.5), 10.0, 1e-14);
}

TEST(Hermite, CollinearPosesGiveTheChordForEveryControl) {
  const Hermite hermite({Vec2(1.0, 1.0), math::kPi / 4.0}, {Vec2(11.0, 11.0), math::kPi / 4.0});
  for (const double m0 : {2.0, 7.0, 30.0}) EXPECT_NEAR(hermite.length_m({m0, 9.0}), 10.0 * std::sqrt(2.0), 1e-12);
}

TEST(Hermite, MirroredPosesGiveMirroredPaths) {
  const Hermite left({Vec2(0.0, 0.0), 0.5}, {Vec2(10.0, 0.0), -0.3});
  const Hermite right({Vec2(0.0, 0.0), -0.5}, {Vec2(10.0, 0.0), 0.3});
  const PlanarPath a = left.path({8.0, 12.0});
  const PlanarPath b = right.path({8.0, 12.0});
  EXPECT_DOUBLE_EQ(a.length_m(), b.length_m());
  EXPECT_DOUBLE_EQ(a.position(0.4).x(), b.position(0.4).x());
  EXPECT_DOUBLE_EQ(a.position(0.4).y(), -b.position(0.4).y());
  EXPECT_DOUBLE_EQ(a.curvature(0.4), -b.curvature(0.4));
}

TEST(Hermite, BackwardHeadingsTakeTheLeastEnergyOfFour) {
  // Start and end both point back: the path must turn round twice, so a loop or a far swing is unavoidable; the one
  // taken is never worse than the '+ +' solution of the same controls in the chord frame.
  const Hermite hermite({Vec2(0.0, 0.0), 2.6}, {Vec2(10.0, 0.0), 2.6});
  const Controls m{15.0, 15.0};
  const PlanarPath taken = hermite.path(m);
  const Complex w0 = std::sqrt(15.0) * Complex{math::cos(1.3), math::sin(1.3)};
  const Complex radicand = Complex{1200.0, 0.0} - 30.0 * (w0 * w0) + 10.0 * (w0 * w0);
  const Complex w1 = 0.25 * (square_root(radicand) - 6.0 * w0);
  EXPECT_LE(taken.elastic_energy_per_m(), PlanarPath(Vec2::Zero(), {w0, w1, w0}).elastic_energy_per_m());
  EXPECT_NEAR((taken.position(1.0) - Vec2(10.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(math::wrap_angle(taken.heading(1.0) - 2.6), 0.0, 1e-12);
}

TEST(Hermite, CoincidingPositionsAreRefused) {
  EXPECT_THROW(Hermite({Vec2(1.0, 1.0), 0.0}, {Vec2(1.0, 1.0), 1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace skein::rendezvous::ph
