#include "tests/agent/behaviours/surprise_run.hpp"

#include <algorithm>

#include "planner/core/random/random_stream.hpp"
#include "tests/agent/behaviours/swarm_flight.hpp"

namespace skein::test {
namespace {

constexpr std::uint32_t kMaxStep = 4000;
/// Of a multirotor that flies 9 m/s until its body touches, braking with 4 m/s2, and a step.
constexpr double kBrakingDistance_m = 9.0 * 9.0 / 8.0 + 1.0;

/// Puts an obstacle on the victim's way, as near as its own braking distance allows, and nobody else's.
bool surprise(SwarmFlight& flight, AgentId victim, RandomStream& stream) {
  for (int tries = 0; tries < 100; ++tries) {
    const double radius_m = stream.uniform(0.5, 4.0);
    const double ahead_m = kBrakingDistance_m + 0.4 + radius_m + stream.uniform(0.0, 8.0);
    const double aside_m = stream.uniform(-0.5, 0.5) * radius_m;
    const VehicleState& state = flight.flyer(victim).state;
    const Vec3 along = state.velocity_mps.normalized();
    const Vec3 place_m = state.position_m + ahead_m * along + aside_m * Vec3(-along.y(), along.x(), 0.0);
    const bool fair = std::ranges::all_of(flight.flyers(), [&](const auto& item) {
      return (item.second.state.position_m - place_m).norm() >= kBrakingDistance_m + 0.4 + radius_m;
    });
    if (!fair) continue;
    flight.put_obstacle(place_m, radius_m);
    return true;
  }
  return false;
}

}  // namespace

Mission random_mission(std::uint64_t seed) {
  Mission mission = surprise_mission(seed);
  RandomStream stream(seed, 0, Purpose::Test, 0);
  for (VehicleSpec& vehicle : mission.vehicles) {
    vehicle.start.position_m.x() += stream.uniform(-30.0, 30.0);
    vehicle.start.position_m.y() += stream.uniform(-30.0, 30.0);
    vehicle.start.heading_rad += stream.uniform(-0.5, 0.5);
  }
  return mission;
}

SurpriseRun run_surprise(std::uint64_t seed, double late) {
  SurpriseRun run;
  const Mission mission = random_mission(seed);
  SwarmFlight flight(mission);
  run.planned = flight.plan();
  if (!run.planned) return run;
  RandomStream stream(seed, 0, Purpose::Test, 1);
  const AgentId victim = static_cast<AgentId>(1 + stream.below(mission.vehicles.size()));
  const double whole_s = flight.flyer(victim).out.planned_length_m / 9.0;
  const auto when = static_cast<std::uint32_t>((0.1 + late * stream.uniform()) * whole_s / mission.step_s);
  flight.fly_until(when);
  if (!surprise(flight, victim, stream)) return run;
  run.surprised = true;
  bool before = false;
  flight.fly_until(kMaxStep, [&] {
    const bool now = flight.anyone(AgentMode::Replanning);
    const auto holds = [](const auto& item) {
      return item.second.out.mode == AgentMode::Flying && item.second.out.safety_reason == SafetyReason::NoPlan;
    };
    if (before && !now) {
      const auto without = std::ranges::count_if(flight.flyers(), holds);
      ++(without > 0 ? run.failures : run.switches);
      const double length_m = flight.flyer(1).out.planned_length_m;
      for (const auto& [id, flyer] : flight.flyers()) {
        run.agreed = run.agreed && std::abs(flyer.out.planned_length_m - length_m) < 1e-6;
      }
      run.agreed = run.agreed && (without == 0 || without == std::ssize(flight.flyers()));
    }
    before = now;
    return flight.all_arrived();
  });
  run.arrived = flight.all_arrived();
  run.together = flight.arrived_together();
  run.least_clearance_m = flight.least_clearance_m();
  run.least_separation_m = flight.least_separation_m();
  run.hash = flight.hash();
  for (const auto& [id, flyer] : flight.flyers()) run.arrivals += std::to_string(flyer.arrival_step) + " ";
  return run;
}

}  // namespace skein::test
