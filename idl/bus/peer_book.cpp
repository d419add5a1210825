#include "idl/bus/peer_book.hpp"

#include <algorithm>
#include <bit>
#include <set>
#include <tuple>
#include <utility>

namespace skein::bus {
namespace {

bool is_counted(Role own, Role peer) {
  return peer == Role::Agent || (peer == Role::World && own == Role::Agent);
}

std::optional<std::string> conflict_between(const PeerInfo& own, const PeerInfo& world) {
  if (own.role != Role::World && world.wire_version != own.wire_version) {
    return "the world of swarm '" + own.swarm + "' speaks wire version " + std::to_string(world.wire_version) +
           (own.role == Role::Agent ? ", this agent version " : ", this observer version ") +
           std::to_string(own.wire_version);
  }
  const bool earlier = std::tie(world.start_stamp_ns, world.nonce) < std::tie(own.start_stamp_ns, own.nonce);
  const bool predecessor = own.run != 0 && world.run == own.run;  // it died, and DDS has not noticed yet
  if (own.role == Role::World && earlier && !predecessor) {
    return "swarm '" + own.swarm + "' already has a world (nonce " + std::to_string(world.nonce) + ")";
  }
  return std::nullopt;
}

}  // namespace

void PeerBook::discovered(const ProcessKey& process, std::optional<PeerInfo> info) {
  const std::lock_guard lock(mutex_);
  peers_[process].info = std::move(info);
}

void PeerBook::gone(const ProcessKey& process) {
  const std::lock_guard lock(mutex_);
  peers_.erase(process);
}

void PeerBook::found(const ProcessKey& process, EntityKey entity, std::uint16_t endpoint, bool is_there, double now_s) {
  const auto bit = static_cast<std::size_t>(std::countr_zero(endpoint));
  const std::lock_guard lock(mutex_);
  if (is_there) {
    Peer& peer = peers_[process];
    if (peer.found.emplace(entity, bit).second) peer.found_s = now_s;
  } else if (const auto known = peers_.find(process); known != peers_.end() && known->second.found.erase(entity) > 0) {
    known->second.named[bit] = 0;
  }
}

void PeerBook::matched(const ProcessKey& process, std::uint16_t endpoint) {
  const std::lock_guard lock(mutex_);
  if (const auto known = peers_.find(process); known != peers_.end()) {
    ++known->second.named[static_cast<std::size_t>(std::countr_zero(endpoint))];
  }
}

void PeerBook::renew() {
  const std::lock_guard lock(mutex_);
  peers_.clear();
  ++own_.renewals;
}

std::map<std::uint64_t, const PeerBook::Peer*> PeerBook::newest() const {
  std::map<std::uint64_t, const Peer*> newest;
  for (const auto& [process, peer] : peers_) {
    if (!peer.info || peer.info->swarm != own_.swarm || peer.info->nonce == own_.nonce) continue;
    const auto [known, first] = newest.emplace(peer.info->nonce, &peer);
    if (!first && known->second->info->renewals < peer.info->renewals) known->second = &peer;
  }
  return newest;
}

bool PeerBook::complete(const Peer& peer, double now_s) const {
  const std::uint16_t expected = expected_matches(own_.role, peer.info->role);
  const std::uint32_t members = own_.role == Role::Agent ? own_.members : peer.info->members;
  bool all_named = true;
  for (std::size_t bit = 0; bit < peer.named.size(); ++bit) {
    if (((expected >> bit) & 1U) == 0) continue;
    const std::uint32_t matches = kTopics[bit / 2].per_agent ? members : 1U;
    // the world has a writer for each agent, a process of agents one reader for all of them
    const std::uint32_t endpoints = own_.role == Role::Agent ? matches : 1U;
    if (std::ranges::count(peer.found, bit, [](const auto& entry) { return entry.second; }) < endpoints) return false;
    all_named = all_named && peer.named[bit] >= matches;
  }
  return all_named || now_s - peer.found_s >= kSettled_s;
}

std::vector<std::uint64_t> PeerBook::matched_nonces(double now_s) const {
  std::vector<std::uint64_t> nonces;
  const std::lock_guard lock(mutex_);
  for (const auto& [nonce, peer] : newest()) {
    if (!is_counted(own_.role, peer->info->role)) continue;
    if (!complete(*peer, now_s)) continue;
    for (std::uint32_t member = 0; member < peer->info->members; ++member) nonces.push_back(nonce + member);
  }
  std::ranges::sort(nonces);
  return nonces;
}

bool PeerBook::observed() const {
  const auto ticks = static_cast<std::size_t>(std::countr_zero(endpoint_bit(TopicId::Tick, true)));
  const std::lock_guard lock(mutex_);
  return std::ranges::any_of(peers_, [&](const auto& entry) {
    const Peer& peer = entry.second;
    if (peer.info && peer.info->role != Role::Observer) return false;
    return std::ranges::any_of(peer.found, [&](const auto& endpoint) { return endpoint.second == ticks; });
  });
}

std::array<std::uint32_t, 2 * kTopics.size()> PeerBook::endpoints(const ProcessKey& own) const {
  std::array<std::uint32_t, 2 * kTopics.size()> counts{};
  const std::lock_guard lock(mutex_);
  const auto alive = newest();
  for (const auto& [process, peer] : peers_) {
    if (process == own) continue;
    if (peer.info) {
      const auto known = alive.find(peer.info->nonce);
      if (known == alive.end() || known->second != &peer) continue;
    }
    for (const auto& [entity, bit] : peer.found) ++counts[bit];
  }
  return counts;
}

std::optional<std::string> PeerBook::conflict() const {
  const std::lock_guard lock(mutex_);
  for (const auto& [nonce, peer] : newest()) {
    if (peer->info->role != Role::World) continue;
    if (auto text = conflict_between(own_, *peer->info)) return text;
  }
  return std::nullopt;
}

std::vector<std::string> PeerBook::swarms(bool with_world) const {
  std::set<std::string> names;
  const std::lock_guard lock(mutex_);
  for (const auto& [process, peer] : peers_) {
    if (!peer.info || peer.info->role == Role::Observer) continue;
    if (peer.info->role == Role::World || !with_world) names.insert(peer.info->swarm);
  }
  return {names.begin(), names.end()};
}

}  // namespace skein::bus
