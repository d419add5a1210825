#include "agent/behaviours/straight.hpp"

#include <algorithm>
#include <stdexcept>

#include "agent/controller/apf.hpp"

namespace skein {
namespace {

const TransitMission& straight_transit_of(const Mission& mission) {
  if (!mission.transit || mission.transit->planner.name != kStraight) {
    throw std::invalid_argument("the mission is no straight transit");
  }
  return *mission.transit;
}

Vec3 goal_of(const Mission& mission, AgentId self) {
  const auto rank = static_cast<std::size_t>(&vehicle_of(mission, self) - mission.vehicles.data());
  return straight_transit_of(mission).goals_m.at(rank);
}

}  // namespace

StraightBehaviour::StraightBehaviour(const Mission& mission, AgentId self)
    : own_(vehicle_of(mission, self)),
      goal_m_(goal_of(mission, self)),
      goal_radius_m_(mission.transit->goal_radius_m),
      step_s_(mission.step_s),
      options_(mission.controller),
      patience_s_(mission.transit->planner.patience * mission.transit->planner.decision_s),
      surroundings_(mission, self),
      controller_(mission.controller, own_, mission.step_s,
                  std::max(mission.transit->radio.range_m, mission.transit->sensor.range_m)),
      nearest_m_((goal_m_ - own_.start.position_m).norm()) {
  if (own_.type != VehicleType::Multirotor) throw std::invalid_argument("a straight transit is flown by multirotors");
  last_.planned_length_m = nearest_m_;
}

RoundOutput StraightBehaviour::on_round(const RoundInput& input) {
  if (input.tick.phase == Phase::Planning) {
    last_.mode = AgentMode::Ready;
  } else if (input.tick.phase == Phase::Flying) {
    if (input.sense == nullptr) throw std::invalid_argument("a flight step needs the agent's own sense sample");
    fly(input.tick, *input.sense);
  }
  return last_;
}

void StraightBehaviour::fly(const Tick& tick, const Sense& sense) {
  if (!sense.obeyed) {  // it came back, and its vehicle is not its own
    last_.mode = AgentMode::Rejoined;
    last_.commanded_velocity_mps = sense.velocity_mps;
    return;
  }
  surroundings_.look(tick, sense);
  const Vec3 wish_mps = attraction(goal_m_ - sense.pose.position_m, own_.speed_mps, own_.max_acceleration_mps2);
  const Steering steering = controller_.command(surroundings_.scene(), wish_mps);
  Situation now = surroundings_.situation(wish_mps);
  now.steering = steering;
  const Watch found = watch(options_, now);
  last_.safety_mode = found.mode;
  last_.safety_reason = found.reason;
  last_.predicted_separation_m = found.predicted_separation_m;
  last_.commanded_velocity_mps = steering.velocity_mps;
  const double to_go_m = (goal_m_ - sense.pose.position_m).norm();
  note_progress(to_go_m, now.zone_unconfirmed);
  last_.cost = to_go_m;
  last_.mode = to_go_m <= goal_radius_m_ ? AgentMode::Arrived
               : waited_s_ > patience_s_ ? AgentMode::Deadlock
                                         : AgentMode::Flying;
}

void StraightBehaviour::note_progress(double to_go_m, bool waits) {
  if (to_go_m < nearest_m_ - goal_radius_m_) {
    nearest_m_ = to_go_m;
    waited_s_ = 0.0;
  } else if (!waits) {
    waited_s_ += step_s_;
  }
}

void StraightBehaviour::add_to(StateHash& hash) const {
  surroundings_.add_to(hash);
  hash.add(last_.mode).add(last_.commanded_velocity_mps).add(nearest_m_).add(waited_s_).add(last_.safety_mode);
  hash.add(last_.safety_reason);
}

}  // namespace skein
