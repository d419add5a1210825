// Joined segments on random poses and controls: both poses are met, curvature and direction are continuous across the
// joints, and the whole has the length, points and bounds of its pieces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"
#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/ph/joined_hermite.hpp"

namespace skein::rendezvous::ph {
namespace {

constexpr double kKilometre_m = 1000.0;

/// Controls of n segments, lengths of 0.2 to 4 chords, any direction up to `spread`.
Controls draw_controls(RandomStream& stream, double chord_m, std::size_t per_coefficient, std::size_t n,
                       double spread) {
  Controls m{chord_m * stream.uniform(0.2, 4.0), chord_m * stream.uniform(0.2, 4.0)};
  for (std::size_t j = 0; j + 1 < n; ++j) {
    m.interior.values[m.interior.size++] = chord_m * stream.uniform(0.2, 4.0);
    for (std::size_t a = 1; a < per_coefficient; ++a) {
      m.interior.values[m.interior.size++] = stream.uniform(-spread, spread);
    }
  }
  return m;
}

struct InPlane {
  using Path = JoinedPlanarPath;
  using Vec = Vec2;
  static Path draw(RandomStream& stream, std::size_t n, Vec& end) {
    const PlanarPose from{Vec2(stream.uniform(-2e4, 2e4), stream.uniform(-2e4, 2e4)), stream.uniform(-3.1, 3.1)};
    const PlanarPose to{Vec2(stream.uniform(-2e4, 2e4), stream.uniform(-2e4, 2e4)), stream.uniform(-3.1, 3.1)};
    const JoinedHermite hermite(from, to);
    end = to.position_m;
    const Controls m = draw_controls(stream, hermite.chord_m(), JoinedHermite::kPerCoefficient, n, 2.5);
    const Path path = hermite.path(m);
    EXPECT_NEAR(math::wrap_angle(path.heading(0.0) - from.heading_rad), 0.0, 1e-11);
    EXPECT_NEAR(math::wrap_angle(path.heading(1.0) - to.heading_rad), 0.0, 1e-11);
    EXPECT_NEAR(hermite.length_m(m), path.length_m(), 1e-12 * path.length_m());
    return path;
  }
  /// Poses within 60 degrees of the chord: no part of such a path leads back.
  static std::pair<JoinedHermite, Controls> forward_segment(RandomStream& stream) {
    const JoinedHermite hermite({Vec2(100.0, 200.0), stream.uniform(-1.0, 1.0)},
                                {Vec2(9000.0, 200.0), stream.uniform(-1.0, 1.0)});
    return {hermite, {9000.0 * stream.uniform(0.5, 2.0), 9000.0 * stream.uniform(0.5, 2.0)}};
  }
  static Vec direction(const PlanarPath& piece, double t) { return direction_of_heading(piece.heading(t)); }
};

struct InSpace {
  using Path = JoinedSpatialPath;
  using Vec = Vec3;
  static Path draw(RandomStream& stream, std::size_t n, Vec& end) {
    const auto pose = [&] {
      const Vec3 at(stream.uniform(-2e4, 2e4), stream.uniform(-2e4, 2e4), stream.uniform(0.0, 5e3));
      return Pose{at, stream.uniform(-3.1, 3.1), stream.uniform(-0.8, 0.8)};
    };
    const Pose from = pose();
    const Pose to = pose();
    const SpatialJoinedHermite hermite(from, to);
    end = to.position_m;
    const Controls m = draw_controls(stream, hermite.chord_m(), SpatialJoinedHermite::kPerCoefficient, n, 2.5);
    const Path path = hermite.path(m);
    EXPECT_NEAR((path.direction(0.0) - direction_of(from)).norm(), 0.0, 1e-11);
    EXPECT_NEAR((path.direction(1.0) - direction_of(to)).norm(), 0.0, 1e-11);
    EXPECT_NEAR(hermite.length_m(m), path.length_m(), 1e-12 * path.length_m());
    return path;
  }
  static std::pair<SpatialJoinedHermite, Controls> forward_segment(RandomStream& stream) {
    const SpatialJoinedHermite hermite(
        {Vec3(100.0, 200.0, 0.0), stream.uniform(-1.0, 1.0), stream.uniform(-0.5, 0.5)},
        {Vec3(9000.0, 200.0, 900.0), stream.uniform(-1.0, 1.0), stream.uniform(-0.5, 0.5)});
    return {hermite, {9000.0 * stream.uniform(0.5, 2.0), 9000.0 * stream.uniform(0.5, 2.0)}};
  }
  static Vec direction(const SpatialPath& piece, double t) { return piece.direction(t); }
};

template <typename Space>
class JoinedProperty : public ::testing::Test {
 protected:
  /// Calls `check` with many random paths of 2 to 4 segments and where each must end.
  template <typename Check>
  static void for_all(std::uint64_t seeds, const Check& check) {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      for (std::size_t n = 2; n <= kMaxSegments; ++n) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(n) + " segments");
        RandomStream stream(seed, static_cast<std::uint32_t>(n), Purpose::Test, 60);
        typename Space::Vec end = Space::Vec::Zero();
        const typename Space::Path path = Space::draw(stream, n, end);
        ASSERT_EQ(path.pieces().size(), n);
        check(path, end, stream);
      }
    }
  }
};

