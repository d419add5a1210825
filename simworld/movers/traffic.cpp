#include "simworld/movers/traffic.hpp"

#include "planner/core/random/random_stream.hpp"

namespace skein {

Occupation occupation_of(const Announcement& announced, const Traffic& traffic, std::uint64_t seed, std::size_t index) {
  RandomStream stream(seed, kWorldId, Purpose::Delay, index);
  const double delay_s = stream.uniform(-announced.early_s, traffic.late_s);
  return {announced.from_s + delay_s, announced.to_s + delay_s};
}

ZoneState state_in(const Announcement& announced, const Occupation& occupation, std::uint32_t step, double step_s) {
  const double begin_s = step_s * static_cast<double>(step - 1);
  const double end_s = step_s * static_cast<double>(step);
  if (begin_s >= occupation.to_s + step_s) return ZoneState::Clear;
  if (end_s > occupation.from_s) return ZoneState::Occupied;
  return end_s > announced.from_s - announced.early_s ? ZoneState::Unconfirmed : ZoneState::Ahead;
}

Mover mover_of(const Aircraft& aircraft, const Occupation& occupation, std::string name) {
  Mover mover;
  mover.name = std::move(name);
  mover.position_m = aircraft.from_m;
  mover.radius_m = aircraft.radius_m;
  mover.motion = LineMotion{(aircraft.to_m - aircraft.from_m) / (occupation.to_s - occupation.from_s)};
  mover.at_s = occupation.from_s;
  mover.until_s = occupation.to_s;
  return mover;
}

}  // namespace skein
