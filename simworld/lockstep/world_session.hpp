// The world's end of the lockstep protocol, over any carrier: admits agents, opens rounds, repeats what got lost, and
// names who is gone. Receive, convert, decide (simworld/lockstep/run.hpp), convert, send.
//
// While it waits it publishes a tick of phase `waiting` every 0.5 s, and the mission again every 2 s while an agent
// that introduced itself lacks it. A round advances when every live agent has closed
// it. An unanswered tick is sent again every second; an agent that leaves it unanswered for the deadline, says goodbye,
// or whose process is known to have ended, is dropped with the next tick. Agents that introduce themselves again come
// back with the next tick once they are matched. Faults on purpose hold a tick until their effect is confirmed. Time
// comes from the caller, in seconds of any steady clock.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "idl/bus/port.hpp"
#include "idl/convert/convert.hpp"
#include "simworld/lockstep/admission.hpp"
#include "simworld/lockstep/command_desk.hpp"
#include "simworld/lockstep/interventions.hpp"
#include "simworld/lockstep/pacer.hpp"
#include "simworld/lockstep/recorder.hpp"
#include "simworld/lockstep/recorder_gate.hpp"
#include "simworld/lockstep/repeats.hpp"
#include "simworld/lockstep/run.hpp"

namespace skein {

struct SessionOptions {
  std::uint64_t run = 0;    ///< id of the run, not 0
  std::uint64_t nonce = 0;  ///< the world's own, as its port announces it
  double startup_timeout_s = 30.0;
  double settle_s = 0.0;  ///< silence before the mission is published, in which another world may be found
  bool fail_fast = false;
  Pace pace;
  std::vector<Fault> faults;
  std::vector<RosterChange> replay;    ///< losses and returns of another run, repeated at the same rounds
  std::vector<OrderedAt> orders;       ///< what it was told, the same
  std::vector<InjectedAt> injections;  ///< and the obstacles that were put in its way
  bool wait_start = false;             ///< the mission starts when a command says so as well
  bool recorded = false;               ///< a recorder keeps every sample: the world waits for what recorded() says
  Recorder* recorder = nullptr;        ///< is told of each round before its tick goes out; nullptr for none
};

class WorldSession {
 public:
  enum class State : std::uint8_t { Waiting, Running, Closing, Done };

  /// @param control nullptr when nobody can act on processes; then `options.faults` must be empty.
  /// @throws std::invalid_argument for a bad mission, or faults without control.
  WorldSession(const Scenario& scenario, SessionOptions options, bus::WorldPort& port, ProcessControl* control,
               double now_s);

  /// Publishes the newest tick once more: for observers, who may have missed it.
  void remind(double now_s) { publish_tick(now_s); }
  /// Repeats what a world that died had recorded, in that order, before the first poll; nothing is sent.
  /// @throws std::invalid_argument, std::logic_error if it is not what this run came to
  void replay(const RoundInputs& inputs);
  void replay(const Fault& fault) { interventions_.forget(fault); }
  /// After that: goes on where the run stood. The open tick is repeated until all live agents are matched again, and
  /// its deadline begins then. @param restarts worlds that died before this one
  void resume(std::uint32_t restarts, double now_s);

  /// Takes what arrived and does what is due.
  void poll(double now_s);
  /// Seconds until the next poll has something to do, if nothing arrives before.
  [[nodiscard]] double idle_s(double now_s) const;

  /// The launcher says that an agent's process has ended.
  void process_ended(AgentId agent, double now_s);
  /// And that it is stopped, as it was told.
  void process_stopped(AgentId agent) { interventions_.process_stopped(agent); }
  /// The recorder has heard the tick of `round`, and lacks a sample of those agents' parts in it.
  void recorded(std::uint32_t round, std::vector<AgentId> lacking) { gate_.say(round, std::move(lacking)); }
  /// Nothing is recorded any more: nobody waits for it.
  void give_up_recorder() { gate_.give_up(); }
  /// Whether that is so, or the recorder left an answered round unrecorded for the deadline.
  [[nodiscard]] bool recorder_given_up() const { return gate_.given_up(); }
  /// The run must not start (another world has the swarm): ends with that exit code. Without effect once it runs.
  void refuse_start(const std::string& reason, double now_s, ExitCode code = ExitCode::StartUp);
  /// Does not wait for anybody any more.
  void give_up() { state_ = State::Done; }
  /// Ends the run now, with a final tick; reason and exit code go into it and into the report.
  void interrupt(std::string reason, int exit_code, double now_s);

