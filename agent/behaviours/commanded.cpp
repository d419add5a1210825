#include "agent/behaviours/commanded.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "agent/controller/apf.hpp"
#include "planner/core/geometry/frames.hpp"
#include "planner/core/geometry/terrain.hpp"
#include "planner/core/math/det_math.hpp"
#include "planner/rendezvous/replan.hpp"

namespace skein {
namespace {

constexpr double kPeerRange_m = 1e6;       ///< a rendezvous has no radio of limited range
constexpr double kShare = 0.9;             ///< of the speed: a reference that rests, whose gain is bounded
constexpr double kNear_m = 0.5;            ///< of a point: it is there
constexpr double kNearSpeed_s = 0.02;      ///< or as far as it flies in that time
constexpr double kDescent_part = 0.25;     ///< of the speed of a multirotor, straight down
constexpr double kDescent_rad = 0.15;      ///< below the horizon, of what circles down
constexpr double kTouchDown_m = 0.5;       ///< above the ground, and a body's radius
constexpr double kUsual_mps2 = 2.0;        ///< of a vehicle without inertia, where a way to brake is asked for
constexpr std::uint32_t kRoomPlaces = 32;  ///< of a circle, at which its room is looked at

double peer_range_m(const Mission& mission) {
  return mission.transit ? std::max(mission.transit->radio.range_m, mission.transit->sensor.range_m) : kPeerRange_m;
}

}  // namespace

CommandedBehaviour::CommandedBehaviour(const Mission& mission, AgentId self, std::unique_ptr<Behaviour> inner)
    : mission_(mission),
      spec_(vehicle_of(mission, self)),
      inner_(std::move(inner)),
      controller_(mission.controller, spec_, mission.step_s, peer_range_m(mission)),
      brake_(spec_, mission.step_s, kShare) {
  if (hovers() && (mission.controller.sensor_range_m > 0.0 || mission.transit)) surroundings_.emplace(mission, self);
}

bool CommandedBehaviour::obey(const Order& order) {
  if (order.kind == OrderKind::Start || order.kind == OrderKind::Abort || doing_ == Doing::Landed) return true;
  if (order.kind == OrderKind::Resume && doing_ == Doing::Mission) {
    next_.reset();
    return true;
  }
  next_ = order;
  return true;
}

double CommandedBehaviour::braking_mps2() const {
  return spec_.max_acceleration_mps2 > 0.0 ? spec_.max_acceleration_mps2 : kUsual_mps2;
}

/// Where a vehicle that hovers comes to rest.
Vec3 CommandedBehaviour::rest_m(const Sense& sense) const {
  return sense.pose.position_m + sense.velocity_mps * (sense.velocity_mps.norm() / braking_mps2());
}

double CommandedBehaviour::ground_height_m(const Vec3& place_m) const {
  return mission_.terrain ? ground_m(*mission_.terrain, place_m.head<2>()) : 0.0;
}

/// To the left, unless what is known is in the way there and the right has more room.
double CommandedBehaviour::side_of_circle(const Pose& pose) const {
  const auto room_m = [&](double side) {
    const Circle circle(spec_, mission_.step_s, pose, side);
    double least_m = 1e6;
    for (std::uint32_t k = 0; k < kRoomPlaces; ++k) {
      const Vec3 there_m = circle.place_m(k * circle.steps() / kRoomPlaces);
      least_m = std::min(least_m, rendezvous::clearance_m(mission_, {}, there_m));
    }
    return least_m;
  };
  if (mission_.transit) return 1.0;
  const double left_m = room_m(1.0);
  const double keep_out_m = spec_.radius_m + mission_.planner.clearance_margin_m;
  return left_m >= keep_out_m || left_m >= room_m(-1.0) ? 1.0 : -1.0;
}

void CommandedBehaviour::leave(const Order& order, const Sense& sense) {
  left_ = sense.pose;
  left_rest_m_ = rest_m(sense);
  stale_ = order.agent != kAllAgents;
}

void CommandedBehaviour::begin(const Order& order, const Sense& sense) {
  const bool from_mission = doing_ == Doing::Mission;
  if (from_mission) leave(order, sense);
  switch (order.kind) {
    case OrderKind::Hold:
      if (doing_ == Doing::Hold) return;
      if (doing_ == Doing::Return && on_left_circle_) {
        doing_ = Doing::Hold;
        return;
      }
      doing_ = Doing::Hold;
      to_m_ = rest_m(sense);
      break;
    case OrderKind::Resume:
      doing_ = Doing::Return;
      speed_mps_ = spec_.speed_mps;
      if (!hovers()) way_back_ = WayBack(spec_, mission_.step_s, circle_.radius_m(), sense.pose, left_);
      return;
    case OrderKind::Goto:
      doing_ = Doing::Goto;
      there_ = false;
      to_m_ = order.to_m;
      speed_mps_ = order.speed_mps > 0.0 ? std::min(order.speed_mps, spec_.speed_mps) : spec_.speed_mps;
      break;
    case OrderKind::Land:
      doing_ = Doing::Land;
      to_m_ = rest_m(sense);
      break;
    default:
      return;
  }
  on_left_circle_ = from_mission && doing_ == Doing::Hold;
  if (!hovers()) circle_ = Circle(spec_, mission_.step_s, sense.pose, side_of_circle(sense.pose));
}

RoundOutput CommandedBehaviour::run_mission(const RoundInput& input) {
  last_ = inner_->on_round(input);
  return last_;
}

RoundOutput CommandedBehaviour::on_round(const RoundInput& input) {
  const bool flying = input.tick.phase == Phase::Flying;
  const bool obeyed = input.sense != nullptr && input.sense->obeyed;
  if (flying && obeyed && next_) begin(*std::exchange(next_, std::nullopt), *input.sense);
  if (doing_ == Doing::Mission) return run_mission(input);
  stale_ =
      stale_ || std::ranges::any_of(input.peers, [](const Representative& peer) { return peer.revision.has_value(); });
  last_.representative.reset();
  last_.obstacle_map.reset();
  last_.plan_view = 0;
  if (!flying) return last_;
  if (input.sense == nullptr) throw std::invalid_argument("a flight step needs the agent's own sense sample");
  if (!obeyed && doing_ != Doing::Landed) {
    last_.mode = AgentMode::Rejoined;
    last_.commanded_velocity_mps = input.sense->velocity_mps;
    return last_;
  }
  if (doing_ == Doing::Return && is_back(*input.sense)) {
    doing_ = Doing::Mission;
    inner_->resume(stale_);
    return run_mission(input);
  }
  fly(input.tick, *input.sense);
  return last_;
}

/// Whether the mission can go on from here.
bool CommandedBehaviour::is_back(const Sense& sense) const {
  if (inner_->resumes_anywhere(stale_)) return true;
  if (hovers()) {
    const double near_m = std::max(kNear_m, kNearSpeed_s * spec_.speed_mps);
    return (sense.pose.position_m - left_rest_m_).norm() <= near_m;
  }
  return on_left_circle_ ? circle_.closed() : way_back_.flown();
}

void CommandedBehaviour::fly(const Tick& tick, const Sense& sense) {
  if (doing_ == Doing::Land && is_down(sense)) doing_ = Doing::Landed;
  const Vec3 wish_mps = doing_ == Doing::Landed ? Vec3::Zero() : wish(sense);
  last_.commanded_velocity_mps = clipped(wish_mps, spec_.speed_mps);
  last_.safety_mode = SafetyMode::Hold;
  last_.safety_reason = SafetyReason::None;
  last_.deviation_m = 0.0;
  if (surroundings_ && doing_ != Doing::Landed) {
    surroundings_->look(tick, sense);
    Situation now = surroundings_->situation(wish_mps);
    now.steering = controller_.command(surroundings_->scene(), wish_mps);
    const Watch found = watch(mission_.controller, now);
    last_.commanded_velocity_mps = now.steering.velocity_mps;
    last_.predicted_separation_m = found.predicted_separation_m;
    if (found.mode == SafetyMode::Controlled) {
      last_.safety_mode = found.mode;
      last_.safety_reason = found.reason;
    }
  }
  const bool waits = doing_ == Doing::Hold || (doing_ == Doing::Goto && there_) ||
                     (doing_ == Doing::Return && (hovers() ? false : on_left_circle_));
  last_.mode = doing_ == Doing::Landed ? AgentMode::Landed
               : doing_ == Doing::Land ? AgentMode::Landing
               : waits                 ? AgentMode::Holding
                                       : AgentMode::GoingTo;
}

Vec3 CommandedBehaviour::wish(const Sense& sense) {
  return hovers() ? hovering_wish(sense) : circling_wish(sense);
}

Vec3 CommandedBehaviour::hovering_wish(const Sense& sense) {
  const Vec3& here_m = sense.pose.position_m;
  switch (doing_) {
    case Doing::Goto:
      there_ = there_ || (to_m_ - here_m).norm() <= kNear_m;
      return attraction(to_m_ - here_m, speed_mps_, braking_mps2());
    case Doing::Return:
      return attraction(left_rest_m_ - here_m, speed_mps_, braking_mps2());
    case Doing::Land: {
      Vec3 down_m = to_m_ - here_m;
      down_m.z() = ground_height_m(here_m) - here_m.z();
      const double fall_mps =
          attraction(Vec3(0.0, 0.0, down_m.z()), kDescent_part * spec_.speed_mps, braking_mps2()).z();
      const Vec3 level = brake_.towards(Vec3(to_m_.x(), to_m_.y(), here_m.z()), here_m);
      return {level.x(), level.y(), fall_mps};
    }
    default:
      return brake_.towards(to_m_, here_m);
  }
}

Vec3 CommandedBehaviour::circling_wish(const Sense& sense) {
  const double reach_m = 2.0 * circle_.radius_m();
  switch (doing_) {
    case Doing::Goto:
      if (!there_ && (to_m_ - sense.pose.position_m).head<2>().norm() <= reach_m) {
        there_ = true;
        circle_ = Circle(spec_, mission_.step_s, sense.pose, side_of_circle(sense.pose));
      }
      return there_ ? circle_.command_mps() : turning_to(sense, to_m_);
    case Doing::Return:
      return on_left_circle_ ? circle_.command_mps() : way_back_.command_mps(sense.pose.position_m.z());
    case Doing::Land:
      return circling_down(sense);
    default:
      return circle_.command_mps();
  }
}

/// Level, as straight as it may turn.
Vec3 CommandedBehaviour::turning_to(const Sense& sense, const Vec3& to_m) const {
  Vec3 way_m = to_m - sense.pose.position_m;
  way_m.z() = 0.0;
  return way_m.norm() > 0.0 ? Vec3(spec_.speed_mps * way_m.normalized()) : sense.velocity_mps;
}

Vec3 CommandedBehaviour::circling_down(const Sense& sense) const {
  const double turn_rad = spec_.max_curvature_per_m * spec_.speed_mps * mission_.step_s;
  const Vec2 level = direction_of_heading(sense.pose.heading_rad + 0.9 * turn_rad);
  const math::SinCos down = math::sincos(kDescent_rad);
  return spec_.speed_mps * Vec3(down.cos * level.x(), down.cos * level.y(), -down.sin);
}

bool CommandedBehaviour::is_down(const Sense& sense) const {
  const double above_m = sense.pose.position_m.z() - ground_height_m(sense.pose.position_m);
  const double slope = mission_.terrain ? slope_bound(*mission_.terrain) : 0.0;
  const double step_m = hovers() ? 0.0 : spec_.speed_mps * mission_.step_s * (kDescent_rad + slope);
  return above_m <= (spec_.radius_m + kTouchDown_m) * std::sqrt(1.0 + slope * slope) + step_m;
}

void CommandedBehaviour::add_to(StateHash& hash) const {
  inner_->add_to(hash);
  if (doing_ == Doing::Mission) return;
  if (surroundings_) surroundings_->add_to(hash);
  hash.add(doing_).add(left_).add(left_rest_m_).add(stale_).add(on_left_circle_).add(there_).add(to_m_);
  hash.add(speed_mps_).add(last_.mode).add(last_.commanded_velocity_mps);
  circle_.add_to(hash);
  way_back_.add_to(hash);
}

}  // namespace skein
