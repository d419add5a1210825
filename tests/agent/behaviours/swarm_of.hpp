// A few multirotors of a straight transit, flown in lockstep without a world: what each hears and senses is the truth.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "agent/behaviours/straight.hpp"
#include "simworld/vehicles/multirotor.hpp"

namespace skein::test {

/// A multirotor of 10 m/s and 4 m/s2, radius 0.5 m.
inline VehicleSpec multirotor(AgentId id, const Vec3& start_m) {
  VehicleSpec spec;
  spec.id = id;
  spec.start.position_m = start_m;
  spec.type = VehicleType::Multirotor;
  spec.speed_mps = 10.0;
  spec.max_acceleration_mps2 = 4.0;
  spec.radius_m = 0.5;
  spec.safety_radius_m = 1.0;
  return spec;
}

/// Steps of 0.1 s, goals of 1 m.
inline Mission straight_mission(const std::vector<Vec3>& starts_m, const std::vector<Vec3>& goals_m) {
  Mission mission;
  mission.kind = MissionKind::Transit;
  mission.step_s = 0.1;
  for (const Vec3& start_m : starts_m) {
    mission.vehicles.push_back(multirotor(static_cast<AgentId>(mission.vehicles.size() + 1), start_m));
  }
  mission.transit = TransitMission{};
  mission.transit->area = {Vec3(-500.0, -500.0, -500.0), Vec3(500.0, 500.0, 500.0)};
  mission.transit->goals_m = goals_m;
  mission.transit->goal_radius_m = 1.0;
  mission.transit->planner.name = kStraight;
  mission.controller.sensor_range_m = 50.0;
  return mission;
}

class SwarmOf {
 public:
  explicit SwarmOf(Mission mission) : mission_(std::move(mission)) {
    for (const VehicleSpec& spec : mission_.vehicles) {
      behaviours_.push_back(std::make_unique<StraightBehaviour>(mission_, spec.id));
      states.push_back(initial_state(spec));
    }
    outputs.resize(states.size());
    zones.assign(mission_.announced.size(), ZoneState::Ahead);
  }

  /// One flight step of all.
  void step() {
    ++steps;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Sense sense = sense_of(i);
      outputs[i] = behaviours_[i]->on_round({tick(), &sense, {}, {}});
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
      states[i] =
          advance_multirotor(mission_.vehicles[i], states[i], outputs[i].commanded_velocity_mps, mission_.step_s).after;
      for (std::size_t j = 0; j < i; ++j) {
        least_m = std::min(least_m, (states[i].position_m - states[j].position_m).norm());
      }
    }
  }
  /// Until all say that they arrived. Whether they did within so many steps.
  [[nodiscard]] bool arrive_within(std::uint32_t most) {
    for (std::uint32_t k = 0; k < most; ++k) {
      step();
      if (std::ranges::all_of(outputs, [](const auto& out) { return out.mode == AgentMode::Arrived; })) return true;
    }
    return false;
  }
  [[nodiscard]] Tick tick() const {
    Tick tick;
    tick.step = steps;
    tick.round = steps + 1;
    tick.phase = Phase::Flying;
    tick.time_s = static_cast<double>(steps - 1) * mission_.step_s;
    for (const VehicleSpec& spec : mission_.vehicles) tick.roster.push_back({.agent = spec.id, .incarnation = 1});
    return tick;
  }
  [[nodiscard]] std::uint64_t hash() const {
    StateHash hash;
    for (const auto& behaviour : behaviours_) behaviour->add_to(hash);
    return hash.value();
  }

 private:
  [[nodiscard]] Sense sense_of(std::size_t i) const {
    Sense sense;
    sense.agent = mission_.vehicles[i].id;
    sense.pose = pose_of(states[i]);
    sense.velocity_mps = states[i].velocity_mps;
    sense.tracks = tracks;
    sense.zones = zones;
    for (std::size_t j = 0; j < states.size(); ++j) {
      const AgentId other = mission_.vehicles[j].id;
      if (j == i || other == silent) continue;
      sense.heard.push_back({other, states[j].position_m, states[j].velocity_mps, false});
    }
    return sense;
  }

  Mission mission_;
  std::vector<std::unique_ptr<StraightBehaviour>> behaviours_;

 public:
  std::vector<VehicleState> states;
  std::vector<RoundOutput> outputs;
  std::vector<Track> tracks;
  std::vector<ZoneState> zones;
  AgentId silent = 0;  ///< nobody hears it
  std::uint32_t steps = 0;
  double least_m = std::numeric_limits<double>::infinity();  ///< between two centres, at the ends of steps
};

}  // namespace skein::test
