#include "idl/bus/peer_book.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace skein::bus {
namespace {

bool is_counted(Role own, Role peer) {
  return peer == Role::Agent || (peer == Role::World && own == Role::Agent);
}

std::optional<std::string> conflict_between(const PeerInfo& own, const PeerInfo& world) {
  if (own.role == Role::Agent && world.wire_version != own.wire_version) {
    return "the world of swarm '" + own.swarm + "' speaks wire version " + std::to_string(world.wire_version) +
           ", this agent version " + std::to_string(own.wire_version);
  }
  const bool earlier = std::tie(world.start_stamp_ns, world.nonce) < std::tie(own.start_stamp_ns, own.nonce);
  if (own.role == Role::World && earlier) {
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

void PeerBook::found(const ProcessKey& process, std::uint16_t endpoint, bool is_there, double now_s) {
  const std::lock_guard lock(mutex_);
  if (is_there) {
    Peer& peer = peers_[process];
    if ((peer.found & endpoint) != 0) return;
    peer.found = static_cast<std::uint16_t>(peer.found | endpoint);
    peer.found_s = now_s;
  } else if (const auto known = peers_.find(process); known != peers_.end()) {
    known->second.found = static_cast<std::uint16_t>(known->second.found & ~endpoint);
    known->second.matched = static_cast<std::uint16_t>(known->second.matched & ~endpoint);
  }
}

void PeerBook::matched(const ProcessKey& process, std::uint16_t endpoint) {
  const std::lock_guard lock(mutex_);
  if (const auto known = peers_.find(process); known != peers_.end()) {
    known->second.matched = static_cast<std::uint16_t>(known->second.matched | (endpoint & known->second.found));
  }
}

std::vector<std::uint64_t> PeerBook::matched_nonces(double now_s) const {
  std::vector<std::uint64_t> nonces;
  const std::lock_guard lock(mutex_);
  for (const auto& [process, peer] : peers_) {
    if (!peer.info || !is_counted(own_.role, peer.info->role) || peer.info->swarm != own_.swarm) continue;
    const std::uint16_t expected = expected_matches(own_.role, peer.info->role);
    if ((peer.found & expected) != expected) continue;
    const bool named = (peer.matched & expected) == expected;
    if (named || now_s - peer.found_s >= kSettled_s) nonces.push_back(peer.info->nonce);
  }
  std::ranges::sort(nonces);
  return nonces;
}

std::optional<std::string> PeerBook::conflict() const {
  const std::lock_guard lock(mutex_);
  for (const auto& [process, peer] : peers_) {
    if (!peer.info || peer.info->role != Role::World || peer.info->swarm != own_.swarm) continue;
    if (auto text = conflict_between(own_, *peer.info)) return text;
  }
  return std::nullopt;
}

}  // namespace skein::bus
