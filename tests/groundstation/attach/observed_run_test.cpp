#include "groundstation/attach/observed_run.hpp"

#include <gtest/gtest.h>

#include "idl/convert/convert.hpp"

namespace skein {
namespace {

Tick tick(std::uint64_t run, std::uint32_t round, Phase phase) {
  Tick tick;
  tick.run = run;
  tick.round = round;
  tick.phase = phase;
  tick.roster = {{1, 1, 11, false, false}, {2, 1, 12, false, false}};
  return tick;
}

Beacon beacon(AgentId agent, std::uint32_t round, AgentMode mode) {
  Beacon beacon;
  beacon.run = 7;
  beacon.agent = agent;
  beacon.incarnation = 1;
  beacon.nonce = 10 + agent;
  beacon.round = round;
  beacon.mode = mode;
  beacon.planned_length_m = 1000.0 * agent;
  return beacon;
}

TEST(ObservedRun, TellsProgressFromTicksAndBeacons) {
  ObservedRun run;
  EXPECT_FALSE(run.heard_tick());
  run.take(to_wire(tick(7, 12, Phase::Flying), {7, 0}));
  run.take(to_wire(beacon(1, 12, AgentMode::Arrived), {7, 0}));
  run.take(to_wire(beacon(2, 12, AgentMode::Flying), {7, 0}));
  ASSERT_TRUE(run.heard_tick());
  const nlohmann::json progress = run.progress();
  EXPECT_EQ(progress.at("phase"), "flying");
  EXPECT_EQ(progress.at("arrived"), 1);
  EXPECT_EQ(progress.at("live"), 2);
  EXPECT_EQ(progress.at("longest_m"), 2000.0);
  EXPECT_FALSE(run.outcome());
}

TEST(ObservedRun, LateCopiesChangeNothing) {
  ObservedRun run;
  run.take(to_wire(tick(7, 12, Phase::Flying), {7, 0}));
  run.take(to_wire(tick(7, 11, Phase::Planning), {7, 0}));
  run.take(to_wire(beacon(1, 12, AgentMode::Arrived), {7, 0}));
  run.take(to_wire(beacon(1, 11, AgentMode::Flying), {7, 0}));
  EXPECT_EQ(run.progress().at("phase"), "flying");
  EXPECT_EQ(run.progress().at("arrived"), 1);
}

TEST(ObservedRun, ANewRunStartsAnew) {
  ObservedRun run;
  run.take(to_wire(tick(7, 12, Phase::Flying), {7, 0}));
  run.take(to_wire(beacon(1, 12, AgentMode::Arrived), {7, 0}));
  run.take(to_wire(tick(8, 1, Phase::Planning), {8, 0}));
  EXPECT_EQ(run.progress().at("phase"), "planning");
  EXPECT_EQ(run.progress().at("arrived"), 0);
}

TEST(ObservedRun, TheLastTickHoldsTheOutcome) {
  ObservedRun run;
  Tick last = tick(7, 13, Phase::Finished);
  last.outcome = Outcome{4, "agent 2 was lost"};
  last.world_hash = 0xab;
  run.take(to_wire(last, {7, 0}));
  ASSERT_TRUE(run.outcome());
  EXPECT_EQ(run.outcome()->exit_code, 4);
  EXPECT_EQ(run.result().at("reason"), "agent 2 was lost");
  EXPECT_EQ(run.result().at("state_hash"), "00000000000000ab");
  EXPECT_EQ(run.result().at("success"), false);
}

TEST(ObservedRun, CountsWhatIsNoSample) {
  ObservedRun run;
  wire::Tick bad = to_wire(tick(7, 1, Phase::Planning), {7, 0});
  bad.phase(99);
  run.take(bad);
  EXPECT_FALSE(run.heard_tick());
  EXPECT_EQ(run.refused_samples(), 1U);
}

}  // namespace
}  // namespace skein
