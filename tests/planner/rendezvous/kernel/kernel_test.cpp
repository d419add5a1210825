#include "planner/rendezvous/kernel/kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/planner/rendezvous/kernel/random_batch.hpp"
#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

const kernel::Kernel& scalar() {
  return kernel::kernel_of(Isa::Scalar);
}
const kernel::Steps& steps() {
  return scalar().planar;
}

kernel::LaneTable paths_of(const test::RandomBatch<Planar>& batch) {
  kernel::LaneTable paths(kernel::Paths::Count, batch.lanes);
  steps().interpolate(batch.ends.view(), batch.m.row(0), batch.m.row(1), batch.lanes, paths.table());
  return paths;
}

TEST(Kernel, PathsAreThoseOfHermiteBitForBit) {
  for (std::uint64_t index = 0; index < 400; ++index) {
    const test::RandomBatch<Planar> batch = test::random_batch(1, index, 5);
    const kernel::LaneTable paths = paths_of(batch);
    kernel::LaneTable verdicts(kernel::Verdicts::Count, batch.lanes);
    steps().judge(paths.view(), kernel::Rules{}, batch.lanes, verdicts.table());
    for (std::size_t lane = 0; lane < batch.lanes; ++lane) {
      const ph::PlanarPath path = batch.hermites[lane].path(batch.controls[lane]).pieces()[0];
      EXPECT_EQ(paths.row(kernel::Paths::Length)[lane], path.length_m());
      EXPECT_EQ(verdicts.row(kernel::Verdicts::Energy)[lane], path.elastic_energy_per_m());
      for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_EQ(paths.row(kernel::Paths::Place + k)[lane], path.place_powers(0)[k]);
        EXPECT_EQ(paths.row(kernel::Paths::Place + 5 + k)[lane], path.place_powers(1)[k]);
        EXPECT_EQ(paths.row(kernel::Paths::S + k)[lane], path.profile().arc_powers()[k]);
        EXPECT_EQ(paths.row(kernel::Paths::Speed + k)[lane], path.speed_powers()[k]);
      }
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(paths.row(kernel::Paths::Bend + k)[lane], path.bend()[k]);
    }
  }
}

/// Largest distance (m) of walked points from those of the converged reference.
double worst_miss_m(std::uint64_t batches, std::size_t points, std::uint64_t seed) {
  double worst = 0.0;
  for (std::uint64_t index = 0; index < batches; ++index) {
    const test::RandomBatch<Planar> batch = test::random_batch(seed, index, 8);
    PointTable walked(points, batch.lanes);
    steps().walk(paths_of(batch).view(), {points - 1, points}, batch.lanes, walked.table());
    for (std::size_t lane = 0; lane < batch.lanes; ++lane) {
      const ph::PlanarPath path = batch.hermites[lane].path(batch.controls[lane]).pieces()[0];
      for (std::size_t k = 0; k < points; ++k) {
        const double at_m = path.length_m() * static_cast<double>(k) / static_cast<double>(points - 1);
        worst = std::max(worst, (walked.at(lane, k) - path.position_at(at_m)).norm());
      }
    }
  }
  return worst;
}

TEST(Kernel, WalkedPointsAreThoseOfTheConvergedReference) {
  EXPECT_LT(worst_miss_m(2000, 50, 2), 1e-3);
}
TEST(Kernel, FewAndManyPointsAreAsExact) {
  for (const std::size_t points : {2U, 3U, 7U, 49U, 51U, 401U}) EXPECT_LT(worst_miss_m(40, points, 3), 1e-3) << points;
}

TEST(Kernel, APathWalkedInPartsIsTheSamePath) {
  for (std::uint64_t index = 0; index < 30; ++index) {
    const test::RandomBatch<Planar> batch = test::random_batch(4, index, 1);
    const ph::PlanarPath path = batch.hermites[0].path(batch.controls[0]).pieces()[0];
    for (const std::size_t points : {2U, 9U, 100U, 1000U}) {
      std::vector<Vec2> walked(points);
      walk_in_parts<Planar>(scalar(), path, walked);
      for (std::size_t k = 0; k < points; ++k) {
        const double at_m = path.length_m() * static_cast<double>(k) / static_cast<double>(points - 1);
        ASSERT_NEAR((walked[k] - path.position_at(at_m)).norm(), 0.0, 1e-3) << points << " points, number " << k;
      }
      EXPECT_EQ(walked.back(), path.position(1.0));
    }
  }
}

