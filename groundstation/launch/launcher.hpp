// Runs a swarm as processes of this machine: one world, one agent process a vehicle (or for several), and the end of
// all of them.
//
// The launcher starts the world with its own flags, and the agents that the world names over the control channel. It
// tells the world at once when an agent's process ends, carries out faults on purpose, passes the first SIGINT or
// SIGTERM on to the world, and ends everything at the second. When the world has ended, agents that are left get a few
// seconds to end by themselves, then SIGTERM, then SIGKILL. Children die with the launcher. A world with a checkpoint
// that a signal ended is started again, kWorldRestarts times at most, and told which agents have ended or stand still.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "groundstation/launch/child.hpp"
#include "idl/process/signals.hpp"
#include "planner/core/mission/mission.hpp"
#include "simworld/control/control_channel.hpp"

namespace skein {

/// The processes cannot be started: one line says why.
struct StartFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How often a world is started again in one run.
inline constexpr std::uint32_t kWorldRestarts = 20;

struct LaunchPlan {
  std::string binaries;                      ///< folder of skein-simworld and skein-agent
  std::string out;                           ///< folder of the logs
  std::vector<std::string> world_arguments;  ///< without --control-fd
  std::vector<std::string> agent_arguments;  ///< without --id
  std::size_t per_process = 1;               ///< vehicles that share an agent process
  std::function<void(const nlohmann::json&)> on_progress;
  bool restart_world = false;                                     ///< it has a checkpoint
  std::function<void(const std::string&)> on_world_restart = {};  ///< says in one line how the world had ended
};

/// How one agent's process went; the same for all that share it.
struct AgentProcess {
  unsigned id = 0;
  pid_t pid = 0;
  std::optional<int> wait_status = {};
  std::optional<double> pss_mb = {};  ///< when the flight began, the agent's share
};

class Launcher {
 public:
  /// Blocks SIGINT, SIGTERM and SIGCHLD: construct it before any thread.
  explicit Launcher(LaunchPlan plan);

  /// From now on `serve` is called whenever `fd` is readable, and often besides; what it returns goes to the world.
  void listen(int fd, std::function<std::optional<nlohmann::json>()> serve);
  /// Runs until every process has ended. @return the world's wait status. @throws StartFailure
  int run();

  /// All that were started, in that order: several of one agent, if it was restarted.
  [[nodiscard]] const std::vector<AgentProcess>& agents() const { return records_; }
  /// Of each world that was started again: seconds from the end of the one before to the next round.
  [[nodiscard]] const std::vector<double>& recoveries_s() const { return recoveries_s_; }
  /// The first SIGINT or SIGTERM that the launcher got.
  [[nodiscard]] std::optional<int> signal() const { return signal_; }

 private:
  /// Agents that share a process, and the process that they have now.
  struct Group {
    std::vector<AgentId> ids;
    std::unique_ptr<Child> child;
    std::size_t record = 0;  ///< of the first
  };
  void start_world();
  void serve_world();
  [[nodiscard]] bool may_restart_world();
  void tell_ends();
  void start_agents(const std::vector<AgentId>& ids);
  void start(Group& group);
  void take_messages();
  void act_on(const nlohmann::json& message);
  void act_on(Group& group, std::string_view order, AgentId id);
  void take_signals();
  void reap();
  void note_end(Group& group);
  void note_memory();
  void note_recovery(std::uint32_t round);
  void serve_listened();
  void end_agents();
  [[nodiscard]] bool agents_running();

  LaunchPlan plan_;
  SignalWatch signals_;
  std::unique_ptr<ControlChannel> channel_;
  std::unique_ptr<Child> world_;
  std::vector<Group> groups_;
  std::vector<AgentProcess> records_;
  std::optional<int> signal_;
  double signalled_s_ = 0.0;
  bool memory_noted_ = false;
  std::uint32_t world_restarts_ = 0;
  std::optional<double> world_died_s_;
  std::optional<std::uint32_t> repeated_round_;  ///< that was open when it died
  std::vector<double> recoveries_s_;
  int listened_fd_ = -1;
  std::function<std::optional<nlohmann::json>()> serve_;
};

}  // namespace skein
