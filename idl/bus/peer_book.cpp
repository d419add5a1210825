#include "idl/bus/peer_book.hpp"

#include <algorithm>
#include <bit>
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

void PeerBook::matched(const ProcessKey& process, std::uint16_t endpoint, bool is_matched) {
  const auto bit = static_cast<std::size_t>(std::countr_zero(endpoint));
  const std::lock_guard lock(mutex_);
  if (is_matched) {
    ++peers_[process].matches[bit];
  } else if (const auto found = peers_.find(process); found != peers_.end() && found->second.matches[bit] > 0) {
    --found->second.matches[bit];
  }
}

bool PeerBook::complete(const Peer& peer) const {
  const std::uint16_t expected = expected_matches(own_.role, peer.info->role);
  const std::uint32_t members = own_.role == Role::Agent ? own_.members : peer.info->members;
  for (std::size_t bit = 0; bit < peer.matches.size(); ++bit) {
    if (((expected >> bit) & 1U) == 0) continue;
    if (peer.matches[bit] < (kTopics[bit / 2].per_agent ? members : 1U)) return false;
  }
  return true;
}

std::vector<std::uint64_t> PeerBook::matched_nonces() const {
  std::vector<std::uint64_t> nonces;
  const std::lock_guard lock(mutex_);
  for (const auto& [process, peer] : peers_) {
    if (!peer.info || !is_counted(own_.role, peer.info->role) || peer.info->swarm != own_.swarm) continue;
    if (!complete(peer)) continue;
    for (std::uint32_t member = 0; member < peer.info->members; ++member) nonces.push_back(peer.info->nonce + member);
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