using Spaces = ::testing::Types<InPlane, InSpace>;
TYPED_TEST_SUITE(JoinedProperty, Spaces);

TYPED_TEST(JoinedProperty, TheLastPieceEndsInTheSlot) {
  this->for_all(2000, [](const auto& path, const auto& end, RandomStream&) {
    EXPECT_LE((path.position(1.0) - end).norm(), 1e-9 * kKilometre_m);
  });
}

TYPED_TEST(JoinedProperty, CurvatureIsContinuousAcrossTheJoints) {
  this->for_all(2000, [](const auto& path, const auto&, RandomStream&) {
    const auto pieces = path.pieces();
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      EXPECT_EQ(pieces[i + 1].position(0.0), pieces[i].position(1.0));
      const auto turn = TypeParam::direction(pieces[i + 1], 0.0) - TypeParam::direction(pieces[i], 1.0);
      EXPECT_LE(turn.norm(), 1e-9);
      const double before = pieces[i].curvature(1.0) * kKilometre_m;
      const double after = pieces[i + 1].curvature(0.0) * kKilometre_m;
      EXPECT_NEAR(before, after, 1e-9 * std::max(1.0, std::fabs(before)));
    }
  });
}

TYPED_TEST(JoinedProperty, AReshapedSingleSegmentIsTheSamePath) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 62);
    const auto [hermite, m] = TypeParam::forward_segment(stream);
    const auto single = hermite.path(m);
    for (std::size_t n = 2; n <= kMaxSegments; ++n) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(n) + " segments");
      const Controls same = hermite.reshaped(m, n);
      EXPECT_EQ(same, hermite.reshaped(same, n));
      const auto joined = hermite.path(same);
      ASSERT_EQ(joined.pieces().size(), n);
      EXPECT_NEAR(joined.length_m(), single.length_m(), 1e-9 * single.length_m());
      for (const double q : {0.2, 0.5, 0.9}) {
        EXPECT_LE((joined.position(q) - single.position(q)).norm(), 1e-9 * single.length_m());
      }
    }
  }
}

TYPED_TEST(JoinedProperty, PointsDivideTheWholeLength) {
  std::vector<typename TypeParam::Vec> points(50);
  this->for_all(300, [&](const auto& path, const auto&, RandomStream& stream) {
    equidistant_points(path, points);
    const double length_m = path.length_m();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double at_m = length_m * static_cast<double>(k) / 49.0;
      EXPECT_NEAR((points[k] - path.position_at(at_m)).norm(), 0.0, 1e-8 * length_m);
    }
    const double s_m = length_m * stream.uniform();
    EXPECT_NEAR(path.arc_length(path.parameter_at(s_m)), s_m, 1e-9 * length_m);
    EXPECT_NEAR(path.arc_length(path.parameter_at(s_m, stream.uniform())), s_m, 1e-9 * length_m);
    EXPECT_NEAR(path.arc_length(1.0), length_m, 1e-12 * length_m);
  });
}

TYPED_TEST(JoinedProperty, BoundsHoldOverAllPieces) {
  this->for_all(100, [](const auto& path, const auto&, RandomStream&) {
    double largest = 0.0;
    for (int i = 0; i <= 4000; ++i) largest = std::max(largest, std::fabs(path.curvature(i / 4000.0)));
    const double bound = max_curvature_per_m(path);
    EXPECT_GE(bound, largest * (1.0 - 1e-12));
    EXPECT_TRUE(curvature_within(path, bound));
    EXPECT_FALSE(curvature_within(path, 0.999 * largest));
  });
}

TEST(JoinedPropertyInSpace, TorsionBoundHoldsOverAllPieces) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 61);
    Vec3 end = Vec3::Zero();
    const JoinedSpatialPath path = InSpace::draw(stream, 3, end);
    double largest = 0.0;
    for (int i = 0; i <= 4000; ++i) largest = std::max(largest, std::fabs(path.torsion(i / 4000.0)));
    EXPECT_GE(max_torsion_per_m(path), largest * (1.0 - 1e-9)) << "seed " << seed;
    EXPECT_FALSE(torsion_within(path, 0.999 * largest)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace skein::rendezvous::ph
