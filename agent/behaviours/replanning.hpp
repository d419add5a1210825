// How a swarm comes to a new plan under way: one agent calls, all join, plan and switch together, or all fail alike.
//
//   state     in a round                                      publishes             goes to
//   Idle      the agent wants a plan (flight rounds only)     call: a revision      Called
//   any       a call of the round before is heard, its own    join: a revision      Joined
//             included: its round is the attempt's number
//   Joined    the next: who joined is known, and the          its revision          Aiming
//             longest of the shortest ways to come
//   Aiming    one after the other, the longest way first      its revision, from    Aiming
//                                                             its turn on final
//   Aiming    all had their turn                              generation 0          Planning: with all that still aim
//   Planning  the next                                        its representative    Planning; Ready; Idle: failed
//   Ready     before the switch                               nothing               Ready
//   Planning  the flight round of the switch step             nothing               Idle: failed, too late
//   Ready     the flight round of the switch step             nothing               Idle: all turn to the new plan
// A call says when to switch, and so does who needs longer to its final place; of several in one round the latest
// counts. A newer call takes the place of an attempt that is under way: it comes from one who could not join that one.
// All of it follows from samples of one round that all live agents see alike, so all join, plan, fail and switch in the
// same rounds, whoever is lost on the way; and Ready says that all live agents that take part accepted the plan. If
// somebody came back since the attempt began, it fails instead of the switch. Who arrived, or has no vehicle, takes no
// part; its peers do not wait for it.
//
// Source: papers/001, section 5. Departs from source: own; the paper only names the on-line use. Complexity: that of
// the planner's rounds.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/core/lockstep/samples.hpp"
#include "planner/rendezvous/planner.hpp"
#include "planner/rendezvous/replan.hpp"

namespace skein {

/// What a round changed for the agent that hears it.
enum class ReplanEvent : std::uint8_t {
  None,
  Join,    ///< an attempt begins: join() is due in this round
  Aim,     ///< its turn to choose where it will be, knowing what those before chose: aim() is due in this round
  Switch,  ///< the new plan is to be flown from this step on: take() it
  Fail,    ///< the attempt is over without a plan
};

/// A plan that the swarm accepted.
struct NewPlan {
  rendezvous::Planner planner;  ///< Ready
  double speed_mps = 0.0;       ///< of all
  std::vector<Track> avoided;   ///< the obstacles that it keeps clear of, by ascending id
  std::uint64_t view = 0;       ///< its digest (plan_view.hpp), once it is Ready
};

class Replanning {
 public:
  Replanning(const Mission& mission, AgentId self);

  /// Once a round, first. @param takes_part whether this agent can fly a plan
  [[nodiscard]] ReplanEvent hear(const Tick& tick, std::span<const Representative> peers, bool takes_part);
  /// Calls for a new plan in a flight round. @pre hear() said None or Fail, and nothing is under way
  void call(const Tick& tick, Revision own);
  /// Takes part. @param own attempt and switch_step are filled in. @pre hear() said Join in this round
  /// @param shortest_m of its ways to its slot from there, as far as it knows
  void join(Revision own, double shortest_m);
  /// Publishes its final pose, chosen for goal_m(), the length of its way from there, and the step in which it can be
  /// there at the earliest. @pre hear() said Aim
  void aim(const Pose& pose, double shortest_m, std::uint32_t earliest_step);
  /// @pre hear() said Switch in this round
  [[nodiscard]] NewPlan take();

  /// What is to be published in this round.
  [[nodiscard]] const std::optional<Representative>& sample() const { return sample_; }
  /// An attempt is under way.
  [[nodiscard]] bool engaged() const { return state_ != State::Idle; }
  /// The step in which all turn to the new plan. @pre engaged()
  [[nodiscard]] std::uint32_t switch_step() const { return switch_step_; }
  /// The longest of the shortest ways that joined: what the common length will hardly be below. @pre hear() said Aim
  [[nodiscard]] double goal_m() const { return goal_m_; }
  /// What it promised. @pre engaged()
  [[nodiscard]] const Revision& own() const { return own_; }
  /// What all that joined know. @pre hear() said Aim in this round
  [[nodiscard]] const std::vector<Track>& avoided() const { return avoided_; }
  /// Whether nobody aimed before it. @pre hear() said Aim in this round
  [[nodiscard]] bool aims_first() const { return order_.front().agent == self_; }
  /// Who joined and where they will be, as they said last, this agent among them. @pre hear() said Aim in this round
  [[nodiscard]] const std::vector<rendezvous::Joiner>& joined() const { return joined_; }
  /// The same, as they said first.
  [[nodiscard]] const std::vector<rendezvous::Joiner>& joined_first() const { return first_; }
  /// Attempts in a row that ended without a plan.
  [[nodiscard]] std::uint32_t failures() const { return failures_; }
  /// Whether a call would make sense in a step: none is under way, the break after a failure is over, and not
  /// kMaxAttempts have failed.
  [[nodiscard]] bool may_call(std::uint32_t step) const;

  static constexpr std::uint32_t kMaxAttempts = 8;

  void add_to(StateHash& hash) const;

 private:
  enum class State : std::uint8_t { Idle, Called, Joined, Aiming, Planning, Ready };

  /// Whose turn it is to aim: by descending length of the way, equal ones by ascending id.
  struct Turn {
    double shortest_m;
    AgentId agent;
  };

  [[nodiscard]] double shortest_of(AgentId agent, std::span<const Representative> peers) const;
  [[nodiscard]] std::optional<std::uint32_t> called_switch(const Tick& tick,
                                                           std::span<const Representative> peers) const;
  [[nodiscard]] std::uint32_t steps_to_switch() const;
  [[nodiscard]] std::vector<rendezvous::Joiner> joiners(std::span<const Representative> peers) const;
  [[nodiscard]] ReplanEvent aim_in_turn(const Tick& tick, std::span<const Representative> peers);
  void open(const Tick& tick);
  void plan(const Tick& tick, std::span<const Representative> peers, const std::optional<Representative>& said);
  void fail(const Tick& tick);
  void publish_revision();
  [[nodiscard]] bool someone_came(const Tick& tick) const;

  const Mission mission_;
  AgentId self_;
  State state_ = State::Idle;
  std::uint32_t attempt_ = 0;
  std::vector<RosterEntry> crew_;  ///< who was live when the attempt began
  std::uint32_t switch_step_ = 0;
  std::uint32_t failures_ = 0;
  std::uint32_t failed_step_ = 0;
  Revision own_;
  double shortest_m_ = 0.0;
  double goal_m_ = 0.0;
  std::vector<Track> avoided_;
  std::vector<rendezvous::Joiner> joined_;
  std::vector<rendezvous::Joiner> first_;
  std::vector<Turn> order_;
  std::uint32_t first_turn_ = 0;  ///< the round of the first of them
  std::optional<Representative> sample_;
  std::optional<NewPlan> plan_;
};

}  // namespace skein
