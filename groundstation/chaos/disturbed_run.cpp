#include "groundstation/chaos/disturbed_run.hpp"

#include <fmt/core.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "groundstation/chaos/judgement.hpp"
#include "groundstation/chaos/partition.hpp"
#include "groundstation/chaos/traces.hpp"
#include "groundstation/launch/child.hpp"
#include "idl/process/common_flags.hpp"
#include "idl/process/poll.hpp"

namespace skein::chaos {
namespace {

constexpr double kLook_s = 0.005;
constexpr double kOrphan_s = 5.0;    ///< for what is ending anyway
constexpr double kStopped_s = 0.04;  ///< of a slow agent: stopped, and then running
constexpr double kGoing_s = 0.01;

class DisturbedRun {
 public:
  DisturbedRun(const RunPlan& plan, const Injection& injection)
      : plan_(plan),
        injection_(injection),
        swarm_(fmt::format("chaos-{:016x}", random_id())),
        scratch_(plan.folder + "/tmp"),
        shared_(shared_files()) {
    std::filesystem::create_directories(scratch_);
    setenv("TMPDIR", scratch_.c_str(), 1);
  }

  RunOutcome run() {
    outcome_.seed = plan_.scenario.mission.seed;
    outcome_.kind = injection_.kind.kind;
    outcome_.fault = text_of(injection_);
    outcome_.befallen = injection_.cut;
    if (injection_.agent != kWorldId) outcome_.befallen.push_back(injection_.agent);
    outcome_.injected = injection_.for_s == 0.0;  // at a tick, or below DDS for as long as the run lasts
    start_s_ = steady_now_s();
    Child child = start();
    if (injection_.kind.kind == Kind::Pause) pause(child);
    if (injection_.kind.kind == Kind::Slow) slow_down(child);
    if (injection_.kind.kind == Kind::Partition) cut_off(child);
    wait(child, plan_.limit_s + start_s_ - steady_now_s());
    finish(child);
    outcome_.wall_s = steady_now_s() - start_s_;
    look_for_traces();
    if (outcome_.result == Result::Completed) judge(report_of(), plan_.scenario, outcome_);
    return outcome_;
  }

 private:
  [[nodiscard]] std::string out() const { return plan_.folder + "/run"; }
  [[nodiscard]] std::string log() const { return plan_.folder + "/run.log"; }

  Child start() const {
    std::vector<std::string> arguments{"run", "--swarm", swarm_, "--out", out()};
    for (const Fault& fault : injection_.script) arguments.insert(arguments.end(), {"--fault", skein::text_of(fault)});
    if (injection_.kind.kind == Kind::World) {
      arguments.insert(arguments.end(), {"--checkpoint", plan_.folder + "/checkpoint"});
    }
    if (injection_.realtime > 0.0) {
      arguments.insert(arguments.end(), {"--realtime", fmt::format("{:.3f}", injection_.realtime)});
    }
    arguments.insert(arguments.end(), plan_.arguments.begin(), plan_.arguments.end());
    const std::string program = plan_.binaries + "/skein";
    if (!needs_network(injection_.kind.kind)) return {program, arguments, log(), -1};
    const std::string script = network_script(injection_.kind) + " && exec \"$@\"";
    arguments.insert(arguments.begin(), {"--net", "/bin/sh", "-c", script, "sh", program});
    return {"/usr/bin/unshare", arguments, log(), -1};
  }

  /// @return whether the run is over, or the campaign
  bool wait(Child& child, double seconds) const {
    const double until_s = steady_now_s() + seconds;
    while (child.running() && !plan_.interrupted()) {
      if (steady_now_s() >= until_s) return false;
      wait_readable({}, kLook_s);
    }
    return true;
  }

  /// Waits until the flight has begun. @return whether it has
  bool in_flight(Child& child) const {
    while (!wait(child, kLook_s) && steady_now_s() - start_s_ < plan_.limit_s) {
      std::ifstream file(log());
      const std::string text{std::istreambuf_iterator<char>(file), {}};
      if (text.find("flight: step") != std::string::npos) return true;
    }
    return false;
  }

