// Which processes are there, and which of their endpoints are matched with this process's.
//
// A process is matched when its USER_DATA is known and every endpoint that the two roles must have in common
// (expected_matches) is; of a topic with a partition an agent, once for each agent of the process. That an endpoint
// exists is told exactly; that it is matched is told by callbacks which DDS may mix up: Fast DDS 2.9.1 calls them from
// several threads with one status that all of them write, so of two endpoints matched at the same moment one may be
// named twice and the other never. Hence endpoints that exist also count as matched when kSettled_s have passed: the
// thread that finds one matches it at once, and names it or not.
// A process whose network changed comes back with another participant under its nonce, while the old one lingers until
// its lease ends: of the participants of one nonce the one that was made anew most often is the process, and what
// becomes of the others means nothing. So are those of this process's own nonce.
// Fed by the listeners of the DDS bus, read by the owner of the port; safe from any thread.
// Complexity: O(processes log processes) a question, O(log processes) a notice.
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

/// How long after the last discovery the endpoints of a process count as matched, whoever was named.
inline constexpr double kSettled_s = 1.0;

/// What all endpoints of a process have in common: the prefix of their GUIDs.
using ProcessKey = std::array<std::uint8_t, 12>;

/// What tells the endpoints of a process apart: the rest of their GUIDs.
using EntityKey = std::uint32_t;

class PeerBook {
 public:
  explicit PeerBook(PeerInfo own) : own_(std::move(own)) {}

  /// A process was discovered, or changed what it says of itself; nothing: it is an observer.
  void discovered(const ProcessKey& process, std::optional<PeerInfo> info);
  /// It ended, or its lease ran out.
  void gone(const ProcessKey& process);
  /// A counterpart of an endpoint of this process (endpoint_bit) was found in that process at `now_s`, or is gone.
  void found(const ProcessKey& process, EntityKey entity, std::uint16_t endpoint, bool is_there, double now_s);
  /// DDS says that an endpoint of this process was matched in that process.
  void matched(const ProcessKey& process, std::uint16_t endpoint);

  /// This process makes its participant anew: nobody is known to the new one, and it says so (PeerInfo::renewals). To
  /// be called when the old participant is gone, by the thread that makes the new one.
  void renew();

  /// Nonces, ascending, of the agents and (for an agent) the world whose process's endpoints are all matched with this
  /// process's. @param now_s of the same steady clock as in found()
  [[nodiscard]] std::vector<std::uint64_t> matched_nonces(double now_s) const;

  /// Whether somebody who has no part in a run reads this process's ticks.
  [[nodiscard]] bool observed() const;

  /// How many counterparts of each endpoint of this process (the bits of endpoint_bit) all others have, whether or not
  /// this process has that endpoint. @param own this process, whose own endpoints DDS tells of as well
  [[nodiscard]] std::array<std::uint32_t, 2 * kTopics.size()> endpoints(const ProcessKey& own) const;

  /// Why this process must not take part, in one line, or nothing. For an agent or an observer: a world of its swarm
  /// has another wire version. For a world: another world of its swarm, with another run, started earlier (the lower
  /// nonce, if at the same time).
  [[nodiscard]] std::optional<std::string> conflict() const;

  /// The swarms of the processes that are there, ascending, each once; `with_world` leaves out those without a world.
  [[nodiscard]] std::vector<std::string> swarms(bool with_world) const;

  [[nodiscard]] const PeerInfo& own() const { return own_; }

 private:
  struct Peer {
    std::optional<PeerInfo> info;
    std::map<EntityKey, std::size_t> found;                 ///< endpoints there, with the bit of their counterpart here
    std::array<std::uint32_t, 2 * kTopics.size()> named{};  ///< matches told of each endpoint of this process, by bit
    double found_s = 0.0;                                   ///< when the last one was found
  };
  [[nodiscard]] bool complete(const Peer& peer, double now_s) const;
  /// Those of this swarm that say who they are, by nonce: of each process its newest participant, without its own.
  [[nodiscard]] std::map<std::uint64_t, const Peer*> newest() const;

  PeerInfo own_;
  mutable std::mutex mutex_;
  std::map<ProcessKey, Peer> peers_;
};

}  // namespace skein::bus
