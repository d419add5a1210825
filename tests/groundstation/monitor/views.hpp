// A view of a swarm of N agents in a row, each 1 km on its way of 2 km to the north.
#pragma once

#include "groundstation/watch/view.hpp"

namespace skein::monitor {

inline watch::SwarmView row_of(AgentId agents) {
  watch::SwarmView view;
  view.heard_tick = true;
  view.phase = Phase::Flying;
  view.step = 40;
  view.round = 95;
  view.time_s = 20.0;
  view.times_real_time = 1.0;
  view.live = agents;
  view.mission = Mission{};
  view.mission->name = "row";
  view.mission->seed = 5;
  for (AgentId id = 1; id <= agents; ++id) {
    const double x_m = 200.0 * id;
    VehicleSpec vehicle;
    vehicle.id = id;
    vehicle.start.position_m = {x_m, 0.0, 100.0};
    view.mission->vehicles.push_back(vehicle);
    watch::AgentView agent;
    agent.id = id;
    agent.heard = agent.live = true;
    agent.incarnation = 1;
    agent.mode = AgentMode::Flying;
    agent.step = 40;
    agent.position_m = Vec3(x_m, 1000.0, 100.0);
    agent.goal_m = Vec3(x_m, 2000.0, 100.0);
    agent.speed_mps = 50.0;
    agent.to_go_m = 1000.0;
    agent.min_separation_m = 200.0;
    agent.age_s = 0.1;
    agent.flown_m = {vehicle.start.position_m, *agent.position_m};
    agent.costs = {{0, 4.0}, {1, 3.0}, {2, 2.5}};
    view.agents.push_back(agent);
  }
  return view;
}

}  // namespace skein::monitor
