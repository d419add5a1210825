#include <fmt/chrono.h>
#include <fmt/core.h>

#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "idl/process/number_within.hpp"
#include "simworld/process/world_process.hpp"

namespace skein {
namespace {

/// CLI11 alone would take -1 for 2^64 - 1.
std::string check_whole(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole ? "" : fmt::format("'{}' is no seed; allowed: 0 to 2^64 - 1", text);
}

/// An option that may be given many times, with one text each; `take` throws CLI::ValidationError with one line.
void add_repeated(CLI::App& app, const std::string& name, const std::string& help,
                  const std::function<void(const std::string&)>& take) {
  const auto callback = [take](const CLI::results_t& texts) {
    for (const std::string& text : texts) take(text);
    return true;
  };
  app.add_option(name, callback, help)->type_size(1)->expected(1)->take_all();
}

}  // namespace

void add_scenario_options(CLI::App& app, WorldArguments& arguments) {
  app.add_option("SCENARIO", arguments.scenario, "scenario file (docs/scenario.md)")->required();
  app.add_option("--seed", arguments.seed, "seed of the run; by default the scenario's")->check(check_whole);
  add_repeated(app, "--set", "key=value: overrides a scenario key; may be repeated", [&arguments](const auto& text) {
    const auto at = text.find('=');
    if (at == std::string::npos || at == 0) {
      throw CLI::ValidationError(fmt::format("--set {}: not of the form key=value", text));
    }
    arguments.overrides.push_back({text.substr(0, at), text.substr(at + 1)});
  });
  add_repeated(app, "--planner", "NAME: the same as --set planner.name=NAME", [&arguments](const auto& text) {
    arguments.overrides.push_back({"planner.name", text});
  });
  add_repeated(app, "--controller", "NAME: the same as --set controller.name=NAME", [&arguments](const auto& text) {
    arguments.overrides.push_back({std::string(kControllerFlag), text});
  });
  add_repeated(app, "--agents", "N: how many vehicles; the same as --set vehicles.ring.agents=N, or vehicles.agents=N",
               [&arguments](const auto& text) {
                 arguments.overrides.push_back({std::string(kAgentsFlag), text});
               });
}

void add_world_options(CLI::App& app, WorldArguments& arguments) {
  add_scenario_options(app, arguments);
  app.add_option("--out", arguments.out, "folder for report and logs; by default skein-runs/<time>-<seed>");
  app.add_option("--realtime", arguments.realtime, "pace to so many times real time; default: as fast as it goes")
      ->check(number_within(0.1, 1000.0));
  app.add_flag("--wait-start", arguments.wait_start, "start when all are matched and skein start says so");
  app.add_flag("--fail-fast,!--keep-going", arguments.fail_fast, "end the run when an agent is lost; default: go on");
  app.add_option("--checkpoint", arguments.checkpoint,
                 "folder that keeps the run as it goes: a world that died goes on from there");
  app.add_flag("--checkpoint-sync", arguments.checkpoint_sync,
               "with --checkpoint: wait for the disk each round, against power loss as well");
  add_repeated(app, "--fault",
               "KIND:ID@plan:ROUND or KIND:ID@fly:STEP, KIND kill, stop, cont or restart, or kill:world@...: a fault "
               "on purpose; "
               "may be repeated",
               [&arguments](const auto& text) {
                 const ParsedFault parsed = parse_fault(text);
                 if (!parsed.fault) throw CLI::ValidationError(parsed.error);
                 arguments.faults.push_back(*parsed.fault);
               });
}

std::optional<Scenario> load_or_complain(const WorldArguments& arguments) {
  ScenarioResult result = load_scenario(arguments.scenario, arguments.overrides, arguments.seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) {
    std::cerr << fault->line() << "\n";
    return std::nullopt;
  }
  Scenario scenario = std::get<Scenario>(std::move(result));
  for (const Fault& fault : arguments.faults) {
    if (fault.agent == kWorldId) {
      if (!arguments.checkpoint.empty()) continue;
      std::cerr << "--fault " << text_of(fault) << ": a world goes on from a checkpoint alone: add --checkpoint DIR\n";
      return std::nullopt;
    }
    if (std::ranges::find(scenario.mission.vehicles, fault.agent, &VehicleSpec::id) ==
        scenario.mission.vehicles.end()) {
      std::cerr << fmt::format("--fault: the scenario has no vehicle {}\n", fault.agent);
      return std::nullopt;
    }
  }
  return scenario;
}

std::string prepare_out(const std::string& out, const Scenario& scenario) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::string folder = out;
  if (out.empty()) {
    fs::create_directories("skein-runs", error);
    const auto now = std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
    const std::string stem = fmt::format("skein-runs/{:%Y%m%dT%H%M%S}-{}", fmt::gmtime(now), scenario.mission.seed);
    folder = stem;
    for (int copy = 2; !error && !fs::create_directory(folder, error); ++copy) {
      folder = fmt::format("{}.{}", stem, copy);
    }
  } else {
    fs::create_directories(folder, error);
  }
  if (error) throw std::runtime_error(fmt::format("cannot make the out folder {}: {}", folder, error.message()));
  std::ofstream copy(fs::path(folder) / "scenario.yaml", std::ios::binary);
  copy << scenario.text;
  copy.close();
  if (!copy) throw std::runtime_error(fmt::format("cannot write to the out folder {}", folder));
  return folder;
}

}  // namespace skein
