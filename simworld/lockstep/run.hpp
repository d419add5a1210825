// The course of a run, decided round by round: phases, roster, motion, state hash, verdict. No I/O, no clock.
//
// A run plans in rounds of step 0, then flies one step a round. If an agent says in step k that it plans anew
// (planner.replan), step k + 1 has planner.rounds_per_step rounds: planning ones, without senses, while time stands
// still at the beginning of the step, and a last one that flies it. Deciding round k needs the answers of round k and
// who is lost: tick k+1's roster decides what counts, so nothing of a lost agent does, even if it arrived.
//   H(0) = mission hash;  H(k) = mix(H(k-1), world state, (id, incarnation, agent hash) of tick k+1's roster by id).
// An agent that comes back in tick k+1 has not answered round k: its agent hash counts as 0. It takes part from the
// next planning on, and until then neither holds up the planning nor is waited for in the air. The same answers give
// the same ticks, whoever carries them: this is what makes runs repeat bit for bit.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "planner/core/lockstep/samples.hpp"
#include "simworld/lockstep/answers.hpp"
#include "simworld/lockstep/barrier.hpp"
#include "simworld/lockstep/flight_log.hpp"
#include "simworld/lockstep/map_watch.hpp"
#include "simworld/lockstep/plan_watch.hpp"
#include "simworld/lockstep/radio_log.hpp"
#include "simworld/lockstep/steered.hpp"
#include "simworld/scenario/scenario.hpp"
#include "simworld/world/world.hpp"

namespace skein {

/// Where a run is going: the phase of a tick and its planning round or flight step.
struct Moment {
  Phase phase = Phase::Planning;
  std::uint32_t number = 0;

  bool operator==(const Moment&) const = default;
};

/// Exit codes of every binary (docs/architecture.md).
enum class ExitCode : std::uint8_t { Success = 0, Failed = 1, Usage = 2, StartUp = 3, AgentLost = 4 };

struct Verdict {
  ExitCode code = ExitCode::Success;
  std::string reason;                      ///< one line
  std::vector<AgentId> completed_without;  ///< lost agents, if all others arrived
};

/// What the swarm's plan came to, from the beacons.
struct PlanFigures {
  AgentId agent = 0;
  double length_m = 0.0;
  double cost = 0.0;
  std::uint32_t generation = 0;
  std::vector<double> particle = {};  ///< of the representative that was published last
};

class Run {
 public:
  /// @param run the run's id; it is in no hash. @param fail_fast end at the first lost agent.
  /// @throws std::invalid_argument for an empty mission.
  Run(std::uint64_t run, const Mission& mission, const WorldOptions& options, bool fail_fast);

  /// The tick of round 1. @pre `roster` holds every vehicle's agent, ascending; some may be `lost` already.
  /// @param back comes back at once, though lost (see decide).
  [[nodiscard]] Tick begin(std::vector<RosterEntry> roster, std::span<const Loss> lost = {},
                           std::span<const RosterEntry> back = {}, const Steered& steered = {});

  /// When the next tick will be, as far as the answers tell without those of `lost`.
  [[nodiscard]] Moment next(const Barrier& answers, std::span<const Loss> lost) const;

  /// Decides the open round and gives the next tick. @param back agents that the next tick names again, under a new
  /// incarnation; without effect if this round ends the run.
  /// @pre every agent of the roster that is not in `lost` has answered; `back` are not of the roster without `lost`.
  /// @param steered orders to which there is no objection, and obstacles: they take effect with the next tick
  [[nodiscard]] Tick decide(const Barrier& answers, std::span<const Loss> lost, std::span<const RosterEntry> back = {},
                            const Steered& steered = {});

  /// Why an order cannot take effect with the next tick, if so, when `lost` are dropped with it.
  [[nodiscard]] std::optional<Objection> objection(const Order& order, std::span<const Loss> lost) const;
  /// Which orders of the open round its answers acknowledge. decide() does so; once more for the last round.
  void note_acknowledged(const Barrier& answers);
  /// Orders and obstacles that took effect so far, by round.
  [[nodiscard]] const std::vector<OrderRecord>& orders() const { return order_log_; }
  [[nodiscard]] const std::vector<InjectionRecord>& injections() const { return injection_log_; }

  /// What the agent of an entry of the newest tick senses with that tick.
  [[nodiscard]] Sense sense_of(const RosterEntry& entry) const;

