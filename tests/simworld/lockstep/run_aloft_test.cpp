// The flight of a run in which something may move and the swarm may plan anew: senses, rounds of a step, the log.
#include <gtest/gtest.h>

#include "tests/simworld/lockstep/rounds.hpp"
#include "tests/simworld/missions.hpp"

namespace skein {
namespace {

using test::decide;

constexpr std::uint32_t kRounds = 4;

Mission replanning(AgentId count) {
  Mission mission = test::abreast(count);
  for (VehicleSpec& vehicle : mission.vehicles) {
    vehicle.slot_offset_m.x() = 500.0;
    vehicle.type = VehicleType::Multirotor;
    vehicle.max_acceleration_mps2 = 4.0;
  }
  mission.planner.replan = 1;
  mission.planner.rounds_per_step = kRounds;
  mission.controller.sensor_range_m = 24.0;
  return mission;
}

WorldOptions hovering() {
  WorldOptions options;
  options.on_agent_loss = OnAgentLoss::Hover;
  return options;
}

struct Flight {
  explicit Flight(const Mission& mission, const WorldOptions& options = hovering())
      : run(test::kRun, mission, options, false) {
    tick = run.begin(test::roster_of(static_cast<AgentId>(mission.vehicles.size())));
    tick = decide(run, tick, AgentMode::Ready);
  }
  void round(AgentMode mode, const test::Edit& edit = {}) { tick = decide(run, tick, mode, {}, edit); }

