// skein validate and skein version.
#include <fmt/core.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "groundstation/cli/verbs.hpp"
#include "idl/wire.hpp"
#include "simworld/process/world_process.hpp"
#include "simworld/report/report.hpp"
#include "simworld/scenario/checks.hpp"

namespace skein {
namespace {

int validate(const WorldArguments& arguments, bool json) {
  const ScenarioResult result = load_scenario(arguments.scenario, arguments.overrides, arguments.seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) {
    if (json)
      std::cout << nlohmann::ordered_json{{"valid", false}, {"where", fault->where}, {"message", fault->message}}
                << "\n";
    std::cerr << fault->line() << "\n";
    return static_cast<int>(ExitCode::Usage);
  }
  const auto& scenario = std::get<Scenario>(result);
  const Mission& mission = scenario.mission;
  const std::vector<std::string> notes = scenario::notes_of(mission);
  const std::string& planner = mission.transit ? mission.transit->planner.name : mission.planner.name;
  if (json) {
    std::cout << nlohmann::ordered_json{{"valid", true},
                                        {"scenario", mission.name},
                                        {"scenario_hash", fmt::format("{:016x}", scenario.scenario_hash)},
                                        {"seed", mission.seed},
                                        {"vehicles", mission.vehicles.size()},
                                        {"zones", mission.zones.size()},
                                        {"planner", planner},
                                        {"notes", notes}}
              << "\n";
  } else {
    std::cout << fmt::format("{}: valid: {} vehicles, {} zones, planner {}, seed {}\n", arguments.scenario,
                             mission.vehicles.size(), mission.zones.size(), planner, mission.seed);
    for (const std::string& note : notes) std::cout << fmt::format("{}: note: {}\n", arguments.scenario, note);
  }
  return 0;
}

}  // namespace

VerbAction add_validate_verb(CLI::App& app) {
  auto arguments = std::make_shared<WorldArguments>();
  auto json = std::make_shared<bool>(false);
  CLI::App* verb = app.add_subcommand("validate", "check a scenario and say what is wrong with it");
  add_scenario_options(*verb, *arguments);
  verb->add_flag("--json", *json, "print JSON");
  verb->footer("Example: skein validate deploy/scenarios/rendezvous-2d.yaml --set planner.particles=20");
  return [arguments, json] { return validate(*arguments, *json); };
}

VerbAction add_version_verb(CLI::App& app) {
  auto json = std::make_shared<bool>(false);
  CLI::App* verb = app.add_subcommand("version", "print the version");
  verb->add_flag("--json", *json, "print JSON");
  verb->footer("Example: skein version --json");
  return [json] {
    if (*json) {
      std::cout << nlohmann::ordered_json{{"version", version()}, {"wire_version", wire::kWireVersion}} << "\n";
    } else {
      std::cout << fmt::format("skein {} (wire version {})\n", version(), wire::kWireVersion);
    }
    return 0;
  };
}

}  // namespace skein
