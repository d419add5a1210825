#include "agent/behaviours/under_way.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"
#include "planner/rendezvous/replan.hpp"

namespace skein {
namespace {

/// Of the speed that all can keep, what the moving reference takes: the rest is for catching up.
constexpr double kShare = 0.9;
/// Of the speed that a slow vehicle was seen to reach, what it promises.
constexpr double kPromise = 0.98;
/// Within which every live peer is heard: a rendezvous has no radio of limited range.
constexpr double kPeerRange_m = 1e6;
constexpr std::size_t kMostKnown = 64;
/// Room that a constant-speed vehicle needs beyond the switch to turn away from what is ahead, in turning radii.
constexpr double kTurnAway_radii = 1.5;
/// Until a multirotor stands after it has braked.
constexpr double kSettle_s = 1.5;
/// By how much more of the way each failure lets all draw back, so that more lengths are in reach.
constexpr double kLongerEach = 0.05;

FlightPath path_of(const rendezvous::Planner& planner, double height_m) {
  return std::visit([&](const auto& in_space) { return FlightPath(in_space.path(), height_m); }, planner.in_space());
}

VehicleSpec with_speed(VehicleSpec spec, double speed_mps) {
  spec.speed_mps = speed_mps;
  return spec;
}

}  // namespace

UnderWay::UnderWay(const Mission& mission, AgentId self)
    : mission_(rendezvous::with_reserve(mission)),
      surroundings_(mission, self),
      self_(self),
      spec_(vehicle_of(mission_, self)),
      controller_(mission.controller, spec_, mission.step_s, kPeerRange_m),
      top_mps_(controller_.top_speed_mps()),
      replanning_(mission_, self),
      speed_(mission.step_s),
      late_(mission.step_s),
      hold_(spec_, mission.step_s, kShare),
      turn_rad_(spec_.max_curvature_per_m * spec_.speed_mps * mission.step_s) {}

void UnderWay::take_off(const rendezvous::Planner& planner, std::uint64_t view) {
  set_plan(planner, top_mps_, {});
  plan_->view = view;
}

void UnderWay::set_plan(const rendezvous::Planner& planner, double speed_mps, std::span<const Track> avoided) {
  const double height_m = slot_pose(mission_, spec_).position_m.z();
  const VehicleSpec spec = with_speed(spec_, speed_mps);
  plan_.emplace(Plan{path_of(planner, height_m), MovingReference(spec, mission_.step_s, kShare),
                     PathFollower(spec, mission_.step_s), 0});
  late_ = LateWatch(mission_.step_s);
  accepted_ = true;
  waiting_.reset();
  for (Known& known : known_) known.settled = false;
  for (const Track& track : avoided) note_known(track, true);
}

void UnderWay::note_known(const Track& track, bool settled) {
  const auto place = std::ranges::lower_bound(known_, track.id, {}, [](const Known& k) { return k.track.id; });
  if (place == known_.end() || place->track.id != track.id) {
    known_.insert(place, {track, settled});
  } else if (settled) {
    place->settled = true;
  }
}

void UnderWay::sense(const Tick& tick, const Sense& sense) {
  sense_ = sense;
  sensed_ = true;
  for (const Track& track : sense.tracks) {
    if (track.fixed) note_known(track, false);
  }
  surroundings_.look(tick, sense);
  if (!hovers()) return;
  const double commanded_mps = std::min(steering_.velocity_mps.norm(), top_mps_);
  const double reached_mps = sense.velocity_mps.norm();
  speed_.note(reached_mps, commanded_mps < 0.5 * top_mps_ ? reached_mps : commanded_mps);
}

/// What peers know is known to all.
void UnderWay::learn(std::span<const Representative> peers) {
  for (const Representative& peer : peers) {
    if (!peer.revision) continue;
    for (const Track& track : peer.revision->obstacles) {
      if (track.fixed) note_known(track, false);
    }
  }
}

bool UnderWay::takes_part() const {
  return mission_.planner.replan != 0 && sensed_ && sense_.obeyed && !arrived_;
}

void UnderWay::on_round(const RoundInput& input, RoundOutput& out) {
  const bool flying = input.tick.phase == Phase::Flying;
  if (flying) {
    if (input.sense == nullptr) throw std::invalid_argument("a flight step needs the agent's own sense sample");
    sense(input.tick, *input.sense);
  }
  learn(input.peers);
  switch (replanning_.hear(input.tick, input.peers, takes_part())) {
    case ReplanEvent::Join:
      stop(input.tick);
      replanning_.join(revision(input.tick, wanted_.value_or(SafetyReason::None)),
                       waiting_ ? waiting_->to_come_m : 0.0);
      break;
    case ReplanEvent::Aim:
      aim(input.tick);
      break;
    case ReplanEvent::Switch: {
      const NewPlan next = replanning_.take();
      set_plan(next.planner, next.speed_mps, next.avoided);
      plan_->view = next.view;
      out.planned_length_m = plan_->path.length_m();
      break;
    }
    case ReplanEvent::Fail:
      accepted_ = false;
      break;
    case ReplanEvent::None:
      break;
  }
  if (flying) {
    wanted_ = takes_part() ? wants() : std::nullopt;
    if (wanted_ && replanning_.may_call(input.tick.step)) {
      replanning_.call(input.tick, revision(input.tick, *wanted_));
      if (*wanted_ == SafetyReason::Blocked && hovers()) brake_at_once();
    }
    fly(out);
  }
  out.mode = replanning_.engaged() ? AgentMode::Replanning
             : arrived_            ? AgentMode::Arrived
             : sense_.obeyed       ? AgentMode::Flying
                                   : AgentMode::Rejoined;
  out.plan_view = plan_ && accepted_ && !waiting_ ? plan_->view : 0;
  out.representative = replanning_.sample();
}

double UnderWay::to_come_m() const {
  if (!hovers()) return plan_->follower.next_m();
  return plan_->reference.travelled_m(plan_->path.length_m(), plan_->reference.now_s());
}

/// Why the plan does not hold, if it does not.
std::optional<SafetyReason> UnderWay::wants() {
  if (!accepted_) return SafetyReason::NoPlan;
  bool blocked = false;
  for (Known& known : known_) {
    if (known.settled) continue;
    const double keep_out_m = spec_.radius_m + mission_.planner.clearance_margin_m;
    // what it must still fly begins where it is itself, if it is behind its reference
    const double behind_m = reference_m_ ? (*reference_m_ - sense_.pose.position_m).norm() : 0.0;
    known.settled = !blocks(plan_->path, std::max(0.0, to_come_m() - behind_m), known.track, keep_out_m);
    blocked = blocked || !known.settled;
  }
  if (blocked) return SafetyReason::Blocked;
  if (!hovers() || replanning_.engaged()) return std::nullopt;
  const MovingReference& reference = plan_->reference;
  const double length_m = plan_->path.length_m();
  const Vec3 there_m = plan_->path.position_at(reference.travelled_m(length_m, reference.now_s()));
  Lateness now;
  now.deviation_m = (there_m - sense_.pose.position_m).norm();
  now.limit_m = mission_.controller.deviation_m;
  now.spare_mps = std::min(top_mps_, speed_.limit_mps().value_or(top_mps_)) - reference.cruise_mps();
  now.left_s = reference.whole_s(length_m) - reference.now_s();
  now.held_off = steering_.repelled || steering_.overruled || steering_.braking;
  if (late_.note(now)) return SafetyReason::Deviation;
  return std::nullopt;
}

std::vector<Track> UnderWay::obstacles() const {
  std::vector<Track> tracks;
  for (const Known& known : known_) tracks.push_back(known.track);
  return tracks;
}

/// An attempt begins: a multirotor chooses where to wait for its plan, others whether they can fly on until then.
void UnderWay::stop(const Tick& tick) {
  if (hovers()) {
    wait_hovering();
  } else {
    wait_circling(tick);
  }
}

void UnderWay::wait_hovering() {
  const std::vector<Track> obstacles = this->obstacles();
  const WaitingQuery query{mission_, self_, obstacles};
  const bool near = reference_m_ && (*reference_m_ - sense_.pose.position_m).norm() <= mission_.controller.deviation_m;
  if (plan_ && near && (!waiting_ || waiting_->stop)) {
    waiting_ = place_on_path(query, plan_->path, plan_->reference);
    if (waiting_->stop) plan_->reference.brake(plan_->path.length_m(), waiting_->stop->brake_mps2);
  } else if (waiting_ && near) {
    waiting_ = place_off_path(query, waiting_->pose.position_m, Vec3::Zero());
  } else {
    waiting_ = place_off_path(query, sense_.pose.position_m, sense_.velocity_mps);
  }
  draw_back();
}

/// Peers begin to brake one step later; who would come too close until then does not wait for them.
void UnderWay::brake_at_once() {
  const std::vector<Track> obstacles = this->obstacles();
  const WaitingPlace place = place_on_path({mission_, self_, obstacles}, plan_->path, plan_->reference);
  if (!place.stop || place.stop->brake_mps2 <= 0.5 * spec_.max_acceleration_mps2) return;
  waiting_ = place;
  plan_->reference.brake(plan_->path.length_m(), place.stop->brake_mps2);
  draw_back();
}

void UnderWay::draw_back() {
  if (waiting_->stop) plan_->reference.draw_back(plan_->path.length_m(), waiting_->stop->at_m);
}

/// A multirotor is free to wait elsewhere and to face any way: it chooses for the length that the swarm will have.
void UnderWay::aim(const Tick& tick) {
  if (!hovers()) return replanning_.aim(replanning_.own().pose, 0.0, 0);
  std::vector<PeerPlace> peers;
  for (const rendezvous::Joiner& peer : replanning_.joined()) {
    if (peer.agent == self_) continue;
    const auto first = std::ranges::find(replanning_.joined_first(), peer.agent, &rendezvous::Joiner::agent);
    const Vec3& to_m = peer.revision.pose.position_m;
    const Vec3& from_m = first != replanning_.joined_first().end() ? first->revision.pose.position_m : to_m;
    peers.push_back({from_m, to_m, spec_.safety_radius_m + vehicle_of(mission_, peer.agent).safety_radius_m});
  }
  const WaitingQuery query{mission_, self_, replanning_.avoided(), peers};
  const double longer = replanning_.aims_first() ? 1.0 + kLongerEach * replanning_.failures() : 1.0;
  const double length_m = longer * replanning_.goal_m();
  waiting_ = place_for_length(query, waiting_.value(), plan_ ? plan_->path : FlightPath(), length_m);
  draw_back();
  const double off_m = (waiting_->pose.position_m - sense_.pose.position_m).norm();
  double needed_s = kSettle_s + 2.0 * std::sqrt(2.0 * off_m / spec_.max_acceleration_mps2) + off_m / spec_.speed_mps;
  if (waiting_->stop) needed_s = kSettle_s + plan_->reference.rest_s() - plan_->reference.now_s();
  replanning_.aim(waiting_->pose, waiting_->to_come_m,
                  tick.step + static_cast<std::uint32_t>(std::ceil(needed_s / mission_.step_s)));
}

/// Without a path that is clear until the switch it circles, to the side that has more room.
void UnderWay::wait_circling(const Tick& tick) {
  const std::vector<Track> obstacles = this->obstacles();
  if (accepted_) {
    const double until_m = (replanning_.switch_step() - tick.step + 1) * spec_.speed_mps * mission_.step_s +
                           kTurnAway_radii / spec_.max_curvature_per_m;
    const double keep_out_m = spec_.radius_m + mission_.planner.clearance_margin_m;
    const bool clear = std::ranges::none_of(obstacles, [&](const Track& track) {
      return blocks(plan_->path, plan_->follower.next_m(), track, keep_out_m, plan_->follower.next_m() + until_m);
    });
    if (clear) return;
    accepted_ = false;
  }
  turn_rad_ = std::fabs(turn_rad_);
  if (circle_room_m(obstacles, -1.0) > circle_room_m(obstacles, 1.0)) turn_rad_ = -turn_rad_;
}

/// The least distance (m) of a full circle to the left (1) or right (-1) to what is known.
double UnderWay::circle_room_m(std::span<const Track> obstacles, double side) const {
  constexpr int kPlaces = 32;
  const Vec2 along = direction_of_heading(sense_.pose.heading_rad);
  const Vec2 out_m = side / spec_.max_curvature_per_m * Vec2(along.y(), -along.x());  // from the centre to where it is
  double least_m = 1e6;
  for (int k = 0; k < kPlaces; ++k) {
    const Vec2 aside_m = rotated(out_m, side * math::kTwoPi * k / kPlaces) - out_m;
    const Vec3 there_m = sense_.pose.position_m + Vec3(aside_m.x(), aside_m.y(), 0.0);
    least_m = std::min(least_m, rendezvous::clearance_m(mission_, obstacles, there_m));
  }
  return least_m;
}

Revision UnderWay::revision(const Tick& tick, SafetyReason reason) const {
  Revision own;
  own.reason = reason;
  own.pose = sense_.pose;
  if (replanning_.engaged()) own.pose = hovers() ? waiting_.value().pose : pose_at_switch(tick);
  own.speed_mps = top_mps_;
  if (speed_.limit_mps()) own.speed_mps = std::min(own.speed_mps, kPromise * *speed_.limit_mps());
  own.obstacles = obstacles();
  if (own.obstacles.size() > kMostKnown) own.obstacles.resize(kMostKnown);
  return own;
}

}  // namespace skein
