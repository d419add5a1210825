// The protocol alone: three agents that agree on a plan, or on having none, in the same rounds.
#include "agent/behaviours/replanning.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/agent/behaviours/swarm_flight.hpp"

namespace skein::test {
namespace {

/// Three of them, each heard by the others a round later; every step has the rounds that the world makes.
class Agreement {
 public:
  explicit Agreement(const Mission& told) : mission(told) {
    for (const VehicleSpec& vehicle : mission.vehicles) agents.emplace(vehicle.id, Replanning(mission, vehicle.id));
    tick.step = 1;
  }

  Revision revision_of(AgentId id) const {
    Revision own;
    own.pose = vehicle_of(mission, id).start;
    if (bad == id) own.pose.position_m = Vec3(120.0, 60.0, 20.0);  // within the known obstacle
    own.speed_mps = 10.0;
    return own;
  }

  /// One round; `caller` calls in it.
  std::map<AgentId, ReplanEvent> round(AgentId caller = 0) {
    bool engaged = caller != 0;
    for (const auto& [id, agent] : agents) engaged = engaged || agent.engaged();
    tick.phase =
        engaged && caller == 0 && in_step + 1 < mission.planner.rounds_per_step ? Phase::Planning : Phase::Flying;
    ++tick.round;
    std::vector<Representative> samples;
    for (const auto& [id, agent] : agents) {
      if (!agent.sample()) continue;
      samples.push_back(*agent.sample());
      samples.back().round = tick.round - 1;
    }
    std::map<AgentId, ReplanEvent> events;
    for (auto& [id, agent] : agents) {
      std::vector<Representative> peers;
      for (const Representative& sample : samples) {
        if (sample.agent != id) peers.push_back(sample);
      }
      events[id] = agent.hear(tick, peers, true);
      if (events[id] == ReplanEvent::Join) agent.join(revision_of(id), 300.0);
      if (events[id] == ReplanEvent::Aim) agent.aim(agent.own().pose, 300.0, 0);
      if (id == caller) agent.call(tick, revision_of(id));
    }
    const bool flown = tick.phase == Phase::Flying;
    in_step = flown ? 0 : in_step + 1;
    if (flown) ++tick.step;
    return events;
  }

  /// Rounds until something other than None, Join or Aim happens to somebody; what happened to each.
  std::map<AgentId, ReplanEvent> until_the_end() {
    for (int k = 0; k < 5000; ++k) {
      auto events = round();
      for (const auto& [id, event] : events) {
        if (event == ReplanEvent::Switch || event == ReplanEvent::Fail) return events;
      }
    }
    return {};
  }

  Mission mission;
  std::map<AgentId, Replanning> agents;
  Tick tick;
  int in_step = 0;
  AgentId bad = 0;
};

const std::map<AgentId, ReplanEvent> kAllSwitch{
    {1, ReplanEvent::Switch}, {2, ReplanEvent::Switch}, {3, ReplanEvent::Switch}};
const std::map<AgentId, ReplanEvent> kAllFail{{1, ReplanEvent::Fail}, {2, ReplanEvent::Fail}, {3, ReplanEvent::Fail}};

TEST(Replanning, AllTurnToPlansOfOneLengthInTheStepThatWasAgreed) {
  Agreement swarm(surprise_mission(1));
  (void)swarm.round(2);
  (void)swarm.round();
  const std::uint32_t agreed = swarm.agents.at(1).switch_step();
  EXPECT_EQ(swarm.until_the_end(), kAllSwitch);
  EXPECT_EQ(swarm.tick.step, agreed + 1) << "the switch's step is flown";
  const NewPlan first = swarm.agents.at(1).take();
  EXPECT_NE(first.view, 0U);
  const double length_m = first.planner.path_length_m();
  for (const AgentId id : {2U, 3U}) {
    const NewPlan other = swarm.agents.at(id).take();
    EXPECT_NEAR(other.planner.path_length_m(), length_m, 1e-8 * length_m);
    EXPECT_EQ(other.view, first.view) << "the same representatives";
  }
}

TEST(Replanning, AFailureIsOneOfAllAndTheNextAttemptFollowsAfterABreak) {
  Agreement swarm(surprise_mission(1));
  swarm.bad = 3;
  (void)swarm.round(2);
  EXPECT_EQ(swarm.until_the_end(), kAllFail);
  const Replanning& agent = swarm.agents.at(2);
  EXPECT_EQ(agent.failures(), 1U);
  EXPECT_FALSE(agent.engaged());
  EXPECT_FALSE(agent.may_call(swarm.tick.step));
  while (!agent.may_call(swarm.tick.step)) (void)swarm.round();
  swarm.bad = 0;
  (void)swarm.round(2);
  EXPECT_EQ(swarm.until_the_end(), kAllSwitch);
  EXPECT_EQ(agent.failures(), 0U);
}

TEST(Replanning, WhoIsLostHoldsNobodyUp) {
  Agreement swarm(surprise_mission(1));
  (void)swarm.round(2);
  for (int k = 0; k < 20; ++k) (void)swarm.round();
  swarm.agents.erase(2);
  const auto events = swarm.until_the_end();
  EXPECT_EQ(events, (std::map<AgentId, ReplanEvent>{{1, ReplanEvent::Switch}, {3, ReplanEvent::Switch}}));
}

TEST(Replanning, ANewerCallTakesThePlaceOfAnAttempt) {
  Agreement swarm(surprise_mission(1));
  (void)swarm.round(2);
  for (int k = 0; k < 20; ++k) (void)swarm.round();
  swarm.agents.erase(2);
  swarm.agents.emplace(2, Replanning(swarm.mission, 2));
  (void)swarm.round(2);
  const auto events = swarm.round();
  for (const auto& [id, event] : events) EXPECT_EQ(event, ReplanEvent::Join) << id;
  EXPECT_EQ(swarm.until_the_end(), kAllSwitch);
}

TEST(Replanning, WhoTakesNoPartHearsNothing) {
  const Mission mission = surprise_mission(1);
  Replanning agent(mission, 1);
  Representative call;
  call.agent = 2;
  call.round = 7;
  call.revision.emplace();
  call.revision->attempt = 7;
  call.revision->switch_step = 90;
  Tick tick;
  tick.round = 8;
  tick.step = 5;
  tick.phase = Phase::Flying;
  EXPECT_EQ(agent.hear(tick, std::span(&call, 1), false), ReplanEvent::None);
  EXPECT_FALSE(agent.engaged());
  EXPECT_EQ(agent.hear(tick, std::span(&call, 1), true), ReplanEvent::Join);
  EXPECT_THROW(agent.call(tick, {}), std::logic_error) << "an attempt is under way";
}

}  // namespace
}  // namespace skein::test
