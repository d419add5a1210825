// skein record: every sample of a swarm that somebody else started, into an MCAP file.
#include <fmt/core.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/output/output_file.hpp"
#include "groundstation/record/attached.hpp"
#include "simworld/process/world_process.hpp"

namespace skein {
namespace {

constexpr int kBad = 2;

struct RecordArguments {
  RecordPlan plan;
  WorldArguments world;
  bool json = false;
};

nlohmann::ordered_json json_of(const Recorded& recorded, const std::string& file) {
  nlohmann::ordered_json writers = nlohmann::ordered_json::array();
  for (const auto& [key, writer] : recorded.gaps.writers()) {
    const std::optional<bool>& end_heard = writer.tail.heard;
    writers.push_back({{"writer", name_of(writer)},
                       {"kept", writer.kept},
                       {"lost", writer.lost()},
                       {"from", writer.first},
                       {"to", writer.last},
                       {"end_heard", end_heard ? nlohmann::ordered_json(*end_heard) : nullptr}});
  }
  return {{"file", file},
          {"exit_code", recorded.exit_code},
          {"reason", recorded.reason},
          {"samples", recorded.samples},
          {"lost", recorded.gaps.lost()},
          {"end_heard", recorded.gaps.end_heard()},
          {"writers", writers}};
}

void print(const Recorded& recorded, const std::string& file) {
  std::cout << fmt::format("{}: {} samples, {} lost{} ({})\n", file, recorded.samples, recorded.gaps.lost(),
                           recorded.gaps.end_heard() ? "" : " as far as is known: the end was not heard",
                           recorded.reason);
  for (const auto& [key, writer] : recorded.gaps.writers()) {
    const bool heard = writer.tail.heard.value_or(true);
    if (writer.lost() == 0 && heard) continue;
    std::cout << fmt::format("  {}: {} of {} lost{}\n", name_of(writer), writer.lost(), writer.lost() + writer.kept,
                             heard ? "" : fmt::format(", heard up to number {}, not to its end", writer.last));
  }
}

int record(RecordArguments& arguments) {
  try {
    std::optional<Scenario> scenario;
    if (!arguments.world.scenario.empty()) {
      scenario = load_or_complain(arguments.world);
      if (!scenario) return kBad;
      arguments.plan.scenario = &*scenario;
    }
    check_output(arguments.plan.file, {arguments.world.scenario});
    const Recorded recorded = record_attached(arguments.plan);
    if (recorded.exit_code != 0) std::cerr << "skein record: " << recorded.reason << "\n";
    if (!recorded.has_file) return recorded.exit_code;
    if (arguments.json) {
      std::cout << json_of(recorded, arguments.plan.file).dump(2) << "\n";
    } else {
      print(recorded, arguments.plan.file);
    }
    return recorded.exit_code;
  } catch (const std::exception& error) {
    std::cerr << "skein record: " << error.what() << "\n";
    return kBad;
  }
}

}  // namespace

VerbAction add_record_verb(CLI::App& app) {
  auto arguments = std::make_shared<RecordArguments>();
  CLI::App* verb = app.add_subcommand("record", "record a running swarm, without disturbing it");
  add_common_flags(*verb, arguments->plan.common);
  add_scenario_options(*verb, arguments->world);
  CLI::Option* scenario = verb->get_option("SCENARIO");
  scenario->required(false)->description("what the swarm runs, to be kept in the file: for skein verify --rerun");
  for (const char* name : {"--seed", "--set", "--planner", "--controller", "--agents"}) {
    verb->get_option(name)->needs(scenario);
  }
  verb->add_option("-o,--output", arguments->plan.file, "FILE.mcap; one that is there is replaced")->required();
  verb->add_option("--inbox", arguments->plan.inbox, "samples that may wait to be written; older ones are lost")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 24))
      ->capture_default_str();
  verb->add_flag("--json", arguments->json, "print what was kept and lost as JSON");
  verb->footer(
      "Reads best effort: what is lost is counted. skein run --record keeps everything.\n"
      "Example: skein record --swarm geese -o geese.mcap");
  return [arguments] { return record(*arguments); };
}

}  // namespace skein
