// Who may take part: agents introduce themselves, and the run starts when all are matched with one another.
//
// An agent introduces itself by beacons with incarnation 0 and a nonce of its own. One without an id says 0 for it: the
// lowest id that nobody holds is held for its nonce from then on and told in the next tick, again at each of its
// introductions; when all are held it waits for one. It goes on as any other process with that id. The first process
// with an id holds it; a newcomer with a held id is refused as soon as the holder is heard after it, and takes the id
// over when the holder stays silent for the deadline. Ready: every vehicle's agent has the mission, and every pair of
// processes, the world included, says of each other that all endpoints are matched.
//
// Once the run has started, a live agent holds its id: a newcomer waits, is refused when the holder answers a later
// tick, and takes the id over when the holder is lost. Who was dropped may come back under its old nonce once it has
// heard a tick that does not name it; what it said before is a late copy. Who comes back is ready when it has the
// mission, the world and it are matched, and it is matched with every live agent; it gets the next incarnation.
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

  /// Takes an introduction (incarnation 0) that arrived at `now_s`, while round `round` is open.
  /// @return whether the newcomer must hear a tick to go on: its id is held by another process, or it asks for one
  bool introduce(const Beacon& beacon, double now_s, std::uint32_t round = 0);
  /// A process that is not live said goodbye: it no longer holds its id.
  void forget(std::uint64_t nonce);
  /// The process with this id has ended: if it is not live, it no longer holds its id.
  void forget_newcomer(AgentId id);

  /// The run starts: every holder is live, under incarnation 1.
  void close();
  [[nodiscard]] bool closed() const { return closed_; }
  /// A live agent has answered round `round`.
  void answered(AgentId id, std::uint32_t round);
  /// A live agent is lost. @param may_return its process may come back, once it has heard a tick of `round` or later
  void lose(AgentId id, std::uint32_t round, bool may_return);
  /// The agents that are ready to come back, by ascending id, each under its next incarnation; empty before the start.
  /// @param live nonces of the live agents that they must be matched with
  [[nodiscard]] std::vector<RosterEntry> returning(std::span<const std::uint64_t> world_matched,
                                                   std::span<const std::uint64_t> live, double now_s) const;
  /// Whether anybody asks to come back.
  [[nodiscard]] bool has_newcomers() const;
  /// The entry, of returning(), is live from now on.
  void admit(const RosterEntry& entry);
  /// The same of an entry that another world has admitted.
  void restore(const RosterEntry& entry);

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
  /// The ids that processes without one have asked for since the last call.
  [[nodiscard]] std::vector<Assignment> take_assigned();

 private:
  struct Holder {
    std::uint64_t nonce = 0;
    bool has_mission = false;
    std::vector<std::uint64_t> matched;
    double heard_s = 0.0;
    bool live = false;
    std::optional<std::uint64_t> challenger;
    std::uint32_t challenged_round = 0;
  };
  static void challenge(Holder& holder, std::uint64_t nonce, std::uint32_t round);
  [[nodiscard]] bool complete(AgentId id, std::span<const std::uint64_t> world_matched) const;
  void refuse(std::uint64_t nonce, RefusalReason reason);
  void assign(std::uint64_t nonce, double now_s);

  std::uint64_t run_;
  std::uint64_t world_nonce_;
  std::vector<AgentId> ids_;
  double silence_s_;
  bool closed_ = false;
  std::map<AgentId, Holder> holders_;
  std::map<AgentId, std::uint32_t> incarnations_;     ///< given so far
  std::map<std::uint64_t, std::uint32_t> gone_from_;  ///< nonces that were lost: the first round without them
  std::vector<Refusal> refused_;
  std::vector<Assignment> assigned_;
};

}  // namespace skein
