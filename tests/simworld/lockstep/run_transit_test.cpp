// The course of a transit from hand-made answers: who senses whom, who gives up, when it is over.
#include <gtest/gtest.h>

#include "tests/simworld/lockstep/rounds.hpp"
#include "tests/simworld/transits.hpp"

namespace skein {
namespace {

using test::decide;

const Vec3 kFirst(6, 18, 6);
const Vec3 kSecond(46, 18, 6);  ///< 40 m from the first

Mission two(double radio_m, double sensor_m) {
  Mission mission =
      test::transit_of({test::crosser(1, kFirst), test::crosser(2, kSecond)}, {Vec3(74, 18, 6), Vec3(74, 30, 6)});
  mission.transit->radio.range_m = radio_m;
  mission.transit->sensor.range_m = sensor_m;
  return mission;
}

/// Who is lost stays where it is.
WorldOptions hovering() {
  WorldOptions options;
  options.on_agent_loss = OnAgentLoss::Hover;
  return options;
}

/// Nobody moves.
void stay(Beacon& beacon) {
  beacon.commanded_velocity_mps = Vec3::Zero();
}

/// What agent 1 hears in the third flight step; agent 2 is lost with that tick, if asked. Nobody has moved.
std::vector<HeardPeer> heard_by_first(const Mission& mission, const WorldOptions& options, bool lost) {
  skein::Run run(test::kRun, mission, options, false);
  const Tick first = decide(run, run.begin(test::roster_of(2)), AgentMode::Ready);
  const std::vector<Loss> losses{{2, LossReason::ProcessEnded}};
  const Tick aloft = decide(run, first, AgentMode::Flying, {}, stay);
  const Tick tick = decide(run, aloft, AgentMode::Flying, lost ? losses : std::vector<Loss>{}, stay);
  EXPECT_EQ(tick.phase, Phase::Flying);
  return run.sense_of(tick.roster[0]).heard;
}

TEST(TransitRun, LiveAgentsAreHeardWithinRadioRange) {
  EXPECT_TRUE(heard_by_first(two(39.9, 24), {}, false).empty());
  const auto heard = heard_by_first(two(40, 24), {}, false);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0], (HeardPeer{2, kSecond, Vec3::Zero(), false}));
  EXPECT_EQ(heard_by_first(two(10, 40), {}, false).size(), 1U) << "or seen, where the sensor reaches farther";
}

TEST(TransitRun, LostOnesOnlyWithinSensorRangeAndOnlyWhileTheyAreThere) {
  EXPECT_TRUE(heard_by_first(two(1000, 39.9), hovering(), true).empty());
  EXPECT_EQ(heard_by_first(two(1000, 40), hovering(), true).size(), 1U);
  EXPECT_EQ(heard_by_first(two(1, 40), hovering(), true).size(), 1U);
  EXPECT_TRUE(heard_by_first(two(1000, 1000), {}, true).empty()) << "removed";
}

TEST(TransitRun, SensesCarryWhatTheSensorSaw) {
  WorldOptions options;
  options.hidden = {{Box{Vec3(16, 0, 0), Vec3(20, 40, 9)}, "wall"}};
  skein::Run run(test::kRun, two(90, 24), options, false);
  const Tick tick = decide(run, run.begin(test::roster_of(2)), AgentMode::Ready);
  const Sense sense = run.sense_of(tick.roster[0]);
  EXPECT_EQ(sense.round, 2U);
  EXPECT_EQ(sense.pose.position_m, kFirst);
  EXPECT_EQ(sense.sight.at({4, 4, 0}), CellState::Occupied);
  EXPECT_EQ(sense.sight.at({3, 4, 0}), CellState::Free);
  EXPECT_EQ(sense.sight.at({5, 4, 0}), CellState::Unknown);
}

