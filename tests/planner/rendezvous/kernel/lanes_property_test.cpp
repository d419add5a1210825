// Scalar and lanes take the same operations: bit for bit, per candidate and per plan, on every set this machine has.
// SKEIN_PARTICLES and SKEIN_PLANS set how many candidates and plans are compared (default 1000000 and 200)
// in each space.
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "tests/planner/rendezvous/kernel/random_batch.hpp"
#include "tests/planner/rendezvous/layouts.hpp"
#include "tests/planner/rendezvous/swarm_run.hpp"

namespace skein::rendezvous {
namespace {

constexpr std::size_t kPoints = 50;

template <typename Space>
struct Results {
  kernel::LaneTable paths;
  kernel::LaneTable verdicts;
  PointTableIn<Space> points;
  kernel::LaneTable collided;
};

/// Zones, ground and peers across the area of the random paths, drawn anew for every batch.
template <typename Space>
struct Surroundings {
  ProblemIn<Space> problem;
  RuleTableIn<Space> rules;
  PeerTableIn<Space> peers;
};

template <typename Space>
typename Space::Vec random_point(RandomStream& stream) {
  typename Space::Vec point_m;
  for (double& x : point_m) x = stream.uniform(-3e4, 3e4);
  return point_m;
}

/// A mission of the space: any height in the plane, up to some in space, where hills are added.
Mission random_mission(std::uint64_t index, bool in_space, RandomStream& stream) {
  Mission mission = in_space ? test::open_space(index) : test::open_field(index);
  for (int i = 0; i < 2; ++i) {
    const double x = stream.uniform(-20.0, 15.0);
    const double y = stream.uniform(-20.0, 15.0);
    mission.zones.push_back(test::circle_km(stream.uniform(-20.0, 20.0), y, stream.uniform(0.1, 3.0)));
    mission.zones.push_back(test::rectangle_km(x, x + stream.uniform(0.1, 5.0), y, y + stream.uniform(0.1, 5.0)));
    if (!in_space) continue;
    std::get<Cylinder>(mission.zones[mission.zones.size() - 2].shape).z_max_m = stream.uniform(500.0, 8000.0);
    std::get<Box>(mission.zones.back().shape).min_m.z() = stream.uniform(0.0, 5000.0);
  }
  if (in_space && stream.below(2) == 0) mission.terrain = test::layout_space(index).terrain;
  return mission;
}

template <typename Space>
Surroundings<Space> random_surroundings(std::uint64_t index) {
  RandomStream stream(6, 0, Purpose::Test, index);
  ProblemIn<Space> problem = make_problem<Space>(random_mission(index, Space::kSpatial, stream), 1);
  problem.max_curvature_per_m = stream.uniform(1e-4, 5e-3);
  problem.max_torsion_per_m = stream.uniform(1e-4, 5e-3);
  std::vector<PeerPathIn<Space>> peers(stream.below(6));
  for (PeerPathIn<Space>& peer : peers) {
    peer.separation_m = stream.uniform(0.0, 2000.0);
    for (std::size_t k = 0; k < kPoints; ++k) peer.points_m.push_back(random_point<Space>(stream));
  }
  Surroundings<Space> around{problem, RuleTableIn<Space>(problem), {}};
  around.peers.assign(peers, kPoints);
  return around;
}

template <typename Space>
Results<Space> results_of(const kernel::Kernel& kernel, const test::RandomBatch<Space>& batch,
                          const Surroundings<Space>& around) {
  Results<Space> r{{Space::PathRows::Count, batch.lanes},
                   {kernel::Verdicts::Count, batch.lanes},
                   {kPoints, batch.lanes},
                   {1, batch.lanes}};
  const kernel::Steps& steps = Space::steps(kernel);
  steps.interpolate(batch.ends.view(), batch.m.row(0), batch.m.row(1), batch.lanes, r.paths.table());
  steps.judge(r.paths.view(), around.rules.rules(around.problem), batch.lanes, r.verdicts.table());
  steps.walk(r.paths.view(), {kPoints - 1, kPoints}, batch.lanes, r.points.table());
  r.points.pad(batch.lanes);
  steps.meet(r.points.view(), kPoints, batch.lanes, around.peers.peers(), r.collided.row(0));
  return r;
}

bool equal_bits(kernel::ConstTable a, kernel::ConstTable b, std::size_t rows, std::size_t lanes) {
  for (std::size_t r = 0; r < rows; ++r) {
    if (std::memcmp(a.data + r * a.stride, b.data + r * b.stride, lanes * sizeof(double)) != 0) return false;
  }
  return true;
}

template <typename Space>
void expect_equal_bits(const Results<Space>& a, const Results<Space>& b, std::size_t lanes) {
  EXPECT_TRUE(equal_bits(a.paths.view(), b.paths.view(), a.paths.rows(), lanes)) << "paths";
  EXPECT_TRUE(equal_bits(a.verdicts.view(), b.verdicts.view(), a.verdicts.rows(), lanes)) << "verdicts";
  EXPECT_TRUE(equal_bits(a.points.view(), b.points.view(), Space::PathRows::kDimensions * kPoints, lanes)) << "points";
  EXPECT_TRUE(equal_bits(a.collided.view(), b.collided.view(), 1, lanes)) << "collisions";
}

template <typename Space>
class LanesProperty : public testing::Test {};
using Spaces = testing::Types<Planar, Spatial>;
TYPED_TEST_SUITE(LanesProperty, Spaces);

TYPED_TEST(LanesProperty, EveryCandidateIsTheSameBitForBit) {
  const std::uint64_t wanted = test::count_or("SKEIN_PARTICLES", 1000000);
  const auto isas = test::supported_wide_isas();
  ASSERT_FALSE(isas.empty());
  std::array<std::uint64_t, kernel::Verdicts::kConstraints> violations{};
  std::uint64_t collisions = 0;
  std::uint64_t done = 0;
  for (std::uint64_t index = 0; done < wanted; ++index) {
    const std::size_t lanes = 1 + index % 24;
    const auto batch = test::random_batch<TypeParam>(5, index, lanes);
    const auto around = random_surroundings<TypeParam>(index);
    const auto scalar = results_of<TypeParam>(kernel::kernel_of(Isa::Scalar), batch, around);
    for (const Isa isa : isas) {
      expect_equal_bits(scalar, results_of<TypeParam>(kernel::kernel_of(isa), batch, around), lanes);
      ASSERT_FALSE(this->HasFailure()) << name_of(isa) << ", batch " << index;
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      collisions += scalar.collided.row(0)[lane] > 0.0 ? 1U : 0U;
      for (std::size_t r = 0; r < violations.size(); ++r) violations[r] += scalar.verdicts.row(r)[lane] > 0.0 ? 1U : 0U;
    }
    done += lanes;
  }
  EXPECT_GT(collisions, 0U);
  const std::size_t constraints =
      TypeParam::kSpatial ? kernel::Verdicts::kConstraints : kernel::Verdicts::kPlanarConstraints;
  for (std::size_t r = 0; r < constraints; ++r) EXPECT_GT(violations[r], 0U) << "row " << r;
}

/// Hash of all planners after every round of a plan.
std::uint64_t plan_hash(const Mission& mission, Isa isa) {
  StateHash hash;
  const auto add = [&](int, const test::SwarmRun& run) {
    for (const Planner& planner : run.planners) planner.add_to(hash);
  };
  const test::SwarmRun run = test::run_swarm(mission, 200, add, kernel::kernel_of(isa));
  for (const Planner& planner : run.planners) planner.add_to(hash);
  return hash.value();
}

Mission mission_of(Planar, std::uint64_t seed) {
  return seed % 2 == 0 ? test::layout_a(seed) : test::layout_b(seed);
}
Mission mission_of(Spatial, std::uint64_t seed) {
  return test::layout_space(seed);
}

TYPED_TEST(LanesProperty, EveryPlanIsTheSameBitForBit) {
  const std::uint64_t plans = test::count_or("SKEIN_PLANS", 200);
  for (std::uint64_t seed = 0; seed < plans; ++seed) {
    const Mission mission = mission_of(TypeParam{}, seed);
    const std::uint64_t scalar = plan_hash(mission, Isa::Scalar);
    for (const Isa isa : test::supported_wide_isas()) {
      ASSERT_EQ(plan_hash(mission, isa), scalar) << name_of(isa) << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace skein::rendezvous
