#include "tests/agent/behaviours/swarm_flight.hpp"

#include <algorithm>

#include "planner/core/geometry/closest_approach.hpp"

namespace skein::test {

Mission surprise_mission(std::uint64_t seed) {
  Mission mission;
  mission.name = "surprise";
  mission.seed = seed;
  mission.length_unit_m = 10.0;
  mission.step_s = 0.1;
  mission.formation.position_m = Vec3(300.0, 100.0, 20.0);
  mission.arrival_radius_m = 1.0;
  const double y_m[] = {0.0, 100.0, 200.0};
  const double heading_rad[] = {0.4, 0.0, -0.5};
  const Vec3 slots_m[] = {{8.0, 0.0, 0.0}, {-6.0, 10.0, 0.0}, {-6.0, -10.0, 0.0}};
  const std::size_t slot_of[] = {2, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    VehicleSpec spec;
    spec.id = static_cast<AgentId>(i + 1);
    spec.start = {Vec3(0.0, y_m[i], 20.0), heading_rad[i], 0.0};
    spec.slot_offset_m = slots_m[slot_of[i]];
    spec.type = VehicleType::Multirotor;
    spec.speed_mps = 10.0;
    spec.max_acceleration_mps2 = 4.0;
    spec.max_curvature_per_m = 0.04;
    spec.radius_m = 0.4;
    spec.safety_radius_m = 2.0;
    mission.vehicles.push_back(spec);
  }
  Cylinder known;
  known.centre_m = Vec2(120.0, 60.0);
  known.radius_m = 15.0;
  mission.zones.push_back({known, false});
  mission.planner.clearance_margin_m = 2.0;
  mission.planner.replan = 1;
  mission.controller.sensor_range_m = 30.0;
  return mission;
}

SwarmFlight::SwarmFlight(const Mission& mission) : mission_(mission), hash_(mission_hash(mission)) {
  for (const VehicleSpec& spec : mission.vehicles) {
    Flyer flyer;
    flyer.spec = spec;
    flyer.behaviour = make_behaviour(mission, spec.id);
    flyer.state = initial_state(spec);
    flyers_.emplace(spec.id, std::move(flyer));
  }
}

bool SwarmFlight::plan(int max_rounds) {
  for (int k = 0; k < max_rounds; ++k) {
    round();
    const auto ready = [](const auto& item) {
      return item.second.behaviour == nullptr || item.second.out.mode == AgentMode::Ready;
    };
    if (std::ranges::all_of(flyers_, ready)) {
      step_ = 1;
      return true;
    }
  }
  return false;
}

void SwarmFlight::lose(AgentId id) {
  flyers_.at(id).behaviour.reset();
  flyers_.at(id).sample.reset();
}

void SwarmFlight::bring_back(AgentId id) {
  Flyer& flyer = flyers_.at(id);
  flyer.behaviour = make_rejoined_behaviour(mission_, id);
  ++flyer.incarnation;
}

void SwarmFlight::put_obstacle(const Vec3& place_m, double radius_m) {
  Track track;
  track.id = static_cast<std::uint32_t>(obstacles_.size() + 1);
  track.position_m = place_m;
  track.radius_m = radius_m;
  track.column = true;
  track.fixed = true;
  obstacles_.push_back(track);
}

Sense SwarmFlight::sense_of(AgentId id) const {
  const Flyer& own = flyers_.at(id);
  Sense sense;
  sense.agent = id;
  sense.round = round_;
  sense.pose = pose_of(own.state);
  sense.velocity_mps = own.state.velocity_mps;
  sense.obeyed = own.obeyed;
  for (const auto& [other, flyer] : flyers_) {
    if (other != id) sense.heard.push_back({other, flyer.state.position_m, flyer.state.velocity_mps, false});
  }
  for (const Track& track : obstacles_) {
    const double off_m = (track.position_m - own.state.position_m).head<2>().norm() - track.radius_m;
    if (off_m <= mission_.controller.sensor_range_m) sense.tracks.push_back(track);
  }
  return sense;
}

void SwarmFlight::round() {
  ++round_;
  const bool flying = step_ > 0 && rounds_left_ == 0;
  Tick tick;
  tick.round = round_;
  tick.step = step_;
  tick.phase = flying ? Phase::Flying : Phase::Planning;
  tick.time_s = mission_.step_s * (step_ > 0 ? step_ - 1 : 0);
  std::vector<Representative> samples;
  for (const auto& [id, flyer] : flyers_) {
    if (flyer.behaviour == nullptr) continue;
    tick.roster.push_back({id, flyer.incarnation});
    if (flyer.sample) samples.push_back(*flyer.sample);
  }
  StateHash hash(hash_);
  for (auto& [id, flyer] : flyers_) {
    flyer.sample.reset();
    if (flyer.behaviour == nullptr) continue;
    std::vector<Representative> peers;
    for (const Representative& sample : samples) {
      if (sample.agent != id && flyer.behaviour->can_use(sample)) peers.push_back(sample);
    }
    const Sense sense = sense_of(id);
    flyer.out = flyer.behaviour->on_round({tick, flying ? &sense : nullptr, peers, {}});
    flyer.behaviour->add_to(hash);
    if (!flyer.out.representative) continue;
    flyer.sample = flyer.out.representative;
    flyer.sample->agent = id;
    flyer.sample->round = round_;
    hash.add(flyer.sample->cost).add(flyer.sample->path_length_m);
    if (flyer.sample->revision) add_to(hash, *flyer.sample->revision);
  }
  hash_ = hash.value();
  if (flying) {
    if (on_step) on_step();
    move();
    ++step_;
    rounds_left_ = anyone(AgentMode::Replanning) ? mission_.planner.rounds_per_step - 1 : 0;
  } else if (step_ > 0) {
    --rounds_left_;
  }
}

void SwarmFlight::move() {
  std::map<AgentId, Vec3> before;
  for (auto& [id, flyer] : flyers_) {
    before[id] = flyer.state.position_m;
    VehicleSpec spec = flyer.spec;
    spec.speed_mps *= flyer.speed_factor;
    const bool obeys = flyer.behaviour != nullptr && flyer.obeyed;
    const Vec3 command = obeys ? flyer.out.commanded_velocity_mps : Vec3::Zero();
    flyer.state = advance_vehicle(spec, flyer.state, command, mission_.step_s).after;
    const Vec3 off_m = flyer.state.position_m - slot_pose(mission_, flyer.spec).position_m;
    if (flyer.arrival_step == 0 && off_m.norm() <= mission_.arrival_radius_m) flyer.arrival_step = step_;
    for (const Track& track : obstacles_) {
      const double clear_m =
          (track.position_m - flyer.state.position_m).head<2>().norm() - track.radius_m - flyer.spec.radius_m;
      least_clearance_m_ = std::min(least_clearance_m_, clear_m);
    }
  }
  for (const auto& [a, one] : flyers_) {
    for (const auto& [b, other] : flyers_) {
      if (b <= a) continue;
      const auto approach = closest_approach(before[a], one.state.position_m, before[b], other.state.position_m);
      least_separation_m_ = std::min(least_separation_m_, approach.distance_m);
    }
  }
}

void SwarmFlight::fly_until(std::uint32_t max_step, const std::function<bool()>& done) {
  while (step_ <= max_step) {
    const std::uint32_t before = step_;
    round();
    if (step_ != before && done && done()) return;
  }
}

bool SwarmFlight::all_arrived() const {
  return std::ranges::all_of(flyers_, [](const auto& item) { return item.second.arrival_step > 0; });
}

bool SwarmFlight::arrived_together() const {
  const std::uint32_t first = flyers_.begin()->second.arrival_step;
  return first > 0 && std::ranges::all_of(flyers_, [&](const auto& item) { return item.second.arrival_step == first; });
}

bool SwarmFlight::anyone(AgentMode mode) const {
  return std::ranges::any_of(
      flyers_, [&](const auto& item) { return item.second.behaviour != nullptr && item.second.out.mode == mode; });
}

}  // namespace skein::test
