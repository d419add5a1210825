// Only whole processes can prove it: whatever dies, falls silent or comes back, at whatever moment, the run ends with
// the right exit code, and one process repeats it from its roster changes, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/groundstation/e2e/skein.hpp"
#include "tests/groundstation/fault_scripts.hpp"
#include "tests/groundstation/ring.hpp"

namespace skein::e2e {
namespace {

constexpr unsigned kDomain = 66;
constexpr unsigned kVehicles = 6;

/// The ring of six in a file of the folder.
std::string ring_file(const ScratchFolder& out, const std::string& on_agent_loss = "remove") {
  const std::string path = out.path() + "/ring.yaml";
  std::ofstream(path) << test::ring_yaml(kVehicles, on_agent_loss);
  return path;
}

struct RunAndReplay {
  SkeinRun run;
  SkeinRun replay;
};

/// Runs a script as processes, with a deadline of a second, and replays its roster in one.
RunAndReplay run_script(const ScratchFolder& out, const std::string& scenario, unsigned seed,
                        const std::vector<Fault>& script) {
  const std::vector<std::string> same{"--seed", std::to_string(seed), "--set", "lockstep.deadline_s=1"};
  std::vector<std::string> flags = same;
  for (const Fault& fault : script) flags.insert(flags.end(), {"--fault", text_of(fault)});
  std::vector<std::string> replay = same;
  replay.insert(replay.end(), {"--in-process", "--roster", out.path() + "/a/report.json"});
  RunAndReplay both;
  both.run = skein_run(scenario, kDomain, out.path() + "/a", flags);
  both.replay = skein_run(scenario, kDomain, out.path() + "/b", replay);
  return both;
}

std::string texts_of(const std::vector<Fault>& script) {
  std::string text;
  for (const Fault& fault : script) text += fmt::format(" {}", text_of(fault));
  return text;
}

/// The exit code that a run's report asks for: a collision, a loss, a fault that never took place, nothing.
int expected_exit(const nlohmann::json& report) {
  if (report.at("collisions") > 0) return 1;
  if (!report.at("roster_changes").empty()) return 4;
  return report.at("reason").get<std::string>().find("never took place") == std::string::npos ? 0 : 1;
}

TEST(FaultScripts, EndAndEqualTheirReplays) {
  const unsigned scripts = seeds_or("SKEIN_E2E_FAULTS", 10);
  std::size_t changes = 0;
  std::size_t returns = 0;
  for (unsigned seed = 0; seed < scripts; ++seed) {
    const ScratchFolder out;
    const std::vector<Fault> script = test::random_script(seed, kVehicles, 35, 300);
    const RunAndReplay both = run_script(out, ring_file(out), seed, script);
    const std::string what = fmt::format("script {}:{}\n{}", seed, texts_of(script), both.run.ended.err);
    ASSERT_FALSE(both.run.report.is_null()) << what;
    ASSERT_FALSE(both.replay.report.is_null()) << what << both.replay.ended.err;
    EXPECT_EQ(both.run.ended.exit_code, expected_exit(both.run.report)) << what << both.run.report.dump(2);
    EXPECT_EQ(both.replay.ended.exit_code, expected_exit(both.replay.report)) << what;
    EXPECT_EQ(both.run.report.at("state_hash"), both.replay.report.at("state_hash")) << what;
    EXPECT_EQ(both.run.report.at("roster_changes"), both.replay.report.at("roster_changes")) << what;
    EXPECT_TRUE(gone_within(out.path(), 5.0)) << what;
    for (const auto& change : both.run.report.at("roster_changes")) {
      ++changes;
      returns += change.at("reason") == "rejoined" ? 1U : 0U;
    }
  }
  EXPECT_GE(changes, scripts);
  EXPECT_GT(returns, 0U);
}

TEST(FaultScripts, ARestartedProcessIsAnotherOne) {
  const ScratchFolder out;
  const RunAndReplay both =
      run_script(out, ring_file(out, "continue"), 1, {{FaultKind::Restart, 2, Phase::Flying, 40}});
  ASSERT_EQ(both.run.ended.exit_code, 4) << both.run.ended.err;
  const auto& report = both.run.report;
  EXPECT_EQ(report.at("vehicles").at(1).at("status"), "rejoined");
  const auto& processes = report.at("processes");
  ASSERT_EQ(processes.size(), 7U);
  const auto second =
      std::find_if(processes.begin(), processes.end(), [](const auto& p) { return p.at("agent") == 2; });
  EXPECT_EQ(second->at("ended_by"), "signal 9 (Killed)");
  EXPECT_EQ(processes.at(6).at("agent"), 2);
  EXPECT_EQ(processes.at(6).at("ended_by"), "exit status 0");
  EXPECT_EQ(report.at("vehicles").at(1).at("pid"), processes.at(6).at("pid"));
  EXPECT_EQ(report.at("state_hash"), both.replay.report.at("state_hash"));
}

TEST(FaultScripts, AnAgentThatIsStillStoppedDoesNotDelayTheEnd) {
  const ScratchFolder out;
  const RunAndReplay both = run_script(out, ring_file(out), 1, {{FaultKind::Stop, 3, Phase::Flying, 40}});
  ASSERT_EQ(both.run.ended.exit_code, 4) << both.run.ended.err;
  EXPECT_EQ(both.run.report.at("processes").at(2).at("ended_by"), "signal 9 (Killed)");
  EXPECT_EQ(both.run.report.at("state_hash"), both.replay.report.at("state_hash"));
}

}  // namespace
}  // namespace skein::e2e
