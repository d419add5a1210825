// skein chaos SCENARIO: many runs over real processes, each with a fault, and a table of what came of them.
#include <fmt/chrono.h>
#include <fmt/core.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>

#include "groundstation/chaos/campaign.hpp"
#include "groundstation/cli/verbs.hpp"
#include "groundstation/output/output_file.hpp"
#include "groundstation/sweep/journal.hpp"
#include "groundstation/sweep/junit.hpp"
#include "groundstation/sweep/progress.hpp"
#include "idl/process/number_within.hpp"
#include "idl/process/poll.hpp"
#include "idl/process/signals.hpp"
#include "simworld/lockstep/map_watch.hpp"
#include "simworld/lockstep/run.hpp"
#include "simworld/process/world_process.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDeadlineKey = "lockstep.deadline_s";
constexpr const char* kExtraKey = "world.extra_steps";
constexpr std::uint32_t kMostExtra = 20'000;  ///< steps: a radio that needs more is not waited for
constexpr const char* kDeadline = "2";        ///< a campaign would wait for most of its time else

struct ChaosArguments {
  WorldArguments world;
  std::uint32_t runs = 10;
  std::string faults;
  double limit_s = 120.0;
  std::string junit;
  std::string resume;
  bool json = false;
};

/// Refused ones are in `refused`, by name; of a file all must be possible. @throws std::runtime_error
std::vector<chaos::Disturbance> kinds_of(const std::string& path, std::map<std::string, std::string>& refused) {
  std::vector<chaos::Disturbance> kinds = chaos::all_kinds();
  if (!path.empty()) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(fmt::format("--faults {}: it cannot be read", path));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    auto read = chaos::read_kinds(text, path);
    if (const auto* fault = std::get_if<std::string>(&read)) throw std::runtime_error(*fault);
    kinds = std::get<std::vector<chaos::Disturbance>>(std::move(read));
  }
  std::erase_if(kinds, [&](const chaos::Disturbance& kind) {
    const auto obstacle = chaos::obstacle_to(kind.kind);
    if (obstacle) refused[std::string(chaos::name_of(kind.kind))] = *obstacle;
    return obstacle.has_value();
  });
  if (!path.empty() && !refused.empty()) {
    throw std::runtime_error(fmt::format("--faults {}: {} {}", path, refused.begin()->first, refused.begin()->second));
  }
  return kinds;
}

std::string folder_of(const ChaosArguments& arguments) {
  if (!arguments.world.out.empty()) return std::filesystem::absolute(arguments.world.out).string();
  const auto now = std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
  return std::filesystem::absolute(fmt::format("skein-runs/chaos-{:%Y%m%dT%H%M%S}", fmt::gmtime(now))).string();
}

chaos::CampaignPlan plan_of(ChaosArguments& arguments, const Scenario& scenario) {
  chaos::CampaignPlan plan;
  plan.binaries = std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
  plan.folder = folder_of(arguments);
  plan.scenario = scenario;
  plan.seed = scenario.mission.seed;
  plan.runs = arguments.runs;
  plan.limit_s = arguments.limit_s;
  plan.journal = arguments.resume;
  const CommonFlags& common = arguments.world.common;
  plan.arguments = {"--domain",          std::to_string(common.domain),
                    "--profile",         common.profile,
                    "--log-level",       common.log_level,
                    "--startup-timeout", fmt::format("{}", common.startup_timeout_s)};
  for (const Override& item : arguments.world.overrides) {
    plan.arguments.insert(plan.arguments.end(), {"--set", item.key + "=" + item.value});
  }
  plan.arguments.insert(plan.arguments.end(), {"--", arguments.world.scenario});
  return plan;
}

void print(const Json& summary, const std::map<std::string, std::string>& refused, bool json) {
  if (json) {
    std::cout << summary.dump(2) << "\n";
    return;
  }
  std::cout << chaos::text_of(summary);
  for (const auto& [kind, why] : refused) std::cout << fmt::format("{} was left out: {}\n", kind, why);
}

/// A case a run; what broke no invariant did not fail.
std::string junit_of(const Scenario& scenario, const std::vector<chaos::RunOutcome>& outcomes, std::size_t runs) {
  JunitSuite suite{scenario.mission.name, {}};
  for (const chaos::RunOutcome& outcome : outcomes) {
    JunitCase one{fmt::format("seed {}, {}", outcome.seed, outcome.fault), "", ""};
    if (!chaos::is_sound(outcome)) {
      one.failure = outcome.reason.empty() ? "an invariant does not hold" : outcome.reason;
      one.type = fmt::format("exit code {}", outcome.exit_code);
    }
    suite.cases.push_back(std::move(one));
  }
  if (outcomes.size() < runs) suite.cases.push_back(junit_of_missing(outcomes.size(), runs));
  return junit_xml("skein chaos", {suite});
}

/// Does it to the file of --junit, if there is to be one. @throws std::runtime_error that names the flag
void guarded_junit(const ChaosArguments& arguments, const std::function<void(const std::string&)>& action) try {
  if (!arguments.junit.empty()) action(arguments.junit);
} catch (const std::runtime_error& error) {
  throw std::runtime_error(fmt::format("--junit: {}", error.what()));
}

