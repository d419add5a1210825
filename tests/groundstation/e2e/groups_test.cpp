// Only whole processes can prove it: how vehicles are grouped into processes changes no bit of a run, and who shares a
// process ends with it.
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "planner/core/math/det_math.hpp"
#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

constexpr unsigned kDomain = 68;

/// A scenario of n vehicles on a ring of 20 km, slots opposite on a ring of 2 km, headings 1 rad off the centre.
std::string ring_scenario(const std::string& folder, int n) {
  std::string starts;
  std::string slots;
  for (int k = 0; k < n; ++k) {
    const double at = math::kTwoPi * k / n;
    const double x = math::cos(at);
    const double y = math::sin(at);
    const std::string id = "    - {id: " + std::to_string(k + 1);
    starts += id + ", x_m: " + std::to_string(20000.0 * x) + ", y_m: " + std::to_string(20000.0 * y) +
              ", heading_rad: " + std::to_string(math::wrap_angle(at + math::kPi + 1.0)) + "}\n";
    slots += id + ", x_m: " + std::to_string(-2000.0 * x) + ", y_m: " + std::to_string(-2000.0 * y) + "}\n";
  }
  const std::string path = folder + "/ring.yaml";
  std::ofstream(path) << "name: ring\nkind: rendezvous\nseed: 1\nlength_unit_m: 1000\nstep_s: 2\narrival_radius_m: 50\n"
                      << "vehicles:\n  type: constant_speed\n  speed_mps: 50\n  max_curvature_per_m: 0.002\n"
                      << "  radius_m: 2\n  safety_radius_m: 50\n  on_agent_loss: remove\n  starts:\n"
                      << starts << "formation:\n  x_m: 0\n  y_m: 0\n  heading_rad: 0\n  slots:\n"
                      << slots << "planner:\n  name: dcpso\n  particles: 20\n  generations: 20\n";
  return path;
}

std::set<int> pids_of(const nlohmann::json& report) {
  std::set<int> pids;
  for (const auto& vehicle : report.at("vehicles")) pids.insert(vehicle.at("pid").get<int>());
  return pids;
}

TEST(Groups, TwelveVehiclesInFourProcessesAreTheRunThatOneProcessMakes) {
  const ScratchFolder out;
  const std::string ring = ring_scenario(out.path(), 12);
  const SkeinRun memory = skein_run(ring, kDomain, out.path() + "/a", {"--in-process"});
  ASSERT_FALSE(memory.report.is_null()) << memory.ended.err;
  for (const auto& [per_process, processes] : {std::pair{3, 4U}, {5, 3U}, {12, 1U}}) {
    const SkeinRun run = skein_run(ring, kDomain, out.path() + "/" + std::to_string(per_process),
                                   {"--per-process", std::to_string(per_process)});
    ASSERT_FALSE(run.report.is_null()) << run.ended.err;
    EXPECT_EQ(run.ended.exit_code, memory.ended.exit_code) << run.ended.err;
    EXPECT_EQ(run.report.at("state_hash"), memory.report.at("state_hash")) << per_process;
    EXPECT_EQ(run.report.at("roster_changes").size(), 0U);
    EXPECT_EQ(pids_of(run.report).size(), processes);
    EXPECT_EQ(run.report.at("processes").size(), 12U) << "an entry for each agent";
    for (const auto& process : run.report.at("processes")) EXPECT_EQ(process.at("ended_by"), "exit status 0");
    EXPECT_GT(run.report.at("pss_mb_per_agent"), 0.0);
    EXPECT_TRUE(gone_within(out.path(), 5.0));
  }
}

class KilledGroup : public testing::TestWithParam<std::string> {};

TEST_P(KilledGroup, LosesAllItsAgentsInOneTickAndTheReplayGivesTheSameHash) {
  const ScratchFolder out;
  const std::string ring = ring_scenario(out.path(), 6);
  const SkeinRun run = skein_run(ring, kDomain, out.path() + "/a", {"--per-process", "2", "--fault", GetParam()});
  ASSERT_FALSE(run.report.is_null()) << run.ended.err;
  EXPECT_EQ(run.ended.exit_code, 4) << run.ended.err;
  const auto& changes = run.report.at("roster_changes");
  ASSERT_EQ(changes.size(), 2U) << changes.dump(2);
  EXPECT_EQ(changes[0].at("agent"), 3);
  EXPECT_EQ(changes[1].at("agent"), 4);
  EXPECT_EQ(changes[0].at("round"), changes[1].at("round"));
  EXPECT_EQ(changes[1].at("reason"), "process_ended");
  const SkeinRun replay =
      skein_run(ring, kDomain, out.path() + "/b", {"--in-process", "--roster", out.path() + "/a/report.json"});
  ASSERT_FALSE(replay.report.is_null()) << replay.ended.err;
  EXPECT_EQ(replay.report.at("state_hash"), run.report.at("state_hash"));
  EXPECT_EQ(replay.report.at("roster_changes"), changes);
}

INSTANTIATE_TEST_SUITE_P(InBothPhases, KilledGroup, testing::Values("kill:4@plan:5", "kill:3@fly:20"),
                         [](const auto& parameter) { return "Fault" + std::to_string(parameter.index); });

TEST(Groups, OneRefusedIdEndsItsProcessAndItsOthersLeave) {
  const ScratchFolder out;
  const std::vector<std::string> bus{"--domain", std::to_string(kDomain), "--swarm", "e2e-group"};
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), bus.begin(), bus.end());
    return arguments;
  };
  Program world(with({binary("skein-simworld"), ring_scenario(out.path(), 4), "--out", out.path()}));
  Program stranger(with({binary("skein-agent"), "--id", "3,4,9"}));
  const Ended refused = stranger.wait(60.0);
  EXPECT_EQ(refused.exit_code, 3) << refused.err;
  EXPECT_NE(refused.err.find("agent 9: the mission has no vehicle 9"), std::string::npos) << refused.err;
  Program first(with({binary("skein-agent"), "--id", "1,3"}));
  Program second(with({binary("skein-agent"), "--id", "2,4"}));
  EXPECT_NE(world.wait(120.0).exit_code, 3);
  EXPECT_EQ(first.wait(30.0).exit_code, 0);
  EXPECT_EQ(second.wait(30.0).exit_code, 0);
}

}  // namespace
}  // namespace skein::e2e