  Run run;
  Tick tick;
};

/// Agent 2 alone says so.
test::Edit second_says(AgentMode mode, SafetyReason reason = SafetyReason::None) {
  return [=](Beacon& beacon) {
    if (beacon.agent != 2) return;
    beacon.mode = mode;
    beacon.safety_reason = reason;
  };
}

TEST(Aloft, AStepHasItsPlanningRoundsWhileSomebodyPlansAnew) {
  Flight flight(replanning(2));
  flight.round(AgentMode::Flying);
  EXPECT_EQ(flight.tick.step, 2U);
  flight.round(AgentMode::Flying, second_says(AgentMode::Replanning));
  const Vec3 place_m = flight.run.world().vehicle(1).state.position_m;
  for (std::uint32_t i = 1; i < kRounds; ++i) {
    EXPECT_EQ(flight.tick.phase, Phase::Planning);
    EXPECT_EQ(flight.tick.step, 3U);
    EXPECT_EQ(flight.tick.time_s, 2.0);
    EXPECT_FALSE(flight.tick.roster[0].sense);
    EXPECT_EQ(flight.run.rounds_in_step(), kRounds);
    flight.round(AgentMode::Replanning);
  }
  EXPECT_EQ(flight.run.world().vehicle(1).state.position_m, place_m) << "time stands still";
  EXPECT_EQ(flight.tick.phase, Phase::Flying);
  EXPECT_EQ(flight.tick.step, 3U);
  EXPECT_EQ(flight.tick.time_s, 2.0);
  EXPECT_TRUE(flight.tick.roster[0].sense);
  flight.round(AgentMode::Flying);
  EXPECT_EQ(flight.tick.step, 4U);
  EXPECT_EQ(flight.tick.phase, Phase::Flying) << "nobody plans any more";
  EXPECT_EQ(flight.run.rounds_in_step(), 1U);
  EXPECT_GT(flight.run.world().vehicle(1).state.position_m.x(), place_m.x());
  EXPECT_EQ(flight.run.replan_rounds(), kRounds - 1);
  EXPECT_EQ(flight.run.planning_rounds(), 1U) << "those on the ground alone";
}

TEST(Aloft, ARunKnowsWhereItIsGoing) {
  Flight flight(replanning(2));
  const auto next = [&](AgentMode mode, std::span<const Loss> lost = {}) {
    Barrier barrier;
    barrier.open(flight.tick, 0.0);
    barrier.accept(test::closing(1, flight.tick.round, AgentMode::Flying));
    barrier.accept(test::closing(2, flight.tick.round, mode));
    return flight.run.next(barrier, lost);
  };
  const std::vector<Loss> second{{2, LossReason::Left}};
  EXPECT_EQ(next(AgentMode::Flying), (Moment{Phase::Flying, 2}));
  EXPECT_EQ(next(AgentMode::Replanning), (Moment{Phase::Planning, flight.tick.round + 1}));
  EXPECT_EQ(next(AgentMode::Replanning, second), (Moment{Phase::Flying, 2}));
  flight.round(AgentMode::Replanning);
  EXPECT_EQ(next(AgentMode::Flying), (Moment{Phase::Planning, flight.tick.round + 1}));
  for (std::uint32_t i = 2; i < kRounds; ++i) flight.round(AgentMode::Replanning);
  EXPECT_EQ(next(AgentMode::Flying), (Moment{Phase::Flying, 2}));
}

TEST(Aloft, OneRoundAStepNeedsNoPlanningRounds) {
  Mission mission = replanning(2);
  mission.planner.rounds_per_step = 1;
  Flight flight(mission);
  flight.round(AgentMode::Replanning);
  EXPECT_EQ(flight.tick.phase, Phase::Flying);
  EXPECT_EQ(flight.tick.step, 2U);
}

TEST(Aloft, AFailureToPlanDoesNotEndTheRun) {
  Flight flight(replanning(2));
  flight.round(AgentMode::Replanning);
  flight.round(AgentMode::Replanning, second_says(AgentMode::Failed));
  EXPECT_FALSE(flight.run.finished());
  WorldOptions options = hovering();
  options.max_rounds = 2;
  Flight patient(replanning(2), options);
  for (int i = 0; i < 40; ++i) patient.round(AgentMode::Replanning);
  EXPECT_FALSE(patient.run.finished()) << "max_rounds is of the ground";
}

TEST(Aloft, FiguresAreOfThePlanThatIsFlown) {
  Flight flight(replanning(2));
  const auto longer = [](Beacon& beacon) { beacon.planned_length_m = 2000.0 + beacon.agent; };
  flight.round(AgentMode::Replanning, longer);
  EXPECT_EQ(flight.run.plan()[0].length_m, 1001.0);
  for (std::uint32_t i = 1; i < kRounds; ++i) flight.round(AgentMode::Replanning, longer);
  flight.round(AgentMode::Flying, longer);
  EXPECT_EQ(flight.run.plan()[0].length_m, 2001.0);
  EXPECT_EQ(flight.run.plan()[1].length_m, 2002.0);
}

TEST(Aloft, WhoMissedAndPlansAnewIsWaitedForAgain) {
  Flight flight(replanning(1));
  flight.round(AgentMode::Arrived);
  EXPECT_EQ(flight.run.world().vehicle(1).status, VehicleStatus::Missed);
  Flight again(replanning(2));
  again.round(AgentMode::Flying, second_says(AgentMode::Arrived));
  EXPECT_EQ(again.run.world().vehicle(2).status, VehicleStatus::Missed);
  again.round(AgentMode::Flying);
  EXPECT_EQ(again.run.world().vehicle(2).status, VehicleStatus::Flying);
}

TEST(Aloft, ARunDoesNotEndWhileSomebodyWhoCameBackPlans) {
  Mission mission = replanning(2);
  mission.vehicles[0].slot_offset_m.x() = 2.0;  // where it is after four steps
  Flight flight(mission);
  flight.round(AgentMode::Flying);
  flight.tick = decide(flight.run, flight.tick, AgentMode::Flying, std::vector<Loss>{{2, LossReason::ProcessEnded}});
  Barrier barrier;
  barrier.open(flight.tick, 0.0);
  barrier.accept(test::closing(1, flight.tick.round, AgentMode::Flying));
  const std::vector<RosterEntry> back{{2, 2, 999, false, false}};
  flight.tick = flight.run.decide(barrier, {}, back);
  EXPECT_EQ(flight.run.world().vehicle(2).status, VehicleStatus::Rejoined);
  for (int i = 0; i < 40 && !flight.run.finished(); ++i) {
    flight.round(AgentMode::Flying, [](Beacon& beacon) {
      if (beacon.agent != 2) return;
      beacon.incarnation = 2;
      beacon.mode = AgentMode::Replanning;
    });
  }
  EXPECT_EQ(flight.run.world().vehicle(1).status, VehicleStatus::Arrived);
  EXPECT_FALSE(flight.run.finished());
}

TEST(Aloft, ARunDoesNotEndWhileSomebodyWhoMissedPlans) {
  Mission mission = replanning(2);
  mission.vehicles[0].slot_offset_m.x() = -17.0;  // where it is after two steps
  Flight without(mission);
  without.round(AgentMode::Flying, second_says(AgentMode::Arrived));
  EXPECT_EQ(without.run.world().vehicle(2).status, VehicleStatus::Missed);
  without.round(AgentMode::Flying, second_says(AgentMode::Arrived));
  EXPECT_TRUE(without.run.finished());
  Flight flight(mission);
  flight.round(AgentMode::Flying, second_says(AgentMode::Arrived));
  for (int i = 0; i < 20 && !flight.run.finished(); ++i) {
    flight.round(AgentMode::Flying, second_says(AgentMode::Replanning));
  }
  EXPECT_EQ(flight.run.world().vehicle(1).status, VehicleStatus::Arrived);
  EXPECT_EQ(flight.run.world().vehicle(2).status, VehicleStatus::Missed);
  EXPECT_FALSE(flight.run.finished());
}

TEST(Aloft, OfARendezvousWithASensorAllAreHeardAndMoversSeen) {
  WorldOptions options = hovering();
  Mover mover;
  mover.name = "sudden_obstacles.1";
  mover.position_m = Vec3(-5, 100, 0);
  mover.radius_m = 2.0;
  options.surprises.movers = {mover};
  Flight flight(replanning(3), options);
  const Sense sense = flight.run.sense_of(flight.tick.roster[0]);
  ASSERT_EQ(sense.heard.size(), 2U);
  EXPECT_EQ(sense.heard[1].agent, 3U);
  ASSERT_EQ(sense.tracks.size(), 1U);
  EXPECT_TRUE(sense.tracks[0].fixed);
  EXPECT_TRUE(sense.obeyed);
  EXPECT_TRUE(flight.run.sense_of(flight.tick.roster[1]).tracks.empty()) << "100 m away";
  flight.tick = decide(flight.run, flight.tick, AgentMode::Flying, std::vector<Loss>{{3, LossReason::ProcessEnded}});
  EXPECT_EQ(flight.run.sense_of(flight.tick.roster[0]).heard.size(), 1U) << "without agent it is but seen";
  Mission blind = replanning(3);
  blind.controller.sensor_range_m = 0.0;
  Flight without(blind, options);
  EXPECT_TRUE(without.run.sense_of(without.tick.roster[0]).heard.empty());
  EXPECT_TRUE(without.run.sense_of(without.tick.roster[0]).tracks.empty());
}

TEST(Aloft, ZoneStatesAreOfTheOpenStep) {
  Mission mission = replanning(1);
  Announcement zone;
  zone.shape = Cylinder{Vec2(900, 900), 5.0};
  zone.from_s = 2.0;
  zone.to_s = 3.0;
  zone.early_s = 0.0;
  mission.announced = {zone};
  Flight flight(mission);
  const auto state = [&] { return flight.run.sense_of(flight.tick.roster[0]).zones.at(0); };
  EXPECT_EQ(state(), ZoneState::Ahead);
  flight.round(AgentMode::Flying);
  flight.round(AgentMode::Flying);
  EXPECT_EQ(state(), ZoneState::Occupied);
  flight.round(AgentMode::Flying);
  flight.round(AgentMode::Flying);
  EXPECT_EQ(state(), ZoneState::Clear);
}

TEST(Aloft, BeingRammedHasAReasonOfItsOwn) {
  WorldOptions options = hovering();
  Mover mover;
  mover.name = "moving_obstacles.1";
  mover.position_m = Vec3(-5, 100, 0);
  mover.radius_m = 2.0;
  mover.motion = LineMotion{Vec3(-4, 0, 0)};
  options.surprises.movers = {mover};
  options.max_steps = 10;
  Flight flight(replanning(1), options);
  while (!flight.run.finished()) {
    flight.round(AgentMode::Flying, [](Beacon& beacon) { beacon.commanded_velocity_mps = Vec3::Zero(); });
  }
  EXPECT_EQ(flight.run.verdict().code, ExitCode::Failed);
  EXPECT_EQ(flight.run.verdict().reason, "vehicle 1 was rammed at rest by moving_obstacles.1 at step 5");
}

}  // namespace
}  // namespace skein
