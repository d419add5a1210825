// Only whole processes can prove it: the world may die at any moment, and started again from its checkpoint it brings
// the run to the state hash and the figures of one in which nothing happened, under the same agents.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <memory>

#include "planner/core/random/random_stream.hpp"
#include "simworld/lockstep/faults.hpp"
#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

constexpr unsigned kDomain = 84;

struct Place {
  const char* scenario;
  unsigned rounds;  ///< of planning
  unsigned steps;
};
constexpr Place kPlaces[] = {{"rendezvous-2d", 50, 1300}, {"transit-corridor", 1, 30}};

/// What must not depend on whether the world died; answers to the last tick may have gone to the dead world.
nlohmann::json figures_of(const nlohmann::json& report) {
  nlohmann::json figures;
  for (const char* key : {"success", "exit_code", "reason", "completed_without", "state_hash", "seed", "steps",
                          "rounds", "plan_spread_m", "collisions", "near_misses", "min_separation_m", "min_clearance_m",
                          "separations", "vehicles", "radio", "partitions", "roster_changes", "late_steps"}) {
    if (report.contains(key)) figures[key] = report.at(key);
  }
  for (auto& vehicle : figures.at("vehicles")) vehicle.erase("pid");
  for (const char* topic : {"representative", "obstacle_map"}) {
    figures["topics"][topic] = report.at("topics").at(topic);
  }
  return figures;
}

nlohmann::json undisturbed(const Place& place, std::uint64_t seed) {
  const ScratchFolder out;
  const SkeinRun run =
      skein_run(scenario_path(place.scenario), kDomain, out.path(), {"--in-process", "--seed", std::to_string(seed)});
  return figures_of(run.report);
}

TEST(WorldDeath, AtMomentsOnPurposeEndsWithTheHashAndFiguresOfTheUndisturbedRun) {
  const unsigned deaths = seeds_or("SKEIN_E2E_DEATHS", 4);
  RandomStream random(81, 0, Purpose::Test, 0);
  for (unsigned i = 0; i < deaths; ++i) {
    const ScratchFolder out;
    const Place& place = kPlaces[i % 2];
    const bool planning = random.uniform() < 0.3;
    const auto at = static_cast<std::uint32_t>(1 + random.below(planning ? place.rounds : place.steps));
    const Fault fault{FaultKind::Kill, kWorldId, planning ? Phase::Planning : Phase::Flying, at};
    const SkeinRun run =
        skein_run(scenario_path(place.scenario), kDomain, out.path() + "/run",
                  {"--seed", std::to_string(i), "--checkpoint", out.path() + "/checkpoint", "--fault", text_of(fault)});
    const std::string what = std::string(place.scenario) + " " + text_of(fault) + "\n" + run.ended.err;
    ASSERT_FALSE(run.report.is_null()) << what;
    EXPECT_EQ(figures_of(run.report), undisturbed(place, i)) << what;
    EXPECT_EQ(run.report.at("world_restarts"), 1) << what;
    EXPECT_NE(run.ended.err.find("the world died of signal 9 (Killed): started again"), std::string::npos) << what;
    EXPECT_TRUE(gone_within(out.path(), 5.0)) << what;
  }
}

/// The world of the run whose files are in the folder.
pid_t world_of(const ScratchFolder& out) {
  const std::vector<pid_t> worlds = processes_with(binary("skein-simworld"));
  for (const pid_t pid : processes_with(out.path())) {
    if (std::find(worlds.begin(), worlds.end(), pid) != worlds.end()) return pid;
  }
  return -1;
}

TEST(WorldDeath, AtAnyMomentOfTheWallClockEndsWithTheHashAndFiguresOfTheUndisturbedRun) {
  const unsigned deaths = seeds_or("SKEIN_E2E_DEATHS", 4);
  RandomStream random(82, 0, Purpose::Test, 0);
  for (unsigned i = 0; i < deaths; ++i) {
    const ScratchFolder out;
    const Place& place = kPlaces[i % 2];
    Program run({binary("skein"), "run", scenario_path(place.scenario), "--json", "--seed", std::to_string(i), "--out",
                 out.path() + "/run", "--checkpoint", out.path() + "/checkpoint", "--domain", std::to_string(kDomain)});
    ASSERT_TRUE(run.read_until("discovery", 30.0));
    run.read_until("", 0.8 * random.uniform());  // from discovery to flight
    const pid_t world = world_of(out);
    const bool killed = world > 0 && kill(world, SIGKILL) == 0;
    const Ended ended = run.wait(60.0);
    const auto report = nlohmann::json::parse(ended.out, nullptr, false);
    const std::string what = std::string(place.scenario) + ", run " + std::to_string(i) + "\n" + ended.err;
    ASSERT_FALSE(report.is_discarded()) << what;
    EXPECT_EQ(figures_of(report), undisturbed(place, i)) << what;
    EXPECT_LE(report.at("world_restarts"), killed ? 1 : 0) << what;
  }
}

