#include "idl/convert/checker.hpp"

#include <algorithm>
#include <cmath>

#include "idl/convert/limits.hpp"

namespace skein {

void Checker::within(double value, double low, double high, std::string_view where) {
  require(std::isfinite(value), WireFaultReason::NonFinite, where);
  require(value >= low && value <= high, WireFaultReason::OutOfRange, where);
}

void Checker::point(const wire::Point3& point, double bound, std::string_view where) {
  within(point.x(), -bound, bound, where);
  within(point.y(), -bound, bound, where);
  within(point.z(), -bound, bound, where);
}

void Checker::position(const wire::Point3& position, std::string_view where) {
  point(position, limits::kPosition_m, where);
}

void Checker::velocity(const wire::Point3& vector, std::string_view where) {
  point(vector, limits::kSpeed_mps, where);
}

void Checker::tracks(const std::vector<wire::Sighting>& tracks, std::size_t bound, std::string_view where) {
  size_at_most(tracks.size(), bound, where);
  if (!ok()) return;
  std::uint32_t before = 0;
  for (const wire::Sighting& track : tracks) {
    require(track.id() > before, WireFaultReason::BadOrder, where);
    position(track.position_m(), where);
    velocity(track.velocity_mps(), where);
    within(track.radius_m(), 0.0, limits::kPosition_m, where);
    before = track.id();
  }
}

void Checker::pose(const wire::DirectedPoint& pose, std::string_view where) {
  position(pose.position_m(), where);
  within(pose.heading_rad(), -limits::kHeading_rad, limits::kHeading_rad, where);
  within(pose.climb_rad(), -limits::kClimb_rad, limits::kClimb_rad, where);
}

void Checker::text(std::string_view value, std::string_view where) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  require(std::ranges::none_of(value, is_control), WireFaultReason::OutOfRange, where);
}

void Checker::agent(std::uint32_t id, std::string_view where) {
  require(id >= 1 && id <= kMaxAgents, WireFaultReason::UnknownAgent, where);
  require(context_.known.empty() || std::ranges::binary_search(context_.known, id), WireFaultReason::UnknownAgent,
          where);
}

void Checker::incarnation(std::uint32_t id, std::uint32_t incarnation, std::optional<std::uint64_t> nonce,
                          std::string_view where) {
  require(incarnation > 0, WireFaultReason::WrongIncarnation, where);
  if (!ok() || !context_.roster) return;
  const auto entry = std::ranges::lower_bound(*context_.roster, id, {}, &RosterEntry::agent);
  const bool live = entry != context_.roster->end() && entry->agent == id && entry->incarnation == incarnation &&
                    (!nonce || *nonce == entry->nonce);
  require(live, WireFaultReason::WrongIncarnation, where);
}

void Checker::run(std::uint64_t run, std::string_view where) {
  require(!context_.run || *context_.run == run, WireFaultReason::WrongRun, where);
}

void Checker::sender(const wire::Header& head, std::uint32_t sender, std::string_view where) {
  require(head.sender() == sender, WireFaultReason::WrongSender, where);
}

}  // namespace skein
