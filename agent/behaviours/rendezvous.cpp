#include "agent/behaviours/rendezvous.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "planner/core/lockstep/plan_view.hpp"
#include "planner/rendezvous/replan.hpp"

namespace skein {
namespace {

Vec3 at_height(const Vec2& p, double height_m) {
  return {p.x(), p.y(), height_m};
}
Vec3 at_height(const Vec3& p, double /*height_m*/) {
  return p;
}

}  // namespace

RendezvousBehaviour::RendezvousBehaviour(const Mission& mission, AgentId self, bool rejoined)
    : planner_(mission.planner.replan != 0 ? rendezvous::with_reserve(mission) : mission, self),
      vehicle_(vehicle_of(mission, self).type),
      replans_(mission.planner.replan != 0),
      rejoined_(rejoined),
      follower_(vehicle_of(mission, self), mission.step_s),
      reference_(vehicle_of(mission, self), mission.step_s) {
  const bool senses = mission.controller.sensor_range_m > 0.0 && vehicle_ == VehicleType::Multirotor;
  if (replans_ || senses) under_way_.emplace(mission, self);
  if (rejoined) last_.mode = AgentMode::Rejoined;
}

bool RendezvousBehaviour::can_use(const Representative& peer) const {
  return replans_ || planner_.can_use(peer);
}

RoundOutput RendezvousBehaviour::on_round(const RoundInput& input) {
  const std::optional<Representative> said = std::exchange(last_.representative, std::nullopt);
  const bool on_the_ground = input.tick.phase == Phase::Planning && input.tick.step == 0;
  if (on_the_ground && !rejoined_) {
    plan(input, said);
  } else if (!on_the_ground && input.tick.phase != Phase::Finished) {
    fly(input);
  }
  return last_;
}

void RendezvousBehaviour::plan(const RoundInput& input, const std::optional<Representative>& said) {
  std::vector<Representative> usable;
  std::ranges::copy_if(input.peers, std::back_inserter(usable),
                       [this](const Representative& peer) { return planner_.can_use(peer); });
  const rendezvous::PlanRound round = planner_.advance(usable);
  switch (round.status) {
    case rendezvous::PlanStatus::Planning:
      last_.mode = AgentMode::Planning;
      break;
    case rendezvous::PlanStatus::Ready:
      if (last_.mode != AgentMode::Ready) last_.plan_view = plan_view_of(usable, said);
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

void RendezvousBehaviour::fly(const RoundInput& input) {
  if (input.tick.phase == Phase::Flying && input.sense == nullptr) {
    throw std::invalid_argument("a flight step needs the agent's own sense sample");
  }
  if (!under_way_) return follow(*input.sense);
  if (!took_off_ && !rejoined_) under_way_->take_off(planner_, last_.plan_view);
  took_off_ = true;
  under_way_->on_round(input, last_);
}

void RendezvousBehaviour::follow(const Sense& sense) {
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
  if (under_way_) under_way_->add_to(hash);
  hash.add(last_.mode).add(last_.commanded_velocity_mps).add(last_.planned_length_m).add(last_.cost);
}

}  // namespace skein
