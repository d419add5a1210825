// Commands and injections at the world: taken once, at the next tick, or refused with a reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "simworld/checkpoint/round_record.hpp"
#include "tests/simworld/lockstep/stage.hpp"

namespace skein {
namespace {

using test::Stage;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using State = WorldSession::State;

Command command(std::uint64_t id, OrderKind kind, AgentId agent = kAllAgents, double deadline_s = 5.0) {
  return {test::kRun, {id, agent, kind, Vec3::Zero(), 0.0}, deadline_s};
}

Inject injection(std::uint64_t id, InjectionKind kind, AgentId agent = 0) {
  Inject inject{test::kRun, {}, 5.0};
  inject.injection.id = id;
  inject.injection.kind = kind;
  inject.injection.agent = agent;
  return inject;
}

Inject sphere(std::uint64_t id) {
  Inject inject = injection(id, InjectionKind::Obstacle);
  inject.injection.position_m = Vec3(5e3, 5e3, 50.0);
  inject.injection.velocity_mps = Vec3(-1.0, 0.0, 0.0);
  inject.injection.radius_m = 2.0;
  return inject;
}

/// Three agents in their first flight step. @return its tick
Tick take_off(Stage& stage) {
  return stage.round(stage.start(), AgentMode::Ready);
}

OrderAnswer answer_in(const Tick& tick, std::uint64_t id) {
  const auto found = std::ranges::find(tick.answers, id, &OrderAnswer::id);
  return found == tick.answers.end() ? OrderAnswer{} : *found;
}

TEST(SessionSteering, ACommandTakesEffectWithTheNextTickAndItsAcknowledgementsAreTold) {
  Stage stage(3);
  const Tick first = take_off(stage);
  stage.say(command(77, OrderKind::Hold));
  const Tick second = stage.round(first, AgentMode::Flying);
  ASSERT_EQ(second.orders.size(), 1U);
  EXPECT_EQ(second.orders[0], (Order{77, kAllAgents, OrderKind::Hold, Vec3::Zero(), 0.0}));
  EXPECT_EQ(answer_in(second, 77).result, OrderResult::Accepted);
  EXPECT_EQ(answer_in(second, 77).round, second.round);
  for (const AgentId agent : {1U, 3U}) {
    Beacon beacon = test::closing(agent, second.round, AgentMode::Holding);
    beacon.acknowledged = {77};
    stage.say(beacon);
  }
  stage.say(test::closing(2, second.round, AgentMode::Flying));
  stage.at(stage.now_s);
  const Tick third = stage.last_tick();
  EXPECT_TRUE(third.orders.empty());
  EXPECT_THAT(answer_in(third, 77).acknowledged, ElementsAre(1U, 3U));
  ASSERT_EQ(stage.session.run().orders().size(), 1U);
  EXPECT_EQ(stage.session.run().orders()[0].round, second.round);
  EXPECT_THAT(stage.session.run().orders()[0].acknowledged, ElementsAre(1U, 3U));
}

TEST(SessionSteering, AnIdIsTakenOnce) {
  Stage stage(2);
  Tick tick = take_off(stage);
  for (int copy = 0; copy < 3; ++copy) {
    stage.say(command(5, OrderKind::Hold, 2));
    tick = stage.round(tick, AgentMode::Flying);
    EXPECT_EQ(tick.orders.size(), copy == 0 ? 1U : 0U);
  }
}

TEST(SessionSteering, RefusesWithAReason) {
  Stage stage(2);
  const Tick planning = stage.start();
  stage.say(command(1, OrderKind::Hold));
  const Tick first = stage.round(planning, AgentMode::Ready);
  EXPECT_EQ(answer_in(first, 1).result, OrderResult::NotFlying);
  stage.say(command(2, OrderKind::Hold, 9));
  stage.say(command(3, OrderKind::Start));
  stage.say(command(4, OrderKind::Goto));
  stage.say(command(5, OrderKind::Abort, 1));
  stage.say(injection(6, InjectionKind::Kill, 1));
  stage.say(injection(7, InjectionKind::Kill, 9));
  Inject flat = sphere(8);
  flat.injection.radius_m = 0.0;
  stage.say(flat);
  const Tick tick = stage.round(first, AgentMode::Flying);
  EXPECT_TRUE(tick.orders.empty());
  EXPECT_EQ(answer_in(tick, 2).result, OrderResult::UnknownAgent);
  EXPECT_THAT(answer_in(tick, 2).text, HasSubstr("no vehicle 9"));
  EXPECT_EQ(answer_in(tick, 3).result, OrderResult::Started);
  EXPECT_EQ(answer_in(tick, 4).result, OrderResult::Refused);
  EXPECT_EQ(answer_in(tick, 5).result, OrderResult::Refused);
  EXPECT_EQ(answer_in(tick, 6).result, OrderResult::NoLauncher);
  EXPECT_EQ(answer_in(tick, 7).result, OrderResult::UnknownAgent);
  EXPECT_EQ(answer_in(tick, 8).result, OrderResult::Refused);
}

// A round waits for who is silent: not for who is to be ended anyway.
TEST(SessionSteering, AnAbortDoesNotWaitForWhoIsSilent) {
  Stage stage(2);
  const Tick first = take_off(stage);
  stage.say(test::closing(1, first.round, AgentMode::Flying));
  stage.until(stage.now_s + 1.0);
  stage.say(command(9, OrderKind::Abort));
  stage.until(stage.now_s + 1.5);
  const Tick last = stage.last_tick();
  EXPECT_EQ(last.phase, Phase::Finished);
  EXPECT_EQ(answer_in(last, 9).result, OrderResult::Accepted);
  EXPECT_THAT(stage.session.outcome().reason, HasSubstr("aborted by command"));
}

TEST(SessionSteering, ARestartOfWhoIsSilentIsDoneAtOnceAndOnlyThat) {
  test::FakeControl control;
  Stage stage(3, {}, &control);
  const Tick first = take_off(stage);
  stage.say(test::closing(1, first.round, AgentMode::Flying));
  stage.say(injection(9, InjectionKind::Restart, 2));
  stage.until(stage.now_s + 3.0);
  EXPECT_THAT(control.restarted, IsEmpty()) << "agent 3 is silent too, and nobody said that it is to end";
  EXPECT_TRUE(stage.session.silent_for(0.5, stage.now_s) == std::vector<AgentId>{3});
  stage.say(test::closing(3, first.round, AgentMode::Flying));
  stage.at(stage.now_s);
  EXPECT_THAT(control.restarted, ElementsAre(2U));
}

TEST(SessionSteering, ACommandThatEndsNobodyWaitsForWhoIsSilent) {
  test::FakeControl control;
  Stage stage(2, {}, &control);
  const Tick first = take_off(stage);
  stage.say(test::closing(1, first.round, AgentMode::Flying));
  stage.say(command(8, OrderKind::Hold));
  stage.say(injection(9, InjectionKind::Kill, 1));
  stage.say(injection(10, InjectionKind::Pause, 2));
  stage.until(stage.now_s + 4.0);
  EXPECT_EQ(stage.session.silent_for(0.5, stage.now_s), std::vector<AgentId>{2});
}

TEST(SessionSteering, NobodyIsSentUnderTheGround) {
  Scenario level;
  level.mission = test::abreast(2);
  level.mission.terrain = Terrain{};
  Stage stage(level);
  const Tick first = take_off(stage);
  Command down = command(1, OrderKind::Goto, 1);
  down.order.to_m = Vec3(10.0, 20.0, -0.5);
  stage.say(down);
  Command up = command(2, OrderKind::Goto, 2);
  up.order.to_m = Vec3(10.0, 20.0, 0.5);
  stage.say(up);
  const Tick tick = stage.round(first, AgentMode::Flying);
  EXPECT_EQ(answer_in(tick, 1).result, OrderResult::Refused);
  EXPECT_EQ(answer_in(tick, 1).text, "that point is 0.5 m under the ground");
  EXPECT_EQ(answer_in(tick, 2).result, OrderResult::Accepted);
}

TEST(SessionSteering, WhatWaitsPastItsDeadlineExpires) {
  Stage stage(2);
  const Tick tick = take_off(stage);
  stage.say(command(1, OrderKind::Hold, kAllAgents, 0.5));
  stage.at(stage.now_s);
  stage.at(stage.now_s + 1.0);
  const Tick next = stage.round(tick, AgentMode::Flying);
  EXPECT_TRUE(next.orders.empty());
  EXPECT_EQ(answer_in(next, 1).result, OrderResult::Expired);
}

TEST(SessionSteering, OneOfAnotherRunIsRefusedAsASample) {
  Stage stage(2);
  const Tick tick = take_off(stage);
  Command other = command(1, OrderKind::Hold);
  other.run = test::kRun + 1;
  stage.say(other);
  EXPECT_TRUE(stage.round(tick, AgentMode::Flying).orders.empty());
  EXPECT_EQ(stage.session.refused_samples().of(WireFaultReason::WrongRun), 1U);
}

TEST(SessionSteering, AnAbortEndsTheRunWithTheNextTick) {
  Stage stage(2);
  const Tick tick = take_off(stage);
  stage.say(command(1, OrderKind::Abort));
  const Tick last = stage.round(tick, AgentMode::Flying);
  EXPECT_EQ(last.phase, Phase::Finished);
  ASSERT_TRUE(last.outcome.has_value());
  EXPECT_EQ(last.outcome->exit_code, 1);
  EXPECT_EQ(last.outcome->reason, "aborted by command");
  EXPECT_EQ(last.orders.size(), 1U);
}

TEST(SessionSteering, WaitsForTheStartIfItIsTold) {
  SessionOptions options;
  options.wait_start = true;
  options.startup_timeout_s = 5.0;
  Stage stage(2, options);
  stage.port.sees = {test::kWorldNonce, test::nonce_of(1), test::nonce_of(2)};
  stage.introduce(1);
  stage.introduce(2);
  stage.until(20.0);  // who waits for the operator does not time out
  EXPECT_EQ(stage.session.state(), State::Waiting);
  stage.say(command(1, OrderKind::Hold));
  stage.say(command(2, OrderKind::Start));
  stage.at(20.5);
  EXPECT_EQ(stage.session.state(), State::Running);
  const Tick tick = stage.last_tick();
  EXPECT_EQ(tick.round, 1U);
  ASSERT_EQ(tick.orders.size(), 1U);
  EXPECT_EQ(tick.orders[0].kind, OrderKind::Start);
  EXPECT_EQ(answer_in(tick, 1).result, OrderResult::NotFlying);
  EXPECT_EQ(answer_in(tick, 2).round, 1U);
}

TEST(SessionSteering, AnInjectedObstacleIsThereFromTheNextRoundOn) {
  Stage stage(2);
  const Tick tick = take_off(stage);
  stage.say(sphere(9));
  const Tick next = stage.round(tick, AgentMode::Flying);
  EXPECT_EQ(answer_in(next, 9).result, OrderResult::Accepted);
  ASSERT_EQ(stage.session.run().world().movers().size(), 1U);
  const MoverRecord& mover = stage.session.run().world().movers()[0];
  EXPECT_TRUE(mover.present);
  EXPECT_EQ(mover.position_m, Vec3(5e3, 5e3, 50.0));
  EXPECT_EQ(mover.appeared_step, next.step);
  (void)stage.round(next, AgentMode::Flying);
  EXPECT_LT(stage.session.run().world().movers()[0].position_m.x(), 5e3);
}

TEST(SessionSteering, FaultsGoToTheLauncher) {
  test::FakeControl control;
  Stage stage(2, {}, &control);
  const Tick tick = take_off(stage);
  stage.say(injection(1, InjectionKind::Kill, 2));
  for (const AgentId agent : {1U, 2U}) stage.say(test::closing(agent, tick.round, AgentMode::Flying));
  stage.at(stage.now_s);
  EXPECT_THAT(control.killed, ElementsAre(2U));
  stage.session.process_ended(2, stage.now_s);
  stage.at(stage.now_s);
  const Tick next = stage.last_tick();
  EXPECT_EQ(next.roster.size(), 1U);
  EXPECT_EQ(answer_in(next, 1).result, OrderResult::Accepted);
}

TEST(SessionSteering, ALandedVehicleEndsItsMission) {
  Stage stage(2);
  Tick tick = take_off(stage);
  for (const AgentId agent : {1U, 2U}) {
    stage.say(test::closing(agent, tick.round, agent == 1 ? AgentMode::Landed : AgentMode::Flying));
  }
  stage.at(stage.now_s);
  tick = stage.last_tick();
  EXPECT_EQ(stage.session.run().world().vehicle(1).status, VehicleStatus::Landed);
  EXPECT_TRUE(stage.session.run().world().vehicle(1).landed);
  stage.say(command(3, OrderKind::Hold, 1));
  EXPECT_EQ(answer_in(stage.round(tick, AgentMode::Flying), 3).result, OrderResult::NotLive);
}

TEST(SessionSteering, ARoundIsKeptWithWhatItTookUp) {
  RoundInputs inputs;
  inputs.round = 3;
  inputs.steered.orders = {{7, 2, OrderKind::Goto, Vec3(1.0, 2.0, 3.0), 4.0}};
  inputs.steered.injections = {sphere(8).injection};
  const auto again = round_inputs_from(to_bytes(inputs), WireContext{});
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->steered.orders, inputs.steered.orders);
  EXPECT_EQ(again->steered.injections, inputs.steered.injections);
}

}  // namespace
}  // namespace skein
