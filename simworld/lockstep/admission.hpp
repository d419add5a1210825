// Who may take part: agents introduce themselves, and the run starts when all are matched with one another.
//
// An agent introduces itself by beacons with incarnation 0 and a nonce of its own. The first process with an id holds
// it; a newcomer with a held id is refused as soon as the holder is heard after it, and takes the id over when the
// holder stays silent for the deadline. Ready: every vehicle's agent has the mission, and every pair of processes, the
// world included, says of each other that all endpoints are matched.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "planner/core/lockstep/samples.hpp"

namespace skein {

class Admission {
 public:
  /// @param ids the vehicles' ids, ascending. @param silence_s after which a holder loses its id.
  Admission(std::uint64_t run, std::uint64_t world_nonce, std::vector<AgentId> ids, double silence_s);

  /// Takes an introduction (incarnation 0) that arrived at `now_s`.
  void introduce(const Beacon& beacon, double now_s);
  /// A process said goodbye, or is known to have ended: it no longer holds its id.
  void forget(std::uint64_t nonce);
  /// Refuses every newcomer from now on: the roster is fixed.
  void close() { closed_ = true; }
  [[nodiscard]] bool closed() const { return closed_; }

  /// Vehicles whose agent has introduced itself.
  [[nodiscard]] std::size_t introduced() const { return holders_.size(); }
  /// Vehicles whose agent is matched with the world and every other agent, both ways.
  [[nodiscard]] std::size_t matched(std::span<const std::uint64_t> world_matched) const;
  /// The roster of the first round, or nothing while anybody is missing.
  [[nodiscard]] std::optional<std::vector<RosterEntry>> roster(std::span<const std::uint64_t> world_matched) const;
  /// Ids that nobody holds yet, or whose holder is not matched: what a start-up time-out names.
  [[nodiscard]] std::vector<AgentId> missing(std::span<const std::uint64_t> world_matched) const;
  /// Whether an agent has introduced itself without the mission: it may have got lost.
  [[nodiscard]] bool lacks_mission() const;
  /// What keeps the run from starting, in one line: who was not heard, who lacks the mission, which pairs are not
  /// matched in which direction; at most a dozen of them. Empty if nothing does.
  [[nodiscard]] std::string obstacles(std::span<const std::uint64_t> world_matched) const;
  /// The refusals that came up since the last call.
  [[nodiscard]] std::vector<Refusal> take_refused();

 private:
  struct Holder {
    std::uint64_t nonce = 0;
    bool has_mission = false;
    std::vector<std::uint64_t> matched;
    double heard_s = 0.0;
    std::optional<std::uint64_t> challenger;
  };
  [[nodiscard]] bool complete(AgentId id, std::span<const std::uint64_t> world_matched) const;
  void refuse(std::uint64_t nonce, RefusalReason reason);

  std::uint64_t run_;
  std::uint64_t world_nonce_;
  std::vector<AgentId> ids_;
  double silence_s_;
  bool closed_ = false;
  std::map<AgentId, Holder> holders_;
  std::vector<Refusal> refused_;
};

}  // namespace skein