int campaign(ChaosArguments& arguments, const Scenario& scenario) {
  std::map<std::string, std::string> refused;
  chaos::CampaignPlan plan = plan_of(arguments, scenario);
  plan.kinds = kinds_of(arguments.faults, refused);
  const SignalWatch signals({SIGINT, SIGTERM});
  std::optional<int> signal;
  plan.interrupted = [&] {
    if (const auto arrived = signals.take()) signal = arrived;
    return signal.has_value();
  };
  guarded_junit(arguments, [&](const std::string& file) {
    check_output(file, {arguments.world.scenario, arguments.faults, arguments.resume});
  });
  plan.on_run = [&, made = std::size_t{0}, start_s = steady_now_s()](const chaos::RunOutcome& outcome,
                                                                     std::size_t done) mutable {
    const std::string progress = progress_text(done, plan.runs, done - ++made, steady_now_s() - start_s);
    std::cerr << fmt::format("{}: seed {}, {}: {}{}\n", progress, outcome.seed, outcome.fault, outcome.reason,
                             chaos::is_sound(outcome) ? "" : fmt::format(" [kept in {}/{}]", plan.folder, done - 1))
              << std::flush;
  };
  const std::vector<chaos::RunOutcome> outcomes = chaos::run_campaign(plan);
  std::error_code ignored;
  std::filesystem::remove(plan.folder, ignored);  // unless there is something in it
  Json summary{{"scenario", scenario.mission.name}, {"seed", plan.seed}, {"refused", refused}};
  summary["complete"] = outcomes.size() == plan.runs;
  if (!arguments.json && outcomes.size() < plan.runs) {
    std::cout << fmt::format("PARTIAL: {} of {} runs\n", outcomes.size(), plan.runs);
  }
  summary.update(chaos::summary_of(outcomes));
  print(summary, refused, arguments.json);
  guarded_junit(arguments,
                [&](const std::string& file) { write_output(file, junit_of(scenario, outcomes, plan.runs)); });
  if (signal) {
    std::cerr << interrupted_text(outcomes.size(), plan.runs, arguments.resume) << "\n";
    return 128 + *signal;
  }
  return std::ranges::all_of(outcomes, chaos::is_sound) ? 0 : static_cast<int>(ExitCode::Failed);
}

/// Maps can be equal at the end only if the run goes on for a while when nobody is on the way any more.
/// @return whether there is a new override
bool let_maps_settle(const Scenario& scenario, std::vector<Override>& overrides) {
  const std::optional<std::uint32_t> steps = settling_steps(scenario.mission);
  const bool chosen = std::ranges::find(overrides, kExtraKey, &Override::key) != overrides.end();
  if (!steps || *steps > kMostExtra || chosen || scenario.world.extra_steps > *steps) return false;
  overrides.push_back({kExtraKey, std::to_string(*steps + 1)});
  return true;
}

int run(ChaosArguments& arguments) {
  try {
    auto& overrides = arguments.world.overrides;
    if (std::ranges::find(overrides, kDeadlineKey, &Override::key) == overrides.end()) {
      overrides.push_back({kDeadlineKey, kDeadline});
    }
    std::optional<Scenario> scenario = load_or_complain(arguments.world);
    if (scenario && let_maps_settle(*scenario, overrides)) scenario = load_or_complain(arguments.world);
    return scenario ? campaign(arguments, *scenario) : static_cast<int>(ExitCode::Usage);
  } catch (const JournalRefused& refused) {
    std::cerr << "skein chaos: --resume: " << refused.what() << "\n";
    return static_cast<int>(ExitCode::Usage);
  } catch (const std::exception& error) {
    std::cerr << "skein chaos: " << error.what() << "\n";
    return static_cast<int>(ExitCode::Usage);
  }
}

}  // namespace

VerbAction add_chaos_verb(CLI::App& app) {
  auto arguments = std::make_shared<ChaosArguments>();
  CLI::App* verb = app.add_subcommand("chaos", "many runs with a fault each: what holds, and what it costs");
  add_common_flags(*verb, arguments->world.common);
  verb->remove_option(verb->get_option("--swarm"));  // each run has one of its own
  add_scenario_options(*verb, arguments->world);
  verb->add_option("--runs", arguments->runs, "how many")->check(CLI::Range(1U, 100000U))->capture_default_str();
  verb->add_option("--faults", arguments->faults,
                   "file of faults, one a line; by default all that this machine can do");
  verb->add_option("--limit", arguments->limit_s, "seconds after which a run hangs")
      ->check(number_within(1.0, 3600.0))
      ->capture_default_str();
  verb->add_option("--out", arguments->world.out, "folder for the runs; those that kept every promise are removed");
  verb->add_option("--resume", arguments->resume,
                   "FILE of the runs that are done: what it has is not run again; it is made if it is not there");
  verb->add_option("--junit", arguments->junit, "FILE.xml: a test case a run, broken invariants as failures");
  verb->add_flag("--json", arguments->json, "print the table as JSON on standard output");
  verb->footer("Example: skein chaos deploy/scenarios/rendezvous-ring.yaml --runs 20 --seed 1");
  return [arguments] { return run(*arguments); };
}

}  // namespace skein