/// Least distances (m) of the chords between check points to obstacles and to no-fly zones.
std::array<double, 2> chord_distances_m(const Problem& problem, const ph::PlanarPath& path) {
  std::array<double, 2> least{1e9, 1e9};
  const double last = problem.options.check_points - 1;
  for (std::int32_t k = 0; k + 1 < problem.options.check_points; ++k) {
    const Vec2 a = path.position(k / last);
    const Vec2 b = path.position((k + 1) / last);
    for (const PlanarZone& zone : problem.zones) {
      double& of = least[zone.no_fly ? 1 : 0];
      of = std::min(of, distance_m(zone, a, b));
    }
  }
  return least;
}

Zone random_zone(RandomStream& stream) {
  const double x = stream.uniform(0.0, 30.0);
  const double y = stream.uniform(-5.0, 25.0);
  if (stream.below(2) == 0) return test::circle_km(x, y, stream.uniform(0.001, 2.0));
  return test::rectangle_km(x, x + stream.uniform(0.001, 4.0), y, y + stream.uniform(0.001, 4.0));
}

TEST(Kernel, ZonesAreJudgedAsByTheClosedForms) {
  int violating = 0;
  int clear = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 41);
    Mission mission = test::open_field(seed);
    for (int i = 0; i < 3; ++i) mission.zones.push_back(random_zone(stream));
    if (stream.below(2) == 0) mission = test::as_points(mission);
    mission.planner.check_points = stream.below(2) == 0 ? 50 : 13;
    const Problem problem = make_problem(mission, 1 + static_cast<AgentId>(stream.below(3)), scalar());
    const Interval& range = problem.own().range_m;
    Evaluation e;
    evaluate(problem, {stream.uniform(range.min, range.max), stream.uniform(range.min, range.max)}, e);
    const auto least = chord_distances_m(problem, problem.own().hermite.path(e.controls).pieces()[0]);
    for (const auto& [distance, term] : {std::pair(least[0], e.terms.obstacle), std::pair(least[1], e.terms.no_fly)}) {
      if (std::fabs(distance - problem.keep_out_m) < 1e-6) continue;  // a tie, decided by rounding
      EXPECT_EQ(term > 0.0, distance < problem.keep_out_m) << "seed " << seed << ", distance " << distance;
      (term > 0.0 ? violating : clear)++;
    }
  }
  EXPECT_GT(violating, 300);
  EXPECT_GT(clear, 300);
}

TEST(Kernel, CurvatureIsJudgedAtTheCheckPoints) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 42);
    const Problem problem = make_problem(test::open_field(seed), 2, scalar());
    const Interval& range = problem.own().range_m;
    Evaluation e;
    evaluate(problem, {stream.uniform(range.min, range.max), stream.uniform(range.min, range.max)}, e);
    const ph::PlanarPath path = problem.own().hermite.path(e.controls).pieces()[0];
    double largest = 0.0;
    for (int k = 0; k < 50; ++k) largest = std::max(largest, std::fabs(path.curvature(k / 49.0)));
    EXPECT_EQ(e.terms.unflyable > 0.0, largest > problem.max_curvature_per_m) << "seed " << seed;
  }
}

TEST(Kernel, MeetingPeersIsTheSameAsTryingAllPairs) {
  constexpr std::size_t kPoints = 20;
  int met = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 43);
    const std::size_t lanes = 1 + stream.below(20);
    const std::size_t peer_count = stream.below(12);
    PointTable points(kPoints, lanes);
    for (std::size_t k = 0; k < kPoints; ++k) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        points.set(lane, k, {stream.uniform(0.0, 100.0), stream.uniform(0.0, 100.0)});
      }
    }
    points.pad(lanes);
    std::vector<PeerPath> peers(peer_count);
    for (PeerPath& peer : peers) {
      peer.separation_m = stream.uniform(0.0, 5.0);
      for (std::size_t k = 0; k < kPoints; ++k) {
        peer.points_m.emplace_back(stream.uniform(-60.0, 160.0), stream.uniform(-60.0, 160.0));
      }
    }
    PeerTable table;
    table.assign(peers, kPoints);
    kernel::LaneTable collided(1, lanes);
    steps().meet(points.view(), kPoints, lanes, table.peers(), collided.row(0));
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      bool expected = false;
      for (const PeerPath& peer : peers) {
        for (std::size_t k = 0; k < kPoints; ++k) {
          expected |= (points.at(lane, k) - peer.points_m[k]).squaredNorm() < peer.separation_m * peer.separation_m;
        }
      }
      EXPECT_EQ(collided.row(0)[lane], expected ? 1.0 : 0.0) << "seed " << seed;
      met += expected ? 1 : 0;
    }
  }
  EXPECT_GT(met, 100);
}

}  // namespace
}  // namespace skein::rendezvous