TEST(TransitRun, WhoHasLandedIsHeardAsLanded) {
  Mission mission = two(90, 24);
  mission.transit->goals_m[1] = kSecond + Vec3(10, 0, 0);
  skein::Run run(test::kRun, mission, {}, false);
  Tick tick = decide(run, run.begin(test::roster_of(2)), AgentMode::Ready);
  tick = decide(run, tick, AgentMode::Flying);
  const auto heard = run.sense_of(tick.roster[0]).heard;
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_TRUE(heard[0].landed);
}

TEST(TransitRun, CountsTheMapsOfTheRoundBefore) {
  skein::Run run(test::kRun, two(90, 24), {}, false);
  const Tick tick = decide(run, run.begin(test::roster_of(2)), AgentMode::Ready);
  EXPECT_FALSE(tick.roster[0].obstacle_map);
  Barrier barrier;
  barrier.open(tick, 0.0);
  for (const AgentId id : {1U, 2U}) {
    Beacon beacon = test::closing(id, tick.round, AgentMode::Flying);
    beacon.obstacle_map = id == 2;
    barrier.accept(beacon);
  }
  barrier.accept(test::map_sample(2, tick.round));
  const Tick next = run.decide(barrier, {});
  EXPECT_FALSE(next.roster[0].obstacle_map);
  EXPECT_TRUE(next.roster[1].obstacle_map);
  ASSERT_NE(run.radio(), nullptr);
  EXPECT_EQ(run.radio()->sent_samples(), 1U);
}

TEST(TransitRun, EndsWhenAllHaveArrived) {
  Mission mission = two(90, 24);
  mission.transit->goals_m = {kFirst + Vec3(20, 0, 0), kSecond + Vec3(20, 0, 0)};
  skein::Run run(test::kRun, mission, {}, false);
  Tick tick = decide(run, run.begin(test::roster_of(2)), AgentMode::Ready);
  tick = test::fly_on(run, tick, 10);
  EXPECT_EQ(tick.phase, Phase::Finished);
  EXPECT_EQ(run.steps_flown(), 2U);
  EXPECT_EQ(run.verdict().code, ExitCode::Success);
  EXPECT_EQ(run.verdict().reason, "all vehicles arrived");
}

TEST(TransitRun, EndsWhenNobodyIsOnTheWayAnyMore) {
  skein::Run run(test::kRun, two(90, 24), {}, false);
  Tick tick = decide(run, run.begin(test::roster_of(2)), AgentMode::Ready);
  const auto give_up = [](Beacon& beacon) {
    stay(beacon);
    beacon.mode = beacon.agent == 1 ? AgentMode::Unreachable : AgentMode::Deadlock;
  };
  tick = decide(run, tick, AgentMode::Flying, {}, stay);
  EXPECT_EQ(tick.phase, Phase::Flying);
  tick = decide(run, tick, AgentMode::Flying, {}, [](Beacon& beacon) {
    stay(beacon);
    if (beacon.agent == 1) beacon.mode = AgentMode::Unreachable;
  });
  EXPECT_EQ(tick.phase, Phase::Flying) << "the other still flies";
  EXPECT_EQ(run.world().vehicle(1).status, VehicleStatus::Unreachable);
  tick = decide(run, tick, AgentMode::Flying, {}, stay);
  EXPECT_EQ(run.world().vehicle(1).status, VehicleStatus::Flying) << "it took that back";
  tick = decide(run, tick, AgentMode::Flying, {}, give_up);
  EXPECT_EQ(tick.phase, Phase::Finished);
  EXPECT_EQ(run.verdict().code, ExitCode::Failed);
  EXPECT_EQ(run.verdict().reason, "vehicle 1: unreachable, vehicle 2: deadlock");
}

TEST(TransitRun, FliesTheExtraSteps) {
  Mission mission = two(90, 24);
  mission.transit->goals_m = {kFirst + Vec3(20, 0, 0), kSecond + Vec3(20, 0, 0)};
  WorldOptions options;
  options.extra_steps = 3;
  skein::Run run(test::kRun, mission, options, false);
  Tick tick = decide(run, run.begin(test::roster_of(2)), AgentMode::Ready);
  tick = test::fly_on(run, tick, 10);
  EXPECT_EQ(run.steps_flown(), 5U);
  EXPECT_EQ(run.verdict().code, ExitCode::Success);
}

