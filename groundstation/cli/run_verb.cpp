// skein run SCENARIO: one run, as processes over DDS or in this process.
#include <fmt/core.h>
#include <spdlog/spdlog.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>

#include "groundstation/attach/attach.hpp"
#include "groundstation/cli/run_display.hpp"
#include "groundstation/cli/verbs.hpp"
#include "groundstation/inprocess/in_process.hpp"
#include "groundstation/launch/launcher.hpp"
#include "groundstation/output/output_file.hpp"
#include "groundstation/record/barrier_recorder.hpp"
#include "groundstation/record/recording_file.hpp"
#include "groundstation/record/tap.hpp"
#include "idl/process/poll.hpp"
#include "simworld/checkpoint/checkpoint.hpp"
#include "simworld/process/progress.hpp"
#include "simworld/process/world_process.hpp"
#include "simworld/report/report.hpp"
#include "simworld/report/steering_report.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

struct RunArguments {
  WorldArguments world;
  bool in_process = false;
  bool attach = false;
  bool json = false;
  std::size_t per_process = 1;
  std::string roster;
  std::string record;
};

std::string binaries_folder() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
}

std::vector<std::string> world_arguments(const RunArguments& arguments, const std::string& folder) {
  std::vector<std::string> flags = arguments_of(arguments.world.common);
  flags.insert(flags.end(), {"--out", folder, "--settle-time", fmt::format("{}", arguments.world.settle_s)});
  if (arguments.world.seed) flags.insert(flags.end(), {"--seed", std::to_string(*arguments.world.seed)});
  if (arguments.world.fail_fast) flags.emplace_back("--fail-fast");
  if (!arguments.record.empty()) flags.emplace_back("--recorded");
  if (arguments.world.wait_start) flags.emplace_back("--wait-start");
  if (arguments.world.realtime > 0.0)
    flags.insert(flags.end(), {"--realtime", fmt::format("{}", arguments.world.realtime)});
  if (!arguments.world.checkpoint.empty()) {
    flags.insert(flags.end(), {"--checkpoint", arguments.world.checkpoint});
    if (arguments.world.checkpoint_sync) flags.emplace_back("--checkpoint-sync");
  }
  for (const Override& item : arguments.world.overrides) {
    flags.insert(flags.end(), {"--set", item.key + "=" + item.value});
  }
  for (const Fault& fault : arguments.world.faults) flags.insert(flags.end(), {"--fault", text_of(fault)});
  flags.insert(flags.end(), {"--", arguments.world.scenario});
  return flags;
}

/// Adds what only the launcher knows: pids, memory, exit statuses, its own signal.
void complete(Json& report, const Launcher& launcher) {
  double pss_sum_mb = 0.0;
  std::size_t measured = 0;
  Json processes = Json::array();
  for (const AgentProcess& process : launcher.agents()) {
    for (Json& vehicle : report["vehicles"]) {
      if (vehicle["id"] == process.id) vehicle["pid"] = process.pid;
    }
    if (process.pss_mb) {
      pss_sum_mb += *process.pss_mb;
      ++measured;
    }
    processes.push_back({{"agent", process.id},
                         {"pid", process.pid},
                         {"ended_by", process.wait_status ? describe_status(*process.wait_status) : "unknown"}});
  }
  if (measured > 0) report["pss_mb_per_agent"] = pss_sum_mb / static_cast<double>(measured);
  report["processes"] = processes;
  report["world_recovery_s"] = launcher.recoveries_s();
  std::set<pid_t> named;
  for (const AgentProcess& process : launcher.agents()) {
    const auto is_own = [&](const Json& change) { return change["agent"] == process.id; };
    if (!process.wait_status || *process.wait_status == 0) continue;
    if (std::ranges::none_of(report["roster_changes"], is_own) || !named.insert(process.pid).second) continue;
    report["reason"] = fmt::format("{} (process {} of agent {}: {})", report["reason"].get<std::string>(), process.pid,
                                   process.id, describe_status(*process.wait_status));
  }
  if (launcher.signal()) {
    report["success"] = false;
    report["exit_code"] = 128 + *launcher.signal();
    report["reason"] = fmt::format("ended by {}", *launcher.signal() == SIGINT ? "SIGINT" : "SIGTERM");
  }
}

/// The exit code when the world left no report: it refused its arguments, or died. Says why in one line.
int without_report(int wait_status, const Launcher& launcher, const std::string& folder) {
  if (launcher.signal()) return 128 + *launcher.signal();
  std::ifstream file(folder + "/world.log");
  const std::string log{std::istreambuf_iterator<char>(file), {}};
  const bool refused = WIFEXITED(wait_status) && WEXITSTATUS(wait_status) != 0;
  if (refused && !log.empty()) {
    std::cerr << log;
    return WEXITSTATUS(wait_status);
  }
  std::cerr << fmt::format("the world ended without a report: {} (log: {}/world.log)\n", describe_status(wait_status),
                           folder);
  return static_cast<int>(ExitCode::AgentLost);
}