  [[nodiscard]] State state() const { return state_; }
  /// Why the run never started; empty otherwise.
  [[nodiscard]] const std::string& start_failure() const { return start_failure_; }
  [[nodiscard]] bool interrupted() const { return interrupted_.has_value(); }
  /// What the run came to. @pre it is over
  [[nodiscard]] Outcome outcome() const;
  [[nodiscard]] const Run& run() const { return run_; }
  [[nodiscard]] std::size_t introduced() const { return admission_.introduced(); }
  /// Who has left the open tick unanswered for longer than that.
  [[nodiscard]] std::vector<AgentId> silent_for(double seconds, double now_s) const;
  [[nodiscard]] std::size_t matched() const { return admission_.matched(world_matched_); }
  [[nodiscard]] const TopicCounts& topics() const { return topics_; }
  [[nodiscard]] const PhaseTimes& times() const { return times_; }
  /// Ticks of a paced run that were answered too late.
  [[nodiscard]] std::uint32_t late_steps() const { return pacer_.late(); }
  [[nodiscard]] const FaultCounts& refused_samples() const { return faults_; }
  /// Faults on purpose, and roster changes to be repeated, whose moment never came. Once the run is over.
  [[nodiscard]] const std::vector<Fault>& unused_faults() const { return interventions_.unused_faults(); }
  [[nodiscard]] const std::vector<RosterChange>& unused_changes() const { return interventions_.unused_changes(); }
  [[nodiscard]] const CommandDesk& desk() const { return desk_; }
  [[nodiscard]] bool fail_fast() const { return options_.fail_fast; }
  [[nodiscard]] std::uint64_t run_id() const { return options_.run; }
  /// Worlds of this run that died before this one.
  [[nodiscard]] std::uint32_t world_restarts() const { return restarts_; }

 private:
  static constexpr double kWaitingTick_s = 0.5;

  void act(double now_s);
  void take(double now_s);
  void on_sample(const wire::Beacon& sample, double now_s);
  void on_sample(const wire::Representative& sample, double now_s);
  void on_sample(const wire::ObstacleMap& sample, double now_s);
  void on_sample(const wire::Command& sample, double now_s);
  void on_sample(const wire::Inject& sample, double now_s);
  template <typename Plain, typename Wire>
  void take_command(const Wire& sample, double now_s);
  void take_faults(const Moment& moment, double now_s);
  void take_orders_waiting(double now_s);
  [[nodiscard]] Steered take_start(double now_s);
  /// What a live agent shares with all others.
  template <typename Sample, typename Wire>
  void collect(const Wire& sample, TopicCount& count);
  void repeat(const Repeated& samples, double now_s);
  void poll_waiting(double now_s);
  void poll_running(double now_s);
  void poll_closing(double now_s);
  void drop_silent(double now_s);
  void add_loss(AgentId agent, LossReason reason);
  [[nodiscard]] bool is_live(AgentId agent) const;
  [[nodiscard]] bool is_recorded(double now_s);
  [[nodiscard]] bool is_held(double now_s);
  void find_returning(double now_s);
  void start(double now_s);
  void close(double now_s);
  void advance(double now_s);
  void go_on(const Tick& next, double now_s);
  void open(const Tick& tick, double now_s);
  void expect(const Tick& tick, double now_s);
  void repeat_tick(double now_s);
  void record_round(const Steered& steered, double now_s) const;
  void rematch(double now_s);
  void publish_mission(double now_s);
  void publish_tick(double now_s);
  void publish_sense(const RosterEntry& entry, double now_s);
  template <typename Value>
  void send(const Value& value, TopicCount& count, double now_s);

  Mission mission_;
  double deadline_s_;
  SessionOptions options_;
  bus::WorldPort& port_;
  Pacer pacer_;
  Run run_;
  Admission admission_;
  Interventions interventions_;
  CommandDesk desk_;
  Barrier barrier_;
  RecorderGate gate_;
  State state_ = State::Waiting;
  Tick tick_;
  std::vector<Loss> lost_;         ///< to be dropped with the next tick
  std::vector<RosterEntry> back_;  ///< to come back with it
  Repeats repeats_;
  double last_sent_s_ = -1e9;
  double mission_sent_s_ = -1e9;
  double all_have_mission_s_ = -1e9;  ///< when last no agent that had introduced itself lacked it
  double startable_s_ = -1e9;         ///< when last all were there, and a start was waited for
  double pause_until_s_ = -1e9;       ///< for a newcomer that has heard no tick yet
  std::optional<double> last_poll_s_;
  double away_s_ = 0.0;  ///< time since the open tick in which nobody polled: it counts against no agent
  std::uint32_t restarts_ = 0;
  std::optional<double> resumed_s_;  ///< since when a world that was started again looks for its agents
  SessionFigures replayed_;          ///< of the last round that was repeated
  std::vector<std::uint64_t> world_matched_;
  std::vector<bus::WorldInbound> inbox_;
  std::string start_failure_;
  std::optional<Outcome> interrupted_;
  TopicCounts topics_;
  PhaseTimes times_;
  FaultCounts faults_;
};

}  // namespace skein
