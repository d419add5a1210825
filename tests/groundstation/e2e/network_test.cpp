// Only whole processes on a network of their own can prove it: whatever interfaces come and go under a run, it ends
// with the state hash of one process.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

constexpr unsigned kDomain = 87;

/// Whether programs may have a network of their own here: the right to make one, and the tools.
bool may_have_own_network() {
  return run_program({"/bin/sh", "-c", "unshare -rn ip link add s0 type veth peer name t0"}, 30.0).exit_code == 0;
}

/// What the run's processes wrote into the logs of its folder.
std::string logs_of(const std::string& folder) {
  return run_program({"/bin/sh", "-c", "cat " + folder + "/*.log"}, 30.0).out;
}

/// Another interface with another address in the network of `pid`, in place of the one before.
bool connect(pid_t pid, int number) {
  const std::string n = std::to_string(number);
  const std::string before = std::to_string(number - 1);
  const std::string script = "ip link del s" + before + "; ip link add s" + n + " type veth peer name t" + n +
                             " && ip addr add 10.6." + n + ".1/24 dev s" + n + " && ip link set t" + n +
                             " up && ip link set s" + n + " up";
  return run_program({"/bin/sh", "-c",
                      "nsenter -t " + std::to_string(pid) + " -U -n --preserve-credentials sh -c '" + script + "'"},
                     30.0)
             .exit_code == 0;
}

TEST(AnotherNetwork, UnderARunChangesNothing) {
  const ScratchFolder out;
  const std::string small = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";
  const SkeinRun alone = skein_run(small, kDomain, out.path() + "/alone", {"--in-process"});
  ASSERT_EQ(alone.ended.exit_code, 0) << alone.ended.err;
  const bool own = may_have_own_network();
  const std::string run = binary("skein") + " run " + small + " --json --realtime 40 --domain " +
                          std::to_string(kDomain) + " --out " + out.path() + "/run";
  Program program(
      {"/bin/sh", "-c",
       own ? "exec unshare -rn sh -c 'ip link set lo up multicast on && exec " + run + "'" : "exec " + run});
  ASSERT_TRUE(program.read_until("flight: step", 60.0));
  for (int number = 1; own && number <= 3; ++number) EXPECT_TRUE(connect(program.pid(), number));
  const Ended ended = program.wait(60.0);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const auto report = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << ended.out;
  EXPECT_EQ(report.at("state_hash"), alone.report.at("state_hash"));
  EXPECT_TRUE(report.at("roster_changes").empty());
  EXPECT_EQ(logs_of(out.path() + "/run").find("DDS participant made anew"), std::string::npos);
}

/// A script that starts a world by hand, writes its id into `folder`/world.pid, and becomes one who watches it.
std::string watched_world(const std::string& folder) {
  const std::string flags = fmt::format("--domain {} --swarm another-network", kDomain);
  return fmt::format("'{}' {}/tests/data/small.yaml --out {}/world {} 2>{}/world.log & echo $! >{}/world.pid\n",
                     binary("skein-simworld"), SKEIN_SOURCE_DIR, folder, flags, folder, folder) +
         fmt::format("exec '{}' run --attach {}\n", binary("skein"), flags);
}

TEST(AnotherNetwork, AWorldThatDiedIsGoneForAnObserverThatWasMadeAnewSinceThen) {
  const ScratchFolder out;
  const bool own = may_have_own_network();
  const std::string script = out.path() + "/watch.sh";
  std::ofstream(script) << watched_world(out.path());
  Program watcher({"/bin/sh", "-c",
                   own ? fmt::format("exec unshare -rn sh -c 'ip link set lo up multicast on && exec sh {}'", script)
                       : "exec sh " + script});
  ASSERT_TRUE(watcher.read_until("discovery", 30.0));
  pid_t world = 0;
  ASSERT_TRUE(std::ifstream(out.path() + "/world.pid") >> world);
  ASSERT_EQ(::kill(world, SIGKILL), 0);
  if (own) {
    EXPECT_TRUE(connect(watcher.pid(), 1));
    EXPECT_TRUE(watcher.read_until("DDS participant made anew", 10.0));
  }
  const Ended ended = watcher.wait(60.0);
  EXPECT_EQ(ended.exit_code, 4) << ended.err;
  EXPECT_NE(ended.err.find("the world of swarm another-network is gone"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace skein::e2e
