#include "agent/behaviours/surroundings.hpp"

#include <algorithm>

#include "planner/core/geometry/braking.hpp"
#include "planner/core/geometry/distance.hpp"

namespace skein {
namespace {

double distance_m(const Vec3& a, const Vec3& b, const ZoneShape& zone) {
  return std::visit([&](const auto& shape) { return signed_distance(a, b, shape); }, zone);
}

}  // namespace

Surroundings::Surroundings(const Mission& mission, AgentId self)
    : mission_(mission), own_(vehicle_of(mission, self)), shapes_(shapes_of(mission)), known_zones_(shapes_.size()) {}

void Surroundings::look(const Tick& tick, const Sense& sense) {
  position_m_ = sense.pose.position_m;
  velocity_mps_ = sense.velocity_mps;
  tracks_ = sense.tracks;
  hear(tick, sense);
  close_zones(tick, sense);
}

void Surroundings::hear(const Tick& tick, const Sense& sense) {
  neighbours_.clear();
  safe_m_.clear();
  for (const HeardPeer& peer : sense.heard) {
    const auto at = std::ranges::lower_bound(heard_, peer.agent, {}, &Heard::id);
    if (at == heard_.end() || at->id != peer.agent) {
      heard_.insert(at, {peer.agent, tick.step});
    } else {
      at->step = tick.step;
    }
    if (peer.landed) continue;
    const VehicleSpec& spec = vehicle_of(mission_, peer.agent);
    neighbours_.push_back({peer.agent, peer.position_m, peer.velocity_mps, spec.radius_m, spec.max_acceleration_mps2});
    safe_m_.push_back(own_.safety_radius_m + spec.safety_radius_m);
  }
  stale_ = std::ranges::any_of(heard_, [&](const Heard& peer) {
    const double ago_s = static_cast<double>(tick.step - peer.step) * mission_.step_s;
    const bool live = std::ranges::find(tick.roster, peer.id, &RosterEntry::agent) != tick.roster.end();
    return live && ago_s > 0.0 && ago_s <= mission_.controller.horizon_s;
  });
}

bool Surroundings::reaches_into(const ZoneShape& zone) const {
  const double speed_mps = velocity_mps_.norm();
  const double way_m = braking_distance_m({own_.max_acceleration_mps2, mission_.step_s}, speed_mps);
  const Vec3 end_m = speed_mps > 0.0 ? Vec3(position_m_ + way_m / speed_mps * velocity_mps_) : position_m_;
  return distance_m(position_m_, end_m, zone) < own_.radius_m;
}

void Surroundings::close_zones(const Tick& tick, const Sense& sense) {
  shapes_.resize(known_zones_);
  const double stopping_s = stopping_time_s({own_.max_acceleration_mps2, mission_.step_s}, own_.speed_mps);
  for (std::size_t i = 0; i < mission_.announced.size(); ++i) {
    const Announcement& zone = mission_.announced[i];
    const ZoneState state = i < sense.zones.size() ? sense.zones[i] : ZoneState::Unconfirmed;
    const bool ahead = tick.time_s + stopping_s < zone.from_s - zone.early_s - zone.clear_s;
    const bool open = state == ZoneState::Clear || (state == ZoneState::Ahead && ahead);
    if (!open && !reaches_into(zone.shape)) shapes_.push_back(zone.shape);
  }
}

Scene Surroundings::scene() const {
  return {position_m_, velocity_mps_, neighbours_, tracks_, shapes_};
}

Situation Surroundings::situation(const Vec3& wish_mps) const {
  Situation now;
  now.neighbours = neighbours_;
  now.safe_m = safe_m_;
  now.position_m = position_m_;
  now.velocity_mps = velocity_mps_;
  now.stale_peer = stale_;
  const Vec3 later_m = position_m_ + mission_.controller.horizon_s * wish_mps;
  const double keep_m = own_.radius_m + mission_.controller.margin_m;
  now.zone_unconfirmed = std::ranges::any_of(
      closed_zones(), [&](const ZoneShape& zone) { return distance_m(position_m_, later_m, zone) <= keep_m; });
  return now;
}

void Surroundings::add_to(StateHash& hash) const {
  hash.add(heard_.size());
  for (const Heard& peer : heard_) hash.add(peer.id).add(peer.step);
}

}  // namespace skein