/// World and agents of a rendezvous in terminals of their own.
class Terminals {
 public:
  explicit Terminals(std::string swarm) : swarm_(std::move(swarm)) {}

  [[nodiscard]] std::unique_ptr<Program> world(const std::string& out,
                                               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{
        binary("skein-simworld"), scenario_path("rendezvous-2d"), "--out", out + "/run", "--checkpoint",
        out + "/checkpoint"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return start(arguments);
  }
  [[nodiscard]] std::unique_ptr<Program> agent(unsigned id) const {
    return start({binary("skein-agent"), "--id", std::to_string(id)});
  }

 private:
  [[nodiscard]] std::unique_ptr<Program> start(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--domain", std::to_string(kDomain), "--swarm", swarm_});
    return std::make_unique<Program>(arguments);
  }

  std::string swarm_;
};

TEST(WorldDeath, AgentsHoldAndSayThatTheyDoUntilTheWorldIsStartedAgainByHand) {
  const ScratchFolder out;
  const Terminals terminals("world-death");
  const auto first = terminals.world(out.path(), {"--realtime", "50"});
  std::vector<std::unique_ptr<Program>> agents;
  for (const unsigned id : {1U, 2U, 3U}) agents.push_back(terminals.agent(id));
  ASSERT_TRUE(first->read_until("\"phase\":\"flying\"", 60.0));
  const Ended twice = terminals.world(out.path())->wait(30.0);
  EXPECT_EQ(twice.exit_code, 3) << twice.err;
  EXPECT_NE(twice.err.find("another world has it open"), std::string::npos) << twice.err;
  first->signal_group(SIGKILL);
  EXPECT_EQ(first->wait(10.0).exit_code, 137);
  for (const auto& agent : agents) ASSERT_TRUE(agent->read_until("no tick from the world for 2.5 s, holding", 30.0));

  const Ended other = terminals.world(out.path(), {"--seed", "9"})->wait(30.0);
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_EQ(other.err, "--checkpoint " + out.path() + "/checkpoint: its run has seed 1, this one 9\n");
  const Ended second = terminals.world(out.path())->wait(60.0);
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_NE(second.err.find("goes on with the run from its checkpoint"), std::string::npos) << second.err;
  for (const auto& agent : agents) {
    const Ended ended = agent->wait(30.0);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_NE(ended.err.find("the world ticks again"), std::string::npos) << ended.err;
  }
  std::ifstream file(out.path() + "/run/report.json");
  const auto report = nlohmann::json::parse(file);
  nlohmann::json figures = figures_of(report);
  nlohmann::json whole = undisturbed(kPlaces[0], 1);
  figures.erase("late_steps");
  whole.erase("late_steps");
  EXPECT_EQ(figures, whole);
  const Ended third = terminals.world(out.path())->wait(30.0);
  EXPECT_EQ(third.exit_code, 2);
  EXPECT_EQ(third.err,
            "--checkpoint " + out.path() + "/checkpoint: its run has ended: all vehicles arrived in formation\n");
}

TEST(WorldDeath, WhatCannotGoOnIsRefusedInOneLine) {
  const ScratchFolder out;
  const std::string small = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";
  const SkeinRun bare = skein_run(small, kDomain, out.path() + "/a", {"--fault", "kill:world@plan:2"});
  EXPECT_EQ(bare.ended.exit_code, 2);
  EXPECT_EQ(bare.ended.err,
            "--fault kill:world@plan:2: a world goes on from a checkpoint alone: add --checkpoint DIR\n");
  const std::vector<std::string> kept{"--checkpoint", out.path() + "/checkpoint"};
  EXPECT_EQ(skein_run(small, kDomain, out.path() + "/b", kept).ended.exit_code, 0);
  const SkeinRun again = skein_run(small, kDomain, out.path() + "/c", kept);
  EXPECT_EQ(again.ended.exit_code, 2);
  EXPECT_NE(again.ended.err.find("it holds a run already"), std::string::npos) << again.ended.err;
}

}  // namespace
}  // namespace skein::e2e
