// skein replay FILE: a recording back on the bus, for monitor, status and record.
#include <fmt/core.h>
#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/replay/replay.hpp"
#include "idl/process/dds_config.hpp"
#include "idl/process/number_within.hpp"

namespace skein {
namespace {

using replay::Replayed;
using replay::ReplayPlan;

constexpr int kBad = 2;

nlohmann::ordered_json json_of(const Replayed& replayed, const ReplayPlan& plan) {
  return {{"file", plan.file},
          {"swarm", swarm_of(plan.common)},
          {"exit_code", replayed.exit_code},
          {"reason", replayed.reason},
          {"samples", replayed.samples},
          {"refused", replayed.refused},
          {"left_out", replayed.left_out},
          {"missing", replayed.missing},
          {"from_s", replayed.from_s},
          {"to_s", replayed.to_s}};
}

void print(const Replayed& replayed, const ReplayPlan& plan) {
  std::cout << fmt::format("{}: {} samples played to swarm {}, simulated time {:.3f} to {:.3f} s\n", plan.file,
                           replayed.samples, swarm_of(plan.common), replayed.from_s, replayed.to_s);
  if (replayed.left_out > 0)
    std::cout << fmt::format("  {} samples of no or another run left out\n", replayed.left_out);
  if (replayed.refused > 0) std::cout << fmt::format("  {} samples that DDS did not take\n", replayed.refused);
}

int play(ReplayPlan& plan, bool json) {
  const bool terminal = isatty(STDERR_FILENO) == 1;
  if (terminal) {
    plan.on_progress = [](double time_s, double end_s) {
      std::cerr << fmt::format("\r\x1b[Kreplay: {:.1f} of {:.1f} s", time_s, end_s) << std::flush;
    };
  }
  plan.on_begin = [&] { std::cerr << fmt::format("playing {} to swarm {}\n", plan.file, swarm_of(plan.common)); };
  try {
    const Replayed replayed = replay::replay(plan);
    if (terminal && replayed.samples > 0) std::cerr << "\n";
    if (!replayed.missing.empty()) std::cerr << fmt::format("{}: {}\n", plan.file, replayed.missing);
    if (!replayed.reason.empty()) std::cerr << fmt::format("skein replay: {}\n", replayed.reason);
    if (json) {
      std::cout << json_of(replayed, plan).dump(2) << "\n";
    } else if (replayed.samples > 0) {
      print(replayed, plan);
    }
    return replayed.exit_code;
  } catch (const std::exception& error) {
    const std::string what = error.what();
    const bool named = what.starts_with(plan.file + ":");
    std::cerr << "skein replay: " << (named ? what : plan.file + ": " + what) << "\n";
    return kBad;
  }
}

}  // namespace

VerbAction add_replay_verb(CLI::App& app) {
  auto plan = std::make_shared<ReplayPlan>();
  auto json = std::make_shared<bool>(false);
  CLI::App* verb = app.add_subcommand("replay", "put a recording back on the bus, for monitor, status and record");
  verb->add_option("FILE", plan->file, "recording")->required();
  add_common_flags(*verb, plan->common);
  verb->get_option("--startup-timeout")->description("seconds in which the observers of --wait must be there");
  verb->add_option("--rate", plan->rate, "times real time; 0: as fast as the machine can")
      ->check(number_within(0.0, 1e6))
      ->capture_default_str();
  verb->add_option("--from", plan->from_s, "seconds of simulated time to begin at")
      ->check(number_within(0.0, 1e9))
      ->capture_default_str();
  verb->add_option("--wait", plan->observers, "begin when so many observers are there")->check(CLI::Range(0U, 1000U));
  verb->add_flag("--json", *json, "print what was played as JSON");
  verb->footer(
      "Refuses a swarm that is live: the file plays to one of its own, skein unless --swarm says.\n"
      "Example: skein replay run.mcap --rate 10 & skein monitor");
  return [plan, json] { return play(*plan, *json); };
}

}  // namespace skein
