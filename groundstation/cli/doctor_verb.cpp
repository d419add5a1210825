// skein doctor: whether this machine can run a swarm, and what to do if not.
#include <fmt/core.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/doctor/probe.hpp"
#include "idl/process/common_flags.hpp"
#include "planner/core/mission/mission.hpp"
#include "simworld/lockstep/run.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

struct DoctorArguments {
  CommonFlags common;
  std::uint32_t agents = 3;
  bool json = false;
};

void print_json(const DoctorArguments& arguments, const std::vector<doctor::Finding>& findings) {
  Json document{{"agents", arguments.agents},
                {"domain", arguments.common.domain},
                {"profile", arguments.common.profile},
                {"can_run", doctor::can_run(findings)},
                {"findings", Json::array()}};
  for (const doctor::Finding& finding : findings) {
    document["findings"].push_back({{"what", finding.what},
                                    {"level", doctor::name_of(finding.level)},
                                    {"figure", finding.figure},
                                    {"remedy", finding.remedy}});
  }
  std::cout << document.dump(2) << "\n";
}

void print_lines(const DoctorArguments& arguments, const std::vector<doctor::Finding>& findings) {
  for (const doctor::Finding& finding : findings) {
    std::cout << fmt::format("{:<5} {:<15} {}{}{}\n", doctor::name_of(finding.level), finding.what, finding.figure,
                             finding.remedy.empty() ? "" : "; remedy: ", finding.remedy);
  }
  std::cout << fmt::format("{} agents {} run on this machine\n", arguments.agents,
                           doctor::can_run(findings) ? "can" : "cannot");
}

int examine(const DoctorArguments& arguments) {
  const doctor::Swarm swarm{arguments.agents, arguments.common.domain, arguments.common.profile == "shm"};
  const std::vector<doctor::Finding> findings = doctor::findings_of(doctor::probe(swarm), swarm);
  arguments.json ? print_json(arguments, findings) : print_lines(arguments, findings);
  return static_cast<int>(doctor::can_run(findings) ? ExitCode::Success : ExitCode::Failed);
}

}  // namespace

VerbAction add_doctor_verb(CLI::App& app) {
  auto arguments = std::make_shared<DoctorArguments>();
  CLI::App* verb = app.add_subcommand("doctor", "say whether this machine can run a swarm, and what to do if not");
  add_common_flags(*verb, arguments->common);
  verb->add_option("--agents", arguments->agents, "agents of the swarm")
      ->check(CLI::Range(1U, kMaxAgents))
      ->capture_default_str();
  verb->add_flag("--json", arguments->json, "print JSON");
  verb->footer("Exit code 1 if a finding prevents a run.\nExample: skein doctor --agents 12");
  return [arguments] { return examine(*arguments); };
}

}  // namespace skein