  [[nodiscard]] bool finished() const { return phase_ == Phase::Finished; }
  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] std::uint32_t rounds() const { return round_; }
  [[nodiscard]] std::uint32_t planning_rounds() const { return planning_rounds_; }
  [[nodiscard]] std::uint32_t step() const { return step_; }
  [[nodiscard]] std::uint32_t steps_flown() const { return steps_flown_; }
  [[nodiscard]] std::uint64_t state_hash() const { return hash_; }
  [[nodiscard]] const std::vector<RosterEntry>& roster() const { return roster_; }
  [[nodiscard]] const std::vector<RosterChange>& changes() const { return changes_; }
  [[nodiscard]] const std::vector<PlanFigures>& plan() const { return plan_; }
  /// Largest difference (m) of the lengths that the swarm set out to fly; nothing if planning did not end in a plan.
  [[nodiscard]] std::optional<double> plan_spread_m() const { return plan_spread_m_; }
  [[nodiscard]] const World& world() const { return world_; }
  /// What agents said under way of safety and new plans.
  [[nodiscard]] const FlightLog& flight_log() const { return flight_log_; }
  /// Rounds of the open flight step; planning rounds of all flight steps.
  [[nodiscard]] std::uint32_t rounds_in_step() const { return rounds_in_step_; }
  [[nodiscard]] std::uint32_t replan_rounds() const { return replan_rounds_; }
  /// Whether somebody flew a plan that its peers did not accept.
  [[nodiscard]] const PlanWatch& plan_watch() const { return plan_watch_; }
  /// What the radio carried; nothing if the mission is no transit.
  [[nodiscard]] const RadioLog* radio() const { return radio_ ? &*radio_ : nullptr; }
  /// Whether its maps became equal; nothing if the mission is no transit.
  [[nodiscard]] const MapWatch* map_watch() const { return map_watch_ ? &*map_watch_ : nullptr; }
  [[nodiscard]] const Mission& mission() const { return mission_; }
  /// What the run came to. @pre finished().
  [[nodiscard]] Verdict verdict() const;

 private:
  void drop(std::span<const Loss> lost);
  void admit(std::span<const RosterEntry> back);
  void date_changes(std::size_t known);
  void decide_planning(const Barrier& answers);
  void decide_flight(const Barrier& answers);
  void decide_aloft();
  void note_aloft(const Barrier& answers);
  [[nodiscard]] Moment next_aloft(const Barrier& answers, std::span<const Loss> lost) const;
  [[nodiscard]] bool replans() const;
  [[nodiscard]] std::uint32_t rounds_per_step() const;
  [[nodiscard]] bool anybody_replans(const Barrier& answers, std::span<const Loss> lost = {}) const;
  [[nodiscard]] bool awaits_plan(const Barrier& answers) const;
  void log_radio(const Barrier& answers);
  [[nodiscard]] std::vector<HeardPeer> heard_by(const VehicleRecord& vehicle) const;
  void note_plan(const Barrier& answers);
  void note_spread(const Barrier& answers);
  void fold_hash(const Barrier& answers);
  void finish(std::string failure);
  void steer(const Steered& steered);
  void count_commanded(const Barrier& answers);
  [[nodiscard]] std::uint32_t step_limit() const;
  [[nodiscard]] std::string out_of_steps() const;
  [[nodiscard]] Tick compose(const Barrier* answers) const;
  [[nodiscard]] std::string mission_failure() const;

  std::uint64_t run_;
  Mission mission_;
  WorldOptions options_;
  bool fail_fast_;
  World world_;
  std::optional<RadioLog> radio_;
  std::optional<MapWatch> map_watch_;
  Phase phase_ = Phase::Waiting;
  std::uint32_t step_ = 0;
  std::uint32_t round_ = 0;
  std::uint32_t planning_rounds_ = 0;
  std::uint32_t steps_flown_ = 0;
  std::uint32_t ended_steps_ = 0;  ///< since nobody is on the way any more
  std::uint64_t hash_;
  std::vector<RosterEntry> roster_;
  std::vector<RosterChange> changes_;
  std::vector<PlanFigures> plan_;
  std::optional<double> plan_spread_m_;
  std::string failure_;
  FlightLog flight_log_;
  PlanWatch plan_watch_;
  std::map<AgentId, AgentMode> modes_;  ///< as said last under way
  std::uint32_t rounds_in_step_ = 1;
  std::uint32_t planning_left_ = 0;  ///< planning rounds of the open step that are not decided yet
  std::uint32_t replan_rounds_ = 0;
  std::vector<Order> orders_;  ///< of the open round
  std::vector<OrderRecord> order_log_;
  std::vector<InjectionRecord> injection_log_;
  std::vector<AgentId> commanded_;     ///< who flew the last step by command
  std::uint32_t commanded_steps_ = 0;  ///< in which anybody did
};

}  // namespace skein
