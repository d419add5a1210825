#include "agent/behaviours/rendezvous.hpp"

#include <stdexcept>

namespace skein {
namespace {

Vec3 at_height(const Vec2& p, double height_m) {
  return {p.x(), p.y(), height_m};
}
Vec3 at_height(const Vec3& p, double /*height_m*/) {
  return p;
}

}  // namespace

RendezvousBehaviour::RendezvousBehaviour(const Mission& mission, AgentId self)
    : planner_(mission, self),
      vehicle_(vehicle_of(mission, self).type),
      follower_(vehicle_of(mission, self), mission.step_s),
      reference_(vehicle_of(mission, self), mission.step_s) {}

RoundOutput RendezvousBehaviour::on_round(const RoundInput& input) {
  last_.representative.reset();
  if (input.tick.phase == Phase::Planning) {
    plan(input);
  } else if (input.tick.phase == Phase::Flying) {
    if (input.sense == nullptr) throw std::invalid_argument("a flight step needs the agent's own sense sample");
    fly(*input.sense);
  }
  return last_;
}

void RendezvousBehaviour::plan(const RoundInput& input) {
  const rendezvous::PlanRound round = planner_.advance(input.peers);
  switch (round.status) {
    case rendezvous::PlanStatus::Planning:
      last_.mode = AgentMode::Planning;
      break;
    case rendezvous::PlanStatus::Ready:
      last_.mode = AgentMode::Ready;
      break;
    case rendezvous::PlanStatus::Failed:
      last_.mode = AgentMode::Failed;
      last_.constraint = round.failed_constraint;
      last_.constraint_peer = round.failed_peer;
      break;
  }
  last_.planned_length_m = round.representative.path_length_m;
  last_.cost = round.representative.cost;
  last_.generation = round.generation;
  last_.representative = round.representative;
}

void RendezvousBehaviour::fly(const Sense& sense) {
  const auto fly_along = [&](const auto& planner) {
    const auto& path = planner.path();
    if (vehicle_ == VehicleType::ConstantSpeed) {
      const PathFollower::Command command = follower_.command(path, sense.pose);
      last_.mode = command.path_flown ? AgentMode::Arrived : AgentMode::Flying;
      last_.commanded_velocity_mps = command.velocity_mps;
      return;
    }
    const double height_m = sense.pose.position_m.z();  // a plane's paths have none of their own
    const auto position_at = [&](double s_m) { return at_height(path.position_at(s_m), height_m); };
    const MovingReference::Command command = reference_.command(path.length_m(), position_at, sense.pose.position_m);
    last_.mode = command.path_flown ? AgentMode::Arrived : AgentMode::Flying;
    last_.commanded_velocity_mps = command.velocity_mps;
  };
  std::visit(fly_along, planner_.in_space());
}

void RendezvousBehaviour::add_to(StateHash& hash) const {
  planner_.add_to(hash);
  follower_.add_to(hash);
  if (vehicle_ == VehicleType::Multirotor) reference_.add_to(hash);
  hash.add(last_.mode).add(last_.commanded_velocity_mps).add(last_.planned_length_m).add(last_.cost);
}

}  // namespace skein
