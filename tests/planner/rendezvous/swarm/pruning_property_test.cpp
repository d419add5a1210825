// Costs found out on demand decide as costs that are all found out: the same state after every generation.
// SKEIN_SEEDS sets how many seeds are compared (default 60, fewer under sanitizers).
#include <gtest/gtest.h>

#include "planner/rendezvous/swarm/sub_swarm.hpp"
#include "tests/planner/rendezvous/kernel/random_batch.hpp"
#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

/// All sub-swarms of a mission, cooperating as planners do.
template <typename Space>
class Swarms {
 public:
  Swarms(const Mission& mission, const kernel::Kernel& kernel, Evaluate when, double separation_m)
      : separation_m_(separation_m) {
    for (const VehicleSpec& vehicle : mission.vehicles) {
      problems_.push_back(make_problem<Space>(mission, vehicle.id, kernel));
      swarms_.emplace_back(problems_.back(), when);
    }
  }

  void advance() {
    std::vector<PeerPathIn<Space>> paths;
    double longest_m = 0.0;
    std::size_t reference = 0;
    for (std::size_t i = 0; i < swarms_.size(); ++i) {
      paths.push_back({problems_[i].own().id, separation_m_, swarms_[i].best().points_m});
      if (swarms_[i].own_best().length_m > longest_m) {
        longest_m = swarms_[i].own_best().length_m;
        reference = i;
      }
    }
    for (std::size_t i = 0; i < swarms_.size(); ++i) {
      std::vector<PeerPathIn<Space>> peers = paths;
      peers.erase(peers.begin() + static_cast<std::ptrdiff_t>(i));
      swarms_[i].advance(problems_[i], peers, i == reference ? std::nullopt : std::optional(longest_m));
    }
  }

  [[nodiscard]] std::uint64_t hash() const {
    StateHash hash;
    for (const SubSwarmIn<Space>& swarm : swarms_) swarm.add_to(hash);
    return hash.value();
  }
  [[nodiscard]] bool collides() const {
    return std::ranges::any_of(swarms_,
                               [](const SubSwarmIn<Space>& swarm) { return swarm.best().terms.collision > 0.0; });
  }

 private:
  double separation_m_;
  std::vector<ProblemIn<Space>> problems_;
  std::vector<SubSwarmIn<Space>> swarms_;
};

/// Generations in which some representative collides.
template <typename Space = Planar>
int expect_equal(const Mission& mission, double separation_m) {
  Swarms<Space> plain(mission, kernel::kernel_of(Isa::Scalar), Evaluate::Always, separation_m);
  std::vector<Swarms<Space>> pruned;
  for (const Isa isa : kIsas) {
    if (is_supported(isa)) pruned.emplace_back(mission, kernel::kernel_of(isa), Evaluate::OnDemand, separation_m);
  }
  int colliding = 0;
  for (std::int32_t g = 0; g <= mission.planner.generations; ++g) {
    for (Swarms<Space>& swarms : pruned) EXPECT_EQ(swarms.hash(), plain.hash()) << mission.name << ", generation " << g;
    if (testing::Test::HasFailure()) return colliding;
    colliding += plain.collides() ? 1 : 0;
    plain.advance();
    for (Swarms<Space>& swarms : pruned) swarms.advance();
  }
  return colliding;
}

TEST(PruningProperty, NothingChangesOnTheLayouts) {
  const std::uint64_t seeds = test::count_or("SKEIN_SEEDS", 60);
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    expect_equal(seed % 2 == 0 ? test::layout_a(seed) : test::layout_b(seed), 200.0);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(PruningProperty, NothingChangesInSpace) {
  const std::uint64_t seeds = test::count_or("SKEIN_SEEDS", 60) / 4 + 1;
  int colliding = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    colliding += expect_equal<Spatial>(test::layout_space(seed), 1200.0);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(colliding, 0);
}

TEST(PruningProperty, NothingChangesWhereManyCollide) {
  const std::uint64_t seeds = test::count_or("SKEIN_SEEDS", 60) / 6 + 1;
  int colliding = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    colliding += expect_equal(test::ring(seed, 8, 10000.0, 2000.0), 1400.0);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(colliding, 0);
}

TEST(PruningProperty, NothingChangesWithOddOptions) {
  for (const std::int32_t particles : {2, 3, 9, 25}) {
    for (const double penalty : {1e-3, 1.0, 1e5}) {
      Mission mission = test::ring(7, 5, 10000.0, 2000.0);
      mission.planner.particles = particles;
      mission.planner.penalty = penalty;
      mission.planner.check_points = 20 + particles;
      mission.planner.generations = 20;
      expect_equal(mission, 1000.0);
      ASSERT_FALSE(HasFailure()) << particles << " particles, penalty " << penalty;
    }
  }
}

}  // namespace
}  // namespace skein::rendezvous