/// Writes the report and shows it. @return the run's exit code, or 1 if the report could not be written or printed
int deliver(const Json& report, const std::string& folder, const RunDisplay& display) {
  const int exit_code = report["exit_code"].get<int>();
  try {
    write_json(folder + "/report.json", report);
    display.result(report, folder);
    if (!std::cout) throw std::runtime_error("cannot write to standard output");
    return exit_code;
  } catch (const std::exception& error) {
    std::cerr << fmt::format("skein run: {}; the run: {}\n", error.what(), report["reason"].get<std::string>());
    return exit_code == 0 ? static_cast<int>(ExitCode::Failed) : exit_code;
  }
}

/// A run that was to be recorded, and is not whole there, has failed.
void note_fault_of_record(std::string fault, std::uint64_t lost, const std::string& path, Json& report) {
  if (fault.empty() && lost > 0) fault = fmt::format("{}: {} samples are missing", path, lost);
  if (fault.empty()) return;
  report["reason"] = fmt::format("{}; {}", report["reason"].get<std::string>(), fault);
  report["success"] = false;
  if (report["exit_code"] == 0) report["exit_code"] = static_cast<int>(ExitCode::Failed);
}

int run_processes(RunArguments& arguments, RunDisplay& display, const Scenario& scenario) {
  if (arguments.world.common.swarm.empty()) {
    arguments.world.common.swarm = fmt::format("run-{:016x}", random_id());
    arguments.world.settle_s = 0.0;  // nobody else can have this swarm
  }
  const std::string folder = prepare_out(arguments.world.out, scenario);
  std::filesystem::remove(folder + "/report.json");
  Launcher launcher({binaries_folder(), folder, world_arguments(arguments, folder),
                     arguments_of(arguments.world.common), arguments.per_process,
                     [&](const auto& state) { display.show(state); }, !arguments.world.checkpoint.empty(),
                     [&](const auto& how) { display.note(fmt::format("the world died of {}: started again", how)); }});
  std::optional<BarrierRecorder> record;
  if (!arguments.record.empty()) {
    record.emplace(arguments.world.common, arguments.record, scenario, arguments.world.fail_fast);
    launcher.listen(record->wake_fd(), [&] { return record->serve(); });
  }
  const int status = launcher.run();
  display.end();
  std::ifstream file(folder + "/report.json");
  Json report = Json::parse(file, nullptr, false);
  if (report.is_discarded()) {
    if (record) record->finish(nullptr);
    return without_report(status, launcher, folder);
  }
  complete(report, launcher);
  if (record) {
    record->finish(report);
    note_fault_of_record(record->failure(), record->lost(), arguments.record, report);
  }
  return deliver(report, folder, display);
}

nlohmann::json read_report(const std::string& path) {
  std::ifstream file(path);
  nlohmann::json report = nlohmann::json::parse(file, nullptr, false);
  if (!report.is_object()) throw std::runtime_error(fmt::format("--roster {}: no readable report", path));
  return report;
}

int run_here(const RunArguments& arguments, RunDisplay& display, const Scenario& scenario) {
  InProcessOptions options;
  options.faults = arguments.world.faults;
  options.fail_fast = arguments.world.fail_fast;
  options.checkpoint = arguments.world.checkpoint;
  std::string expected_hash;
  if (!arguments.roster.empty()) {
    const nlohmann::json other = read_report(arguments.roster);
    const std::string obstacle = replay_obstacle(other, scenario, options.fail_fast);
    if (!obstacle.empty()) throw std::runtime_error(fmt::format("--roster {}: {}", arguments.roster, obstacle));
    options.replay = roster_changes_of(other);
    options.orders = orders_of(other);
    options.injections = injections_of(other);
    expected_hash = other.value("state_hash", "");
  }
  const SignalWatch signals({SIGINT, SIGTERM});
  options.signal = [&] { return signals.take(); };
  ProgressFeed feed([&](const auto& progress, bool) { display.show(progress); });
  options.on_round = [&](const WorldSession& session) { feed.show(session, steady_now_s()); };
  const std::string folder = prepare_out(arguments.world.out, scenario);
  std::optional<RecordingFile> record;
  if (!arguments.record.empty()) {
    record.emplace(arguments.record, RecordingOrigin{"in-process", "", &scenario, options.fail_fast});
    options.tap = tap_into([&](const TakenSample& sample) { record->add(sample); });
  }
  InProcessResult result = run_in_process(scenario, options);
  display.end();
  if (!expected_hash.empty() && result.report["state_hash"] != expected_hash) {
    result.report["reason"] = fmt::format("{}; the replay differs: state hash {} in {}",
                                          result.report["reason"].get<std::string>(), expected_hash, arguments.roster);
    result.report["success"] = false;
    if (result.exit_code == 0) result.report["exit_code"] = static_cast<int>(ExitCode::Failed);
  }
  if (record) {
    record->finish({{"lost", "0"}}, result.report);
    note_fault_of_record(record->failure(), 0, arguments.record, result.report);
  }
  return deliver(result.report, folder, display);
}

