#include "simworld/lockstep/admission.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace skein {
namespace {

constexpr std::size_t kNamed = 12;  ///< obstacles in one line at most
constexpr double kFresh_s = 1.0;    ///< a newcomer that was not heard for longer may be gone again

}  // namespace

Admission::Admission(std::uint64_t run, std::uint64_t world_nonce, std::vector<AgentId> ids, double silence_s)
    : run_(run), world_nonce_(world_nonce), ids_(std::move(ids)), silence_s_(silence_s) {}

void Admission::refuse(std::uint64_t nonce, RefusalReason reason) {
  if (std::ranges::find(refused_, nonce, &Refusal::nonce) == refused_.end()) refused_.push_back({nonce, reason});
}

/// Holds an id for the nonce, if it has none yet and one is free, and tells it.
void Admission::assign(std::uint64_t nonce, double now_s) {
  const auto is_own = [&](const auto& entry) { return entry.second.nonce == nonce; };
  auto held = std::ranges::find_if(holders_, is_own);
  if (held == holders_.end()) {
    const auto is_free = [&](AgentId id) {
      const auto holder = holders_.find(id);
      return holder == holders_.end() || (!holder->second.live && now_s - holder->second.heard_s >= silence_s_);
    };
    const auto id = std::ranges::find_if(ids_, is_free);
    if (id == ids_.end()) return;
    held = holders_.insert_or_assign(*id, Holder{}).first;
    held->second.nonce = nonce;
  }
  held->second.heard_s = now_s;
  if (std::ranges::find(assigned_, nonce, &Assignment::nonce) == assigned_.end()) {
    assigned_.push_back({nonce, held->first});
  }
}

bool Admission::introduce(const Beacon& beacon, double now_s, std::uint32_t round) {
  if (beacon.agent == kWorldId) {
    assign(beacon.nonce, now_s);
    return true;
  }
  if (!std::ranges::binary_search(ids_, beacon.agent)) {
    refuse(beacon.nonce, RefusalReason::UnknownId);
    return false;
  }
  const auto gone = gone_from_.find(beacon.nonce);
  if (gone != gone_from_.end() && beacon.round < gone->second) return false;
  auto [found, fresh] = holders_.try_emplace(beacon.agent);
  Holder& holder = found->second;
  if (!fresh && holder.nonce != beacon.nonce) {
    if (holder.live || now_s - holder.heard_s < silence_s_) {
      challenge(holder, beacon.nonce, round);
      return true;
    }
    holder = Holder{};
  }
  if (holder.live) return false;  // a late copy of its own introduction
  holder.nonce = beacon.nonce;
  holder.has_mission = beacon.run == run_;
  holder.matched = beacon.matched;
  std::ranges::sort(holder.matched);
  holder.heard_s = now_s;
  if (holder.challenger) refuse(*holder.challenger, RefusalReason::IdInUse);
  holder.challenger.reset();
  return false;
}

void Admission::challenge(Holder& holder, std::uint64_t nonce, std::uint32_t round) {
  if (holder.challenger == nonce) return;
  holder.challenger = nonce;
  holder.challenged_round = round;
}

void Admission::forget(std::uint64_t nonce) {
  std::erase_if(holders_, [&](const auto& entry) { return entry.second.nonce == nonce && !entry.second.live; });
}

void Admission::forget_newcomer(AgentId id) {
  std::erase_if(holders_, [&](const auto& entry) { return entry.first == id && !entry.second.live; });
}

void Admission::close() {
  closed_ = true;
  for (auto& [id, holder] : holders_) {
    holder.live = true;
    incarnations_[id] = 1;
  }
}

void Admission::answered(AgentId id, std::uint32_t round) {
  const auto found = holders_.find(id);
  if (found == holders_.end() || !found->second.challenger || round <= found->second.challenged_round) return;
  refuse(*found->second.challenger, RefusalReason::IdInUse);
  found->second.challenger.reset();
}

void Admission::lose(AgentId id, std::uint32_t round, bool may_return) {
  const auto found = holders_.find(id);
  if (found == holders_.end() || !found->second.live) return;
  gone_from_[found->second.nonce] = may_return ? round : std::numeric_limits<std::uint32_t>::max();
  holders_.erase(found);
}

