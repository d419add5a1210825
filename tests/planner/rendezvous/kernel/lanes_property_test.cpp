// Scalar and lanes take the same operations: bit for bit, per candidate and per plan, on every set this machine has.
// SKEIN_PARTICLES and SKEIN_PLANS set how many candidates and plans are compared (default 1000000 and 200).
#include <gtest/gtest.h>

#include <cstring>

#include "tests/planner/rendezvous/kernel/random_batch.hpp"
#include "tests/planner/rendezvous/layouts.hpp"
#include "tests/planner/rendezvous/swarm_run.hpp"

namespace skein::rendezvous {
namespace {

constexpr std::size_t kPoints = 50;

struct Results {
  kernel::LaneTable paths;
  kernel::LaneTable verdicts;
  PointTable points;
  kernel::LaneTable collided;
};

/// Zones and peers across the area of the random paths, drawn anew for every batch.
struct Surroundings {
  Problem problem;
  PeerTable peers;
};

Surroundings random_surroundings(std::uint64_t index) {
  RandomStream stream(6, 0, Purpose::Test, index);
  Mission mission = test::open_field(index);
  for (int i = 0; i < 2; ++i) {
    const double x = stream.uniform(-20.0, 15.0);
    const double y = stream.uniform(-20.0, 15.0);
    mission.zones.push_back(test::circle_km(stream.uniform(-20.0, 20.0), y, stream.uniform(0.1, 3.0)));
    mission.zones.push_back(test::rectangle_km(x, x + stream.uniform(0.1, 5.0), y, y + stream.uniform(0.1, 5.0)));
  }
  Surroundings around{make_problem(mission, 1), {}};
  around.problem.max_curvature_per_m = stream.uniform(1e-4, 5e-3);
  std::vector<PeerPath> peers(stream.below(6));
  for (PeerPath& peer : peers) {
    peer.separation_m = stream.uniform(0.0, 2000.0);
    for (std::size_t k = 0; k < kPoints; ++k) {
      peer.points_m.emplace_back(stream.uniform(-3e4, 3e4), stream.uniform(-3e4, 3e4));
    }
  }
  around.peers.assign(peers, kPoints);
  return around;
}

Results results_of(const kernel::Kernel& kernel, const test::RandomBatch& batch, const Surroundings& around) {
  Results r{{kernel::Paths::Count, batch.lanes},
            {kernel::Verdicts::Count, batch.lanes},
            {kPoints, batch.lanes},
            {1, batch.lanes}};
  const RuleTable rules(around.problem);
  kernel.interpolate(batch.ends.view(), batch.m.row(0), batch.m.row(1), batch.lanes, r.paths.table());
  kernel.judge(r.paths.view(), rules.rules(), batch.lanes, r.verdicts.table());
  kernel.walk(r.paths.view(), {kPoints - 1, kPoints}, batch.lanes, r.points.x_m.table(), r.points.y_m.table());
  r.points.pad(batch.lanes);
  kernel.meet(r.points.x_m.view(), r.points.y_m.view(), kPoints, batch.lanes, around.peers.peers(), r.collided.row(0));
  return r;
}

bool equal_bits(const kernel::LaneTable& a, const kernel::LaneTable& b, std::size_t lanes) {
  for (std::size_t r = 0; r < a.rows(); ++r) {
    if (std::memcmp(a.row(r), b.row(r), lanes * sizeof(double)) != 0) return false;
  }
  return true;
}

TEST(LanesProperty, EveryCandidateIsTheSameBitForBit) {
  const std::uint64_t wanted = test::count_or("SKEIN_PARTICLES", 1000000);
  const auto isas = test::supported_wide_isas();
  ASSERT_FALSE(isas.empty());
  std::uint64_t violations = 0;
  std::uint64_t done = 0;
  for (std::uint64_t index = 0; done < wanted; ++index) {
    const std::size_t lanes = 1 + index % 24;
    const test::RandomBatch batch = test::random_batch(5, index, lanes);
    const Surroundings around = random_surroundings(index);
    const Results scalar = results_of(kernel::kernel_of(Isa::Scalar), batch, around);
    for (const Isa isa : isas) {
      const Results wide = results_of(kernel::kernel_of(isa), batch, around);
      ASSERT_TRUE(equal_bits(scalar.paths, wide.paths, lanes)) << name_of(isa) << ", batch " << index;
      ASSERT_TRUE(equal_bits(scalar.verdicts, wide.verdicts, lanes)) << name_of(isa) << ", batch " << index;
      ASSERT_TRUE(equal_bits(scalar.points.x_m, wide.points.x_m, lanes)) << name_of(isa) << ", batch " << index;
      ASSERT_TRUE(equal_bits(scalar.points.y_m, wide.points.y_m, lanes)) << name_of(isa) << ", batch " << index;
      ASSERT_TRUE(equal_bits(scalar.collided, wide.collided, lanes)) << name_of(isa) << ", batch " << index;
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) violations += scalar.collided.row(0)[lane] > 0.0 ? 1U : 0U;
    done += lanes;
  }
  EXPECT_GT(violations, 0U);
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

TEST(LanesProperty, EveryPlanIsTheSameBitForBit) {
  const std::uint64_t plans = test::count_or("SKEIN_PLANS", 200);
  for (std::uint64_t seed = 0; seed < plans; ++seed) {
    const Mission mission = seed % 2 == 0 ? test::layout_a(seed) : test::layout_b(seed);
    const std::uint64_t scalar = plan_hash(mission, Isa::Scalar);
    for (const Isa isa : test::supported_wide_isas()) {
      ASSERT_EQ(plan_hash(mission, isa), scalar) << name_of(isa) << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace skein::rendezvous