  void pause(Child& child) {
    if (!in_flight(child) || wait(child, injection_.after_s)) return;
    const auto agent = process_of(swarm_, injection_.agent);
    if (!agent) return;
    outcome_.injected = kill(*agent, SIGSTOP) == 0;
    wait(child, injection_.for_s);
    kill(*agent, SIGCONT);
  }

  void cut_off(Child& child) {
    if (!in_flight(child) || wait(child, injection_.after_s)) return;
    std::vector<pid_t> cut;
    for (const AgentId agent : injection_.cut) {
      if (const auto process = process_of(swarm_, agent)) cut.push_back(*process);
    }
    std::vector<pid_t> others = processes_with(swarm_);
    std::erase_if(others, [&](pid_t process) { return std::ranges::find(cut, process) != cut.end(); });
    const std::set<std::uint16_t> ports = ports_of_one_side(cut, others);
    const std::string scratch = plan_.folder + "/partition";
    const bool made = !ports.empty() && put_rules(child.pid(), partition_rules(ports), scratch);
    if (!made && child.running()) outcome_.unexplained.push_back("the partition could not be made");
    outcome_.injected = made;
    wait(child, injection_.for_s);
    const bool healed = put_rules(child.pid(), partition_rules({}), scratch);
    if (!healed && child.running()) outcome_.unexplained.push_back("the partition could not be healed");
  }

  void slow_down(Child& child) {
    std::optional<pid_t> agent;
    while (!agent && !wait(child, kLook_s) && steady_now_s() - start_s_ < plan_.limit_s) {
      agent = process_of(swarm_, injection_.agent);
    }
    const double until_s = steady_now_s() + injection_.for_s;
    while (agent && steady_now_s() < until_s) {
      if (kill(*agent, SIGSTOP) == 0) outcome_.injected = true;
      wait(child, kStopped_s);
      kill(*agent, SIGCONT);
      if (wait(child, kGoing_s)) return;
    }
  }

  void finish(Child& child) {
    if (child.running()) {
      outcome_.result = plan_.interrupted() ? Result::Stopped : Result::Hung;
      outcome_.reason = fmt::format("it did not end within {:.0f} s", plan_.limit_s);
      child.signal(SIGTERM);
      const double until_s = steady_now_s() + kOrphan_s;
      while (child.running() && steady_now_s() < until_s) wait_readable({}, kLook_s);
      child.kill_and_reap();
      return;
    }
    const int status = *child.status();
    outcome_.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (WIFSIGNALED(status)) outcome_.unexplained.push_back(fmt::format("skein run: {}", describe_status(status)));
  }

  void look_for_traces() {
    const double until_s = steady_now_s() + kOrphan_s;
    while (!processes_with(swarm_).empty() && steady_now_s() < until_s) wait_readable({}, kLook_s);
    for (const pid_t pid : processes_with(swarm_)) {
      outcome_.orphans.push_back(fmt::format("process {}", pid));
      kill(pid, SIGKILL);
    }
    for (const std::string& name : files_in(scratch_)) outcome_.leftovers.push_back(scratch_ + "/" + name);
    for (const std::string& name : shared_files()) {
      if (!shared_.contains(name)) outcome_.leftovers.push_back("/dev/shm/" + name);
    }
  }

  [[nodiscard]] nlohmann::json report_of() const {
    std::ifstream file(out() + "/report.json");
    return nlohmann::json::parse(file, nullptr, false);
  }

  const RunPlan& plan_;
  const Injection& injection_;
  std::string swarm_;
  std::string scratch_;
  std::set<std::string> shared_;
  double start_s_ = 0.0;
  RunOutcome outcome_;
};

}  // namespace

RunOutcome run_disturbed(const RunPlan& plan, const Injection& injection) {
  return DisturbedRun(plan, injection).run();
}

}  // namespace skein::chaos
