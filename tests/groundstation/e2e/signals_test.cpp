// Only whole processes can prove it: whenever a user presses Ctrl-C, or the launcher dies, nothing stays behind.
#include <gtest/gtest.h>

#include <csignal>

#include "planner/core/random/random_stream.hpp"
#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

constexpr unsigned kDomain = 71;

std::vector<std::string> command(const std::string& out) {
  return {binary("skein"),
          "run",
          scenario_path("rendezvous-2d"),
          "--json",
          "--domain",
          std::to_string(kDomain),
          "--out",
          out,
          "--swarm",
          "e2e-signals-" + out.substr(out.size() - 6)};
}

/// A run takes about 0.4 s here; moments are drawn over twice that, so that some fall behind the end.
constexpr double kLatest_s = 0.8;

TEST(Signals, CtrlCAtAnyMomentLeavesNothing) {
  const unsigned moments = seeds_or("SKEIN_E2E_MOMENTS", 5);
  const auto shared_before = shared_memory_files();
  unsigned interrupted = 0;
  for (unsigned seed = 0; seed < moments; ++seed) {
    const ScratchFolder out;
    RandomStream random(seed, 0, Purpose::Test, 0);
    const double moment_s = random.uniform(0.0, kLatest_s);
    Program program(command(out.path()));
    program.read_until("", moment_s);
    program.signal_group(SIGINT);
    const Ended ended = program.wait(30.0);
    EXPECT_TRUE(ended.exit_code == 130 || ended.exit_code == 0) << ended.exit_code << " after " << moment_s << " s\n"
                                                                << ended.err;
    interrupted += ended.exit_code == 130 ? 1 : 0;
    EXPECT_TRUE(gone_within(out.path(), 5.0)) << "after " << moment_s << " s";
    EXPECT_TRUE(gone_within("e2e-signals-" + out.path().substr(out.path().size() - 6), 5.0));
  }
  EXPECT_GT(interrupted, 0U);
  EXPECT_EQ(shared_memory_files(), shared_before);
}

TEST(Signals, InterruptedRunSaysSoInItsReport) {
  const ScratchFolder out;
  auto arguments = command(out.path());
  arguments.insert(arguments.end(), {"--set", "step_s=0.02", "--set", "world.max_steps=1000000"});
  Program program(arguments);
  ASSERT_TRUE(program.read_until("flight: step", 60.0));
  program.signal_group(SIGINT);
  const Ended ended = program.wait(30.0);
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  const auto report = nlohmann::json::parse(ended.out);
  EXPECT_FALSE(report.at("success"));
  EXPECT_EQ(report.at("reason"), "ended by SIGINT");
  for (const auto& process : report.at("processes")) EXPECT_EQ(process.at("ended_by"), "exit status 0");
}

TEST(Signals, TerminatedRunEndsWith143) {
  const ScratchFolder out;
  Program program(command(out.path()));
  ASSERT_TRUE(program.read_until("discovery", 60.0));
  ASSERT_EQ(kill(program.pid(), SIGTERM), 0);
  EXPECT_EQ(program.wait(30.0).exit_code, 143);
  EXPECT_TRUE(gone_within(out.path(), 5.0));
}

TEST(Signals, LauncherKilledTakesItsChildrenAlong) {
  const ScratchFolder out;
  Program program(command(out.path()));
  ASSERT_TRUE(program.read_until("discovery", 60.0));
  ASSERT_EQ(kill(program.pid(), SIGKILL), 0);
  EXPECT_EQ(program.wait(30.0).exit_code, 137);
  EXPECT_TRUE(gone_within(out.path(), 10.0));
  EXPECT_TRUE(gone_within("e2e-signals-" + out.path().substr(out.path().size() - 6), 10.0));
}

}  // namespace
}  // namespace skein::e2e