int watch(const RunArguments& arguments, RunDisplay& display) {
  const Attached attached = attach(arguments.world.common, [&](const auto& state) { display.show(state); });
  display.end();
  if (attached.result.is_null()) {
    std::cerr << "skein run --attach: " << attached.reason << "\n";
  } else {
    display.outcome(attached.result);
  }
  return attached.exit_code;
}

int run(RunArguments& arguments) {
  RunDisplay display(arguments.json);
  try {
    if (arguments.attach) return watch(arguments, display);
    if (arguments.world.scenario.empty()) throw std::runtime_error("SCENARIO is required, or --attach");
    if (!arguments.roster.empty() && !arguments.in_process) {
      throw std::runtime_error("--roster replays in process: add --in-process");
    }
    if (arguments.world.realtime > 0.0 && arguments.in_process) {
      throw std::runtime_error("--realtime paces processes: leave --in-process out");
    }
    if (arguments.world.wait_start && arguments.in_process) {
      throw std::runtime_error("--wait-start waits for a command: leave --in-process out");
    }
    if (!arguments.record.empty()) check_output(arguments.record, {arguments.world.scenario, arguments.roster});
    const std::optional<Scenario> scenario = load_or_complain(arguments.world);
    if (!scenario) return static_cast<int>(ExitCode::Usage);
    const std::string& checkpoint = arguments.world.checkpoint;
    if (!checkpoint.empty() && Checkpoint::exists(checkpoint)) {
      throw std::runtime_error(
          fmt::format("--checkpoint {}: it holds a run already; while that one's agents live, "
                      "skein-simworld goes on with it",
                      checkpoint));
    }
    return arguments.in_process ? run_here(arguments, display, *scenario)
                                : run_processes(arguments, display, *scenario);
  } catch (const StartFailure& error) {
    display.end();
    std::cerr << "skein run: " << error.what() << "\n";
    return static_cast<int>(ExitCode::StartUp);
  } catch (const std::exception& error) {
    display.end();
    std::cerr << "skein run: " << error.what() << "\n";
    return static_cast<int>(ExitCode::Usage);
  }
}

}  // namespace

VerbAction add_run_verb(CLI::App& app) {
  const auto named = [](const std::string& file) { return file.empty() ? "it names no file" : std::string(); };
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* verb = app.add_subcommand("run", "run a scenario: one world, one agent process a vehicle");
  add_common_flags(*verb, arguments->world.common);
  add_world_options(*verb, arguments->world);
  verb->add_flag("--in-process", arguments->in_process, "all in this process, over the in-memory bus");
  verb->add_option("--roster", arguments->roster,
                   "with --in-process: repeat the losses and commands of this report.json");
  verb->add_option("--record", arguments->record, "FILE.mcap: keep every sample of the run (docs/recording.md)")
      ->check(named);
  verb->add_option("--per-process", arguments->per_process, "vehicles that share an agent process, 1 to 256")
      ->check(CLI::Range(std::size_t{1}, std::size_t{kMaxAgents}))
      ->capture_default_str();
  CLI::Option* attach = verb->add_flag("--attach", arguments->attach,
                                       "watch a run that others started, until it ends; its exit code is this one's");
  verb->get_option("SCENARIO")->required(false);
  for (const char* name : {"SCENARIO", "--seed", "--set", "--planner", "--controller", "--agents", "--out",
                           "--realtime", "--fail-fast", "--fault", "--wait-start", "--checkpoint", "--checkpoint-sync",
                           "--in-process", "--roster", "--record", "--per-process"}) {
    attach->excludes(verb->get_option(name));
  }
  verb->add_flag("--json", arguments->json, "print the report as JSON on standard output");
  verb->footer("Example: skein run deploy/scenarios/rendezvous-2d.yaml --seed 1");
  return [arguments] { return run(*arguments); };
}

}  // namespace skein