TEST(TransitRun, ExtraStepsCountFromTheLastTimeThatAllHadEnded) {
  WorldOptions options;
  options.extra_steps = 2;
  skein::Run run(test::kRun, two(90, 24), options, false);
  Tick tick = decide(run, run.begin(test::roster_of(2)), AgentMode::Ready);
  for (const AgentMode mode : {AgentMode::Unreachable, AgentMode::Unreachable, AgentMode::Flying,
                               AgentMode::Unreachable, AgentMode::Unreachable}) {
    tick = decide(run, tick, mode, {}, stay);
    EXPECT_EQ(tick.phase, Phase::Flying);
  }
  tick = decide(run, tick, AgentMode::Unreachable, {}, stay);
  EXPECT_EQ(tick.phase, Phase::Finished);
  EXPECT_EQ(run.steps_flown(), 6U);
}

TEST(TransitRun, IsGivenUpAfterTheMostSteps) {
  WorldOptions options;
  options.max_steps = 4;
  skein::Run run(test::kRun, two(90, 24), options, false);
  Tick tick = decide(run, run.begin(test::roster_of(2)), AgentMode::Ready);
  for (int step = 0; step < 4; ++step) tick = decide(run, tick, AgentMode::Flying, {}, stay);
  EXPECT_EQ(tick.phase, Phase::Finished);
  EXPECT_EQ(run.verdict().reason, "the flight did not end within world.max_steps = 4 steps");
}

TEST(TransitRun, RefusesOrdersThatNobodyCanObey) {
  skein::Run run(test::kRun, two(90, 24), {}, false);
  Tick tick = decide(run, run.begin(test::roster_of(2)), AgentMode::Ready);
  const auto result = [&](OrderKind kind, AgentId agent, const Vec3& to_m = Vec3::Zero(), double speed_mps = 0.0) {
    const auto objection = run.objection({1, agent, kind, to_m, speed_mps}, {});
    return objection ? objection->result : OrderResult::Accepted;
  };
  for (const OrderKind kind : {OrderKind::Hold, OrderKind::Resume, OrderKind::Land}) {
    EXPECT_EQ(result(kind, 1), OrderResult::Accepted);
    EXPECT_EQ(result(kind, kAllAgents), OrderResult::Accepted);
  }
  EXPECT_EQ(result(OrderKind::Goto, 1, Vec3(20, 20, 6)), OrderResult::Accepted);
  EXPECT_EQ(result(OrderKind::Goto, kAllAgents, Vec3(20, 20, 6)), OrderResult::Refused);
  EXPECT_EQ(result(OrderKind::Goto, 1, Vec3(20, 20, 6), 11.0), OrderResult::Refused);
  for (const Vec3& outside : {Vec3(-1, 20, 6), Vec3(20, 40, 6), Vec3(20, 20, 3), Vec3(20, 20, 8)}) {
    EXPECT_EQ(result(OrderKind::Goto, 1, outside), OrderResult::Refused) << outside.transpose();
  }
  EXPECT_EQ(run.objection({1, 1, OrderKind::Goto, Vec3::Zero(), 0.0}, {})->text,
            "the point is outside the area: x 0 to 80, y 0 to 40, z 4 to 8 m");
  tick = decide(run, tick, AgentMode::Flying, {},
                [](Beacon& beacon) { beacon.mode = beacon.agent == 1 ? AgentMode::Landed : AgentMode::Flying; });
  EXPECT_EQ(tick.phase, Phase::Flying);
  EXPECT_EQ(result(OrderKind::Hold, 1), OrderResult::NotLive);
  EXPECT_EQ(result(OrderKind::Hold, 2), OrderResult::Accepted);
}

}  // namespace
}  // namespace skein
