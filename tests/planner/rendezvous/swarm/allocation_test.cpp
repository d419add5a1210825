// Only a replaced operator new can prove this: a generation of a sub-swarm allocates nothing once it is warm.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "planner/rendezvous/swarm/genetic_population.hpp"
#include "planner/rendezvous/swarm/sub_swarm.hpp"
#include "tests/planner/rendezvous/kernel/random_batch.hpp"
#include "tests/planner/rendezvous/layouts.hpp"

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = nullptr;
  if (posix_memalign(&memory, alignment < sizeof(void*) ? sizeof(void*) : alignment, size == 0 ? 1 : size) != 0) {
    throw std::bad_alloc();
  }
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace skein::rendezvous {
namespace {

/// Representatives of two peers, shifted so that they meet the own path here and there.
template <typename Space>
std::vector<PeerPathIn<Space>> two_peers(const SubSwarmIn<Space>& swarm) {
  std::vector<PeerPathIn<Space>> peers{{2, 200.0, swarm.best().points_m}, {3, 200.0, swarm.best().points_m}};
  for (auto& point : peers[0].points_m) point.template head<2>() += Vec2(150.0, 3000.0);
  for (auto& point : peers[1].points_m) point.template head<2>() += Vec2(-50.0, 100.0);
  return peers;
}

template <typename Space>
void expect_none(const Mission& mission) {
  for (const Evaluate when : {Evaluate::OnDemand, Evaluate::Always}) {
    for (const Isa isa : kIsas) {
      if (!is_supported(isa)) continue;
      const auto problem = make_problem<Space>(mission, 1, kernel::kernel_of(isa));
      SubSwarmIn<Space> swarm(problem, when);
      const auto peers = two_peers(swarm);
      swarm.advance(problem, peers, 35000.0);
      const long before = allocations;
      for (int g = 0; g < 49; ++g) {
        swarm.advance(problem, peers, g % 2 == 0 ? std::optional(35000.0 + g) : std::nullopt);
      }
      EXPECT_EQ(allocations - before, 0) << name_of(isa);
      EXPECT_EQ(swarm.generation(), 50);
    }
  }
}

TEST(Allocation, AGenerationNeedsNone) {
  expect_none<Planar>(test::layout_a(3));
  expect_none<Spatial>(test::layout_space(3));
}

/// Generations as a planner runs them: representatives that move, the sub-swarm or population among them.
template <typename Search>
void expect_none_following(const Problem& problem) {
  Search search(problem);
  std::vector<Representative> peers(2);
  for (std::size_t i = 0; i < 2; ++i) {
    peers[i].agent = static_cast<AgentId>(i + 2);
    peers[i].particle = {9000.0, 8000.0};
  }
  PeerTable table;
  long before = 0;
  for (int g = 0; g < 40; ++g) {
    if (g == 4) before = allocations;  // warm: every branch of the table was taken
    peers[0].particle[0] += 10.0;
    if (g % 2 == 0) peers[1].particle[1] += 10.0;
    table.follow(problem, peers);
    search.advance(problem, table.peers(), 35000.0);
  }
  EXPECT_EQ(allocations - before, 0);
}

TEST(Allocation, NorDoPeersThatMove) {
  expect_none_following<SubSwarm>(make_problem(test::layout_a(3), 1));
  expect_none_following<GeneticPopulation>(make_problem(test::layout_a(3), 1));
}

TEST(Allocation, TheCounterCounts) {
  const long before = allocations;
  const std::vector<double> numbers(100, 1.0);
  EXPECT_EQ(allocations - before, 1);
  EXPECT_EQ(numbers.size(), 100U);
}

}  // namespace
}  // namespace skein::rendezvous
