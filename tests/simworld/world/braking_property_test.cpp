// Whoever brakes fully from the step on in which it sees what suddenly is there never touches it, whatever the seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "planner/core/random/random_stream.hpp"
#include "simworld/world/world.hpp"
#include "tests/simworld/missions.hpp"

namespace skein {
namespace {

constexpr AgentId kVehicles = 4;

/// Multirotors far apart, of 10 m/s and 4 m/s2, at rest at first.
Mission scattered() {
  std::vector<VehicleSpec> vehicles;
  for (AgentId id = 1; id <= kVehicles; ++id) {
    VehicleSpec spec = test::vehicle(id, {0.0, 2000.0 * id, 50.0}, 0.0, {1e5, 2000.0 * id, 50.0});
    spec.type = VehicleType::Multirotor;
    spec.max_acceleration_mps2 = 4.0;
    vehicles.push_back(spec);
  }
  Mission mission = test::mission_of(std::move(vehicles));
  mission.step_s = 0.1;
  return mission;
}

/// One in front of each vehicle at a drawn time, at a drawn distance, still.
Surprises in_front(RandomStream& stream) {
  Surprises surprises;
  for (AgentId id = 1; id <= kVehicles; ++id) {
    Mover mover;
    mover.name = "sudden_obstacles." + std::to_string(id);
    mover.radius_m = stream.uniform(0.5, 3.0);
    mover.sudden = true;
    mover.column = stream.uniform() < 0.5;
    mover.at_s = stream.uniform(0.0, 6.0);
    mover.ahead = AheadOf{id, stream.uniform(1.0, 25.0)};
    surprises.movers.push_back(mover);
  }
  return surprises;
}

TEST(SuddenObstacles, AreNeverTouchedByWhoBrakesOnSight) {
  const Mission mission = scattered();
  std::size_t seen = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    RandomStream stream(seed, 1, Purpose::Test, 0);
    const double limit_mps = stream.uniform(2.0, 10.0);
    World world(mission, OnAgentLoss::Hover, {}, in_front(stream));
    std::vector<bool> braking(kVehicles + 1);
    std::vector<Vec3> wish_mps(kVehicles + 1, Vec3::Zero());
    for (std::uint32_t step = 1; step <= 150; ++step) {
      std::vector<VehicleCommand> commands;
      for (AgentId id = 1; id <= kVehicles; ++id) {
        braking[id] = braking[id] || !world.tracks_of(id, 60.0).empty();
        Vec3& wish = wish_mps[id];
        if (step % 20 == 1)
          wish = Vec3(stream.uniform(-1, 1), stream.uniform(-1, 1), stream.uniform(-1, 1)) * limit_mps;
        commands.push_back({id, braking[id] ? Vec3(Vec3::Zero()) : wish});
      }
      world.advance(step, commands);
    }
    EXPECT_TRUE(world.contacts().empty()) << "seed " << seed;
    seen += static_cast<std::size_t>(std::ranges::count(braking, true));
  }
  EXPECT_GT(seen, 600U) << "of 1200";
}

}  // namespace
}  // namespace skein