bool Admission::has_newcomers() const {
  return closed_ && std::ranges::any_of(holders_, [](const auto& entry) { return !entry.second.live; });
}

std::vector<RosterEntry> Admission::returning(std::span<const std::uint64_t> world_matched,
                                              std::span<const std::uint64_t> live, double now_s) const {
  std::vector<RosterEntry> back;
  if (!closed_) return back;
  for (const auto& [id, holder] : holders_) {
    const auto sees = [&matched = holder.matched](std::uint64_t nonce) {
      return std::ranges::binary_search(matched, nonce);
    };
    if (holder.live || !holder.has_mission || now_s - holder.heard_s > kFresh_s) continue;
    if (!std::ranges::binary_search(world_matched, holder.nonce) || !sees(world_nonce_)) continue;
    if (!std::ranges::all_of(live, sees)) continue;
    back.push_back({id, incarnations_.at(id) + 1, holder.nonce, false, false});
  }
  return back;
}

void Admission::admit(const RosterEntry& entry) {
  holders_.at(entry.agent).live = true;
  incarnations_[entry.agent] = entry.incarnation;
}

void Admission::restore(const RosterEntry& entry) {
  closed_ = true;
  Holder holder;
  holder.nonce = entry.nonce;
  holder.has_mission = true;
  holders_[entry.agent] = std::move(holder);
  admit(entry);
}

bool Admission::complete(AgentId id, std::span<const std::uint64_t> world_matched) const {
  const auto found = holders_.find(id);
  if (found == holders_.end()) return false;
  const Holder& self = found->second;
  if (!self.has_mission || !std::ranges::binary_search(world_matched, self.nonce)) return false;
  if (!std::ranges::binary_search(self.matched, world_nonce_)) return false;
  return std::ranges::all_of(holders_, [&](const auto& other) {
    return other.first == id || (std::ranges::binary_search(self.matched, other.second.nonce) &&
                                 std::ranges::binary_search(other.second.matched, self.nonce));
  });
}

std::size_t Admission::matched(std::span<const std::uint64_t> world_matched) const {
  return ids_.size() - missing(world_matched).size();
}

std::vector<AgentId> Admission::missing(std::span<const std::uint64_t> world_matched) const {
  std::vector<AgentId> ids;
  for (const AgentId id : ids_) {
    if (!complete(id, world_matched)) ids.push_back(id);
  }
  return ids;
}

bool Admission::lacks_mission() const {
  return std::ranges::any_of(holders_, [](const auto& entry) { return !entry.second.has_mission; });
}

std::string Admission::obstacles(std::span<const std::uint64_t> world_matched) const {
  std::vector<std::string> found;
  const auto blind = [&](const std::string& who, const std::string& whom) {
    found.push_back(who + " is not matched with " + whom);
  };
  for (const AgentId id : ids_) {
    const auto held = holders_.find(id);
    const std::string name = fmt::format("agent {}", id);
    if (held == holders_.end()) {
      found.push_back(name + " was not heard");
      continue;
    }
    const Holder& self = held->second;
    if (!self.has_mission) found.push_back(name + " lacks the mission");
    if (!std::ranges::binary_search(world_matched, self.nonce)) blind("the world", name);
    if (!std::ranges::binary_search(self.matched, world_nonce_)) blind(name, "the world");
    for (const auto& [other, peer] : holders_) {
      if (other != id && !std::ranges::binary_search(self.matched, peer.nonce)) {
        blind(name, fmt::format("agent {}", other));
      }
    }
  }
  const std::size_t more = found.size() - std::min(found.size(), kNamed);
  found.resize(found.size() - more);
  return fmt::format("{}{}", fmt::join(found, ", "), more > 0 ? fmt::format(", and {} more", more) : "");
}

std::optional<std::vector<RosterEntry>> Admission::roster(std::span<const std::uint64_t> world_matched) const {
  if (!missing(world_matched).empty()) return std::nullopt;
  std::vector<RosterEntry> roster;
  for (const auto& [id, holder] : holders_) roster.push_back({id, 1, holder.nonce, false, false});
  return roster;
}

std::vector<Assignment> Admission::take_assigned() {
  return std::exchange(assigned_, {});
}

std::vector<Refusal> Admission::take_refused() {
  return std::exchange(refused_, {});
}

}  // namespace skein
