// Bad input gets one clear line and exit code 2, through the binaries themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

std::ptrdiff_t lines_of(const std::string& text) {
  return std::ranges::count(text, '\n');
}

TEST(Usage, EveryBrokenScenarioGivesOneLineAndExitCode2) {
  unsigned scenarios = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(SKEIN_SOURCE_DIR) + "/tests/data/broken")) {
    if (entry.path().extension() != ".yaml") continue;
    ++scenarios;
    const ScratchFolder out;
    for (const std::vector<std::string>& verb :
         {std::vector<std::string>{binary("skein"), "validate", entry.path()},
          std::vector<std::string>{binary("skein"), "run", entry.path(), "--out", out.path(), "--domain", "81"},
          std::vector<std::string>{binary("skein-simworld"), entry.path(), "--out", out.path(), "--domain", "81"}}) {
      const Ended ended = run_program(verb, 30.0);
      EXPECT_EQ(ended.exit_code, 2) << entry.path() << "\n" << ended.err;
      EXPECT_EQ(lines_of(ended.err), 1) << entry.path() << "\n" << ended.err;
      EXPECT_EQ(ended.err.rfind(entry.path().string() + ":", 0), 0U) << ended.err;
    }
  }
  EXPECT_GE(scenarios, 20U);
}

TEST(Usage, BadFlagsGiveOneLineAndExitCode2) {
  const std::string good = scenario_path("rendezvous-2d");
  for (const std::vector<std::string>& flags :
       std::vector<std::vector<std::string>>{{"skein"},
                                             {"skein", "fly"},
                                             {"skein", "run"},
                                             {"skein", "run", good, "--domain", "233"},
                                             {"skein", "run", good, "--swarm", "a*b"},
                                             {"skein", "run", good, "--profile", "tcp"},
                                             {"skein", "run", good, "--seed", "-1"},
                                             {"skein", "run", good, "--seed", "18446744073709551616"},
                                             {"skein", "validate", "/dev/null"},
                                             {"skein", "sweep", good, "--seed", "18446744073709551615", "--runs", "3"},
                                             {"skein", "run", good, "--set", "planner.particles"},
                                             {"skein", "run", good, "--set", "planner.particles=1"},
                                             {"skein", "run", good, "--fault", "kill:2@plan"},
                                             {"skein", "run", good, "--fault", "melt:2@plan:3"},
                                             {"skein", "run", good, "--fault", "kill:9@plan:3"},
                                             {"skein", "run", good, "--roster", "nowhere.json"},
                                             {"skein", "run", good, "--in-process", "--roster", "/nowhere.json"},
                                             {"skein", "run", "/nowhere.yaml"},
                                             {"skein", "run", good, "--out", "/proc/nowhere"},
                                             {"skein", "sweep", good, "--runs", "0"},
                                             {"skein", "doctor", "--agents", "0"},
                                             {"skein", "doctor", "--agents", "257"},
                                             {"skein", "doctor", "--domain", "233"},
                                             {"skein", "sweep", good, "--runs", "1", "--curves", "/dev/null/curves"},
                                             {"skein", "sweep", good, "--set", "planner.particles=20,1"},
                                             {"skein-agent", "--id", "0"},
                                             {"skein-agent", "--id", "257"},
                                             {"skein-agent", "--id", "1-3,2"},
                                             {"skein", "run", good, "--per-process", "0"},
                                             {"skein-agent", "--id", "1", "--world-timeout", "nan"},
                                             {"skein-agent", "--id", "1", "--world-timeout", "\xff"},
                                             {"skein-simworld", good, "--settle-time", "nan"},
                                             {"skein-simworld", good, "--settle-time", "-1"},
                                             {"skein-simworld", good, "--realtime", "nan"},
                                             {"skein-simworld"},
                                             {"skein-simworld", good, "--fault", "kill:2@plan:3"}}) {
    std::vector<std::string> arguments{binary(flags[0])};
    arguments.insert(arguments.end(), flags.begin() + 1, flags.end());
    const Ended ended = run_program(arguments, 30.0);
    const std::string what = testing::PrintToString(flags) + "\n" + ended.err;
    EXPECT_EQ(ended.exit_code, 2) << what;
    EXPECT_EQ(lines_of(ended.err), 1) << what;
  }
}

TEST(Usage, AnUnknownInstructionSetIsRefusedByEveryBinary) {
  const std::string good = scenario_path("rendezvous-2d");
  for (const std::vector<std::string>& command : {std::vector<std::string>{binary("skein"), "validate", good},
                                                  std::vector<std::string>{binary("skein-agent"), "--id", "1"},
                                                  {binary("skein-simworld"), good}}) {
    const Ended ended = run_program(command, 30.0, {"SKEIN_ISA=sse9"});
    EXPECT_EQ(ended.exit_code, 2) << ended.err;
    EXPECT_EQ(lines_of(ended.err), 1) << ended.err;
    EXPECT_NE(ended.err.find("SKEIN_ISA is 'sse9'"), std::string::npos) << ended.err;
  }
}

TEST(Usage, GoodOnesSucceed) {
  EXPECT_EQ(run_program({binary("skein"), "version"}, 30.0).exit_code, 0);
  const Ended valid = run_program({binary("skein"), "validate", scenario_path("rendezvous-2d"), "--json"}, 30.0);
  EXPECT_EQ(valid.exit_code, 0);
  EXPECT_TRUE(nlohmann::json::parse(valid.out).at("valid"));
}

TEST(Usage, AnAgentWithoutAWorldEndsWith3) {
  const Ended ended =
      run_program({binary("skein-agent"), "--id", "1", "--domain", "82", "--world-timeout", "0.3"}, 30.0);
  EXPECT_EQ(ended.exit_code, 3) << ended.err;
  EXPECT_NE(ended.err.find("no tick of a world"), std::string::npos) << ended.err;
}

TEST(Usage, AWorldWithoutAgentsEndsWith3AndNamesThem) {
  const ScratchFolder out;
  const Ended ended = run_program({binary("skein-simworld"), scenario_path("rendezvous-2d"), "--domain", "82", "--out",
                                   out.path(), "--startup-timeout", "0.3"},
                                  30.0);
  EXPECT_EQ(ended.exit_code, 3) << ended.err;
  EXPECT_NE(ended.err.find("missing: 1, 2, 3"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace skein::e2e
