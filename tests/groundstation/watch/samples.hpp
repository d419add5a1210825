// A small swarm's samples, as an observer reads them: two agents on level flight from (0, 0) and (0, 500) to the east.
#pragma once

#include "groundstation/watch/swarm_watch.hpp"
#include "idl/convert/convert.hpp"

namespace skein::watch {

inline constexpr std::uint64_t kRun = 7;

inline Mission two_fly_east() {
  Mission mission;
  mission.name = "east";
  mission.seed = 3;
  mission.length_unit_m = 1000.0;
  mission.step_s = 0.5;
  mission.arrival_radius_m = 1.0;
  mission.formation.position_m = {10000.0, 0.0, 0.0};
  for (const AgentId id : {1U, 2U}) {
    VehicleSpec vehicle;
    vehicle.id = id;
    vehicle.start.position_m = {0.0, 500.0 * (id - 1), 0.0};
    vehicle.slot_offset_m = {0.0, 500.0 * (id - 1), 0.0};
    vehicle.speed_mps = 50.0;
    vehicle.max_curvature_per_m = 0.002;
    vehicle.radius_m = 2.0;
    vehicle.safety_radius_m = 50.0;
    mission.vehicles.push_back(vehicle);
  }
  return mission;
}

inline Tick tick_at(std::uint32_t round, Phase phase, std::uint32_t step = 0) {
  Tick tick;
  tick.run = kRun;
  tick.round = round;
  tick.phase = phase;
  tick.step = step;
  tick.time_s = 0.5 * step;
  tick.roster = {{1, 1, 11}, {2, 1, 12}};
  return tick;
}

inline Beacon beacon_of(AgentId agent, std::uint32_t round, AgentMode mode, std::uint32_t step = 0,
                        const Vec3& position_m = Vec3::Zero()) {
  Beacon beacon;
  beacon.run = kRun;
  beacon.agent = agent;
  beacon.incarnation = 1;
  beacon.nonce = 10 + agent;
  beacon.round = round;
  beacon.step = step;
  beacon.closes_round = true;
  beacon.mode = mode;
  beacon.pose.position_m = position_m;
  return beacon;
}

/// As published at `stamp_s`.
template <typename Plain>
bus::ObserverInbound at(const Plain& plain, double stamp_s = 0.0) {
  return to_wire(plain, {static_cast<std::int64_t>(stamp_s * 1e9), kRun});
}

inline const AgentView& agent_in(const SwarmView& view, AgentId id) {
  return *std::ranges::find(view.agents, id, &AgentView::id);
}

}  // namespace skein::watch
