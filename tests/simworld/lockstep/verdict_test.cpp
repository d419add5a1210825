// What a run came to: reason and exit code of every outcome.
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/simworld/lockstep/rounds.hpp"
#include "tests/simworld/missions.hpp"
#include "tests/simworld/transits.hpp"

namespace skein {
namespace {

using test::decide;

/// A run whose swarm is ready at once; `tick` opens the first flight step.
struct Flight {
  explicit Flight(const Mission& mission, WorldOptions options = {}, bool fail_fast = false)
      : run(test::kRun, mission, options, fail_fast) {
    tick = run.begin(test::roster_of(static_cast<AgentId>(mission.vehicles.size())));
    tick = decide(run, tick, AgentMode::Ready);
  }
  Verdict to_the_end() {
    tick = test::fly_on(run, tick, 1000);
    return run.verdict();
  }

  Run run;
  Tick tick;
};

TEST(Verdict, AllArrivedIsSuccess) {
  const Verdict verdict = Flight(test::abreast(2)).to_the_end();
  EXPECT_EQ(verdict.code, ExitCode::Success);
  EXPECT_EQ(verdict.reason, "all vehicles arrived in formation");
  EXPECT_TRUE(verdict.completed_without.empty());
}

TEST(Verdict, NeedsARunThatIsOver) {
  EXPECT_THROW((void)Flight(test::abreast(1)).run.verdict(), std::logic_error);
}

TEST(Verdict, NamesTheConstraintOfAFailedPlan) {
  skein::Run run(test::kRun, test::abreast(2), {}, false);
  const Tick tick = run.begin(test::roster_of(2));
  const Tick last = decide(run, tick, AgentMode::Planning, {}, [](Beacon& beacon) {
    if (beacon.agent != 2) return;
    beacon.mode = AgentMode::Failed;
    beacon.constraint = Constraint::Separation;
    beacon.constraint_peer = 1;
  });
  EXPECT_EQ(last.phase, Phase::Finished);
  EXPECT_EQ(run.verdict().code, ExitCode::Failed);
  EXPECT_EQ(run.verdict().reason, "planning failed: agent 2 cannot satisfy separation with agent 1");
}

TEST(Verdict, PlanningIsGivenUpAfterMaxRounds) {
  WorldOptions options;
  options.max_rounds = 2;
  skein::Run run(test::kRun, test::abreast(1), options, false);
  Tick tick = run.begin(test::roster_of(1));
  tick = decide(run, tick, AgentMode::Planning);
  EXPECT_FALSE(run.finished());
  tick = decide(run, tick, AgentMode::Planning);
  EXPECT_EQ(run.verdict().code, ExitCode::Failed);
  EXPECT_EQ(run.verdict().reason, "planning did not end within world.max_rounds = 2 rounds");
}

TEST(Verdict, FlightIsGivenUpAfterMaxSteps) {
  WorldOptions options;
  options.max_steps = 2;
  const Verdict verdict = Flight(test::abreast(1), options).to_the_end();
  EXPECT_EQ(verdict.code, ExitCode::Failed);
  EXPECT_EQ(verdict.reason, "the flight did not end within world.max_steps = 2 steps");
}

TEST(Verdict, CollisionsComeFirst) {
  Mission mission = test::abreast(2);
  mission.vehicles[1].start.position_m = Vec3(-25.0, 101.5, 0.0);
  Flight flight(mission);
  flight.tick = decide(flight.run, flight.tick, AgentMode::Flying, std::vector<Loss>{});
  flight.tick = decide(flight.run, flight.tick, AgentMode::Flying, std::vector<Loss>{{2, LossReason::Left}});
  const Verdict verdict = flight.to_the_end();
  EXPECT_EQ(verdict.code, ExitCode::Failed);
  EXPECT_EQ(verdict.reason, "vehicles 1 and 2 collided at step 1");
}

TEST(Verdict, ObstaclesAndZonesAreCollisions) {
  Mission mission = test::abreast(1);
  mission.zones = {{Cylinder{Vec2(-10.0, 100.0), 2.0}, false}};
  EXPECT_EQ(Flight(mission).to_the_end().reason, "vehicle 1 touched obstacles.1 at step 2");
  mission.zones = {{Box{Vec3(-12.0, 95.0, -10.0), Vec3(-8.0, 105.0, 10.0)}, true}};
  const Verdict verdict = Flight(mission).to_the_end();
  EXPECT_EQ(verdict.code, ExitCode::Failed);
  EXPECT_EQ(verdict.reason, "vehicle 1 touched no_fly.1 at step 2");
}

TEST(Verdict, NearMissesFailTheMission) {
  Mission mission = test::abreast(2);
  mission.vehicles[1].start.position_m.y() = mission.vehicles[1].slot_offset_m.y() = 106.0;
  const Verdict verdict = Flight(mission).to_the_end();
  EXPECT_EQ(verdict.code, ExitCode::Failed);
  EXPECT_EQ(verdict.reason, "vehicles 1 and 2 came within their safety radii at step 1 (6.0 m apart)");
}

TEST(Verdict, ArrivalsMoreThanAStepApartAreNoFormation) {
  Mission mission = test::abreast(2);
  mission.vehicles[1].start.position_m.x() = -36.0;
  const Verdict verdict = Flight(mission).to_the_end();
  EXPECT_EQ(verdict.code, ExitCode::Failed);
  EXPECT_EQ(verdict.reason, "arrivals are 1.10 s apart");
}

TEST(Verdict, AMissedSlotFailsTheMission) {
  Mission mission = test::abreast(1);
  mission.vehicles[0].start.position_m.y() = 140.0;
  Flight flight(mission);
  flight.tick = decide(flight.run, flight.tick, AgentMode::Arrived);
  EXPECT_EQ(flight.run.verdict().code, ExitCode::Failed);
  EXPECT_EQ(flight.run.verdict().reason, "vehicle 1 missed its slot");
}

TEST(Verdict, TheRestArriveWithoutALostAgent) {
  Flight flight(test::abreast(3));
  flight.tick = decide(flight.run, flight.tick, AgentMode::Flying, std::vector<Loss>{{2, LossReason::ProcessEnded}});
  const Verdict verdict = flight.to_the_end();
  EXPECT_EQ(verdict.code, ExitCode::AgentLost);
  EXPECT_EQ(verdict.completed_without, (std::vector<AgentId>{2}));
  EXPECT_EQ(verdict.reason, "agent 2 was lost at step 2, round 3: process_ended; the others arrived");
}

TEST(Verdict, LostAgentsAndAFailedMissionAreBothNamed) {
  WorldOptions options;
  options.max_steps = 2;
  Flight flight(test::abreast(2), options);
  flight.tick = decide(flight.run, flight.tick, AgentMode::Flying, std::vector<Loss>{{1, LossReason::Deadline}});
  const Verdict verdict = flight.to_the_end();
  EXPECT_EQ(verdict.code, ExitCode::AgentLost);
  EXPECT_TRUE(verdict.completed_without.empty());
  EXPECT_EQ(verdict.reason,
            "agent 1 was lost at step 2, round 3: deadline; the flight did not end within world.max_steps = 2 steps");
}

TEST(Verdict, NobodyLeftEndsTheRun) {
  Flight flight(test::abreast(2));
  const std::vector<Loss> lost{{1, LossReason::Left}, {2, LossReason::Deadline}};
  flight.tick = decide(flight.run, flight.tick, AgentMode::Flying, lost);
  const Verdict verdict = flight.run.verdict();
  EXPECT_EQ(verdict.code, ExitCode::AgentLost);
  EXPECT_TRUE(verdict.completed_without.empty());
  EXPECT_NE(verdict.reason.find("no agent is left"), std::string::npos) << verdict.reason;
}

TEST(Verdict, FailFastEndsAtTheFirstLoss) {
  Flight flight(test::abreast(2), {}, true);
  flight.tick = decide(flight.run, flight.tick, AgentMode::Flying, std::vector<Loss>{{2, LossReason::Left}});
  EXPECT_EQ(flight.tick.phase, Phase::Finished);
  EXPECT_EQ(flight.run.verdict().code, ExitCode::AgentLost);
  EXPECT_NE(flight.run.verdict().reason.find("ended at the first loss"), std::string::npos);
}

/// A transit of two, 20 m from their goals, that fly east at 10 m/s.
Verdict verdict_of_transit(const std::vector<Obstacle>& hidden, std::uint32_t max_steps) {
  const Vec3 east(20, 0, 0);
  const Mission mission = test::transit_of({test::crosser(1, Vec3(6, 6, 6)), test::crosser(2, Vec3(6, 18, 6))},
                                           {Vec3(6, 6, 6) + east, Vec3(6, 18, 6) + east});
  WorldOptions options;
  options.max_steps = max_steps;
  options.hidden = hidden;
  Flight flight(mission, options);
  while (!flight.run.finished()) {
    const auto go_east = [](Beacon& beacon) { beacon.commanded_velocity_mps = Vec3(10, 0, 0); };
    flight.tick = decide(flight.run, flight.tick, AgentMode::Flying, {}, go_east);
  }
  return flight.run.verdict();
}

TEST(Verdict, OfATransitEverybodyArrivesInAnyOrder) {
  const Verdict verdict = verdict_of_transit({}, 10);
  EXPECT_EQ(verdict.code, ExitCode::Success);
  EXPECT_EQ(verdict.reason, "all vehicles arrived");
  EXPECT_EQ(verdict_of_transit({}, 1).code, ExitCode::Failed);
}

TEST(Verdict, OfATransitNamesTheHiddenObstacleThatWasHit) {
  const Verdict verdict = verdict_of_transit({{Cylinder{Vec2(14, 18), 1.0}, "forest.4"}}, 10);
  EXPECT_EQ(verdict.code, ExitCode::Failed);
  EXPECT_EQ(verdict.reason, "vehicle 2 touched forest.4 at step 1");
}

}  // namespace
}  // namespace skein
