// Which processes are there, and which of their endpoints are matched with this process's.
//
// A process is matched when its USER_DATA is known and every endpoint that the two roles must have in common
// (expected_matches) is; of a topic with a partition an agent, one match for each agent of the process. Fed by the
// listeners of the DDS bus, read by the owner of the port; safe from any thread. Complexity: O(processes) a question,
// O(log processes) a notice.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "idl/bus/peer_info.hpp"

namespace skein::bus {

/// What all endpoints of a process have in common: the prefix of their GUIDs.
using ProcessKey = std::array<std::uint8_t, 12>;

class PeerBook {
 public:
  explicit PeerBook(PeerInfo own) : own_(std::move(own)) {}

  /// A process was discovered, or changed what it says of itself; nothing: it is an observer.
  void discovered(const ProcessKey& process, std::optional<PeerInfo> info);
  /// It ended, or its lease ran out.
  void gone(const ProcessKey& process);
  /// An endpoint of this process (endpoint_bit) was matched with or lost its match in that process.
  void matched(const ProcessKey& process, std::uint16_t endpoint, bool is_matched);

  /// Nonces, ascending, of the agents and (for an agent) the world whose process's endpoints are all matched with this
  /// process's.
  [[nodiscard]] std::vector<std::uint64_t> matched_nonces() const;

  /// Why this process must not take part, in one line, or nothing. For an agent: a world of its swarm has another wire
  /// version. For a world: another world of its swarm started earlier (the lower nonce, if at the same time).
  [[nodiscard]] std::optional<std::string> conflict() const;

  [[nodiscard]] const PeerInfo& own() const { return own_; }

 private:
  struct Peer {
    std::optional<PeerInfo> info;
    std::array<std::uint16_t, 2 * kTopics.size()>
        matches{};  ///< of each endpoint of this process, by bit of endpoint_bit
  };
  [[nodiscard]] bool complete(const Peer& peer) const;

  PeerInfo own_;
  mutable std::mutex mutex_;
  std::map<ProcessKey, Peer> peers_;
};

}  // namespace skein::bus
