// What is done to agents on purpose, and what a tick waits for because of it: faults, and the roster changes of another
// run that are repeated.
//
// A fault or a repeated change is due when the tick of its moment is about to be opened. That tick is held until the
// effect is confirmed, of several faults on one agent one after the other:
//   kill      the process is gone
//   stop      the process is stopped: the tick goes out, and the deadline drops the agent
//   cont      of a dropped agent: it has introduced itself again and is matched; of a live one: nothing
//   restart   the process, if there was one, is gone, and the new one has introduced itself and is matched
// The world's own death comes first of all that is due at a moment: the rest is left to the world that takes its place.
// A repeated loss ends the process, a repeated return starts another one. Source: own.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "simworld/lockstep/faults.hpp"
#include "simworld/lockstep/recorder.hpp"
#include "simworld/lockstep/run.hpp"

namespace skein {

/// Acts on agent processes on the world's behalf. The effects are confirmed by WorldSession::process_ended and
/// process_stopped, and by the agents' own introductions.
class ProcessControl {
 public:
  virtual ~ProcessControl() = default;
  virtual void kill(AgentId agent) = 0;
  virtual void stop(AgentId agent) = 0;
  virtual void cont(AgentId agent) = 0;
  /// Ends the agent's process, if it has one, and starts another.
  virtual void restart(AgentId agent) = 0;
};

class Interventions {
 public:
  using IsLive = std::function<bool(AgentId)>;

  /// @param control nullptr when nobody can act on processes; then there may be no faults, and repeated returns wait
  /// for agents that somebody else starts. @throws std::invalid_argument for faults without control
  Interventions(std::vector<Fault> faults, std::vector<RosterChange> replay, ProcessControl* control);

  /// Who is told of each fault before it is carried out; nullptr for nobody.
  void set_recorder(Recorder* recorder) { recorder_ = recorder; }
  /// Whether there is anybody who acts on processes.
  [[nodiscard]] bool can_act() const { return control_ != nullptr; }
  [[nodiscard]] bool is_ended(AgentId agent) const { return process_of(agent) == Process::Ended; }
  /// One more. @pre can_act()
  void add(const Fault& fault) { faults_.push_back(fault); }
  /// The fault was carried out for a world that has died since.
  void forget(const Fault& fault);

  /// Takes out the repeated changes that are due at `round`. @return the losses; the returns are awaited
  [[nodiscard]] std::vector<Loss> repeat(std::uint32_t round, std::span<const RosterEntry> roster, double now_s);
  /// Ends the process of a repeated loss, of which the world knows already.
  void end(AgentId agent);
  /// Starts the agents of repeated returns, and carries out the faults due at `moment` on agents for which nothing is
  /// awaited. @return whether anything was done
  bool carry_out(const Moment& moment, const IsLive& live, double now_s);

  void process_ended(AgentId agent);
  void process_stopped(AgentId agent);

  /// Whether the tick waits for anything, when `back` are ready to return. Once it does not, all is confirmed.
  [[nodiscard]] bool holds(std::span<const RosterEntry> back);
  [[nodiscard]] bool holding() const { return !awaited_.empty(); }
  [[nodiscard]] bool awaits_return() const;
  /// Whether an agent may come back with the coming tick: in a replay only those whose return is due.
  [[nodiscard]] bool may_return(AgentId agent) const;
  [[nodiscard]] bool is_stopped(AgentId agent) const;
  /// Why the run must end: an effect that did not come. @param patience_s for a process to end or to stop
  /// @param return_patience_s for a new process to be matched
  [[nodiscard]] std::optional<std::string> failure(double now_s, double patience_s, double return_patience_s) const;

  [[nodiscard]] const std::vector<Fault>& unused_faults() const { return faults_; }
  [[nodiscard]] const std::vector<RosterChange>& unused_changes() const { return replay_; }

 private:
  enum class Process : std::uint8_t { Running, Stopped, Ended };
  struct Awaited {
    AgentId agent = 0;
    bool end = false;     ///< the process is to end
    bool stop = false;    ///< it is to stop
    bool back = false;    ///< the agent is to come back
    bool start = false;   ///< and its process has still to be started
    bool failed = false;  ///< its process ended while it was to come back
    double since_s = 0.0;
  };
  /// @return whether the fault could be carried out
  bool carry_out(const Fault& fault, bool live, double now_s);
  void forget_confirmed();
  [[nodiscard]] bool is_awaited(AgentId agent) const;
  [[nodiscard]] Process process_of(AgentId agent) const;

  std::vector<Fault> faults_;
  std::vector<RosterChange> replay_;
  bool replaying_;
  std::uint32_t repeated_round_ = 0;
  std::vector<AgentId> expected_;  ///< of a replay: who comes back at that round
  ProcessControl* control_;
  Recorder* recorder_ = nullptr;
  std::map<AgentId, Process> processes_;  ///< without an entry: running
  std::vector<Awaited> awaited_;
};

}  // namespace skein
