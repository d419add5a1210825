// An agent that was started without an id: it asks, is told, and waits while none is free.
#include "agent/runtime/id_request.hpp"

#include <gtest/gtest.h>

#include "tests/agent/runtime/played_world.hpp"

namespace skein {
namespace {

using test::FakeAgentPort;
using test::PlayedWorld;

void say(FakeAgentPort& port, const Tick& tick) {
  port.arrived.push_back(to_wire(tick, {0, test::kRun}));
}

std::vector<Beacon> beacons_of(FakeAgentPort& port) {
  std::vector<Beacon> beacons;
  for (const auto& sample : port.sent) beacons.push_back(from_wire(std::get<wire::Beacon>(sample), {}).value());
  port.sent.clear();
  return beacons;
}

TEST(IdRequest, IntroducesItselfAsAgentZeroEveryQuarterSecond) {
  FakeAgentPort port;
  IdRequest request(test::kNonce, port, 0.0);
  for (int hundredth = 0; hundredth <= 100; ++hundredth) request.poll(0.01 * hundredth);
  const auto beacons = beacons_of(port);
  EXPECT_GE(beacons.size(), 4U);
  EXPECT_LE(beacons.size(), 5U);
  for (const Beacon& beacon : beacons) {
    EXPECT_EQ(beacon.agent, kWorldId);
    EXPECT_EQ(beacon.incarnation, 0U);
    EXPECT_EQ(beacon.nonce, test::kNonce);
    EXPECT_EQ(beacon.round, 0U);
    EXPECT_FALSE(beacon.closes_round);
  }
  EXPECT_FALSE(request.heard_world());
  EXPECT_EQ(request.heard_world_s(), 0.0);
}

TEST(IdRequest, TakesTheIdThatATickGivesToItsNonce) {
  FakeAgentPort port;
  IdRequest request(test::kNonce, port, 0.0);
  Tick tick = PlayedWorld::tick(0, Phase::Waiting);
  tick.assigned = {{555, 1}};
  say(port, tick);
  request.poll(0.1);
  EXPECT_FALSE(request.id().has_value());  // somebody else's
  EXPECT_EQ(request.heard_world_s(), 0.1);
  tick.assigned = {{555, 1}, {test::kNonce, 2}};
  say(port, tick);
  request.poll(0.2);
  EXPECT_EQ(request.id(), 2U);
  (void)beacons_of(port);
  request.poll(10.0);
  EXPECT_TRUE(port.sent.empty());  // it asks no more
}

TEST(IdRequest, SaysWhichTickItHeardLast) {
  FakeAgentPort port;
  IdRequest request(test::kNonce, port, 0.0);
  say(port, PlayedWorld::tick(17, Phase::Planning));
  request.poll(0.0);
  EXPECT_EQ(beacons_of(port).at(0).round, 17U);
}

TEST(IdRequest, IsOverWhenTheWorldEndsWithoutAnAnswer) {
  FakeAgentPort port;
  IdRequest request(test::kNonce, port, 0.0);
  Tick last = PlayedWorld::tick(9, Phase::Finished);
  last.outcome = Outcome{0, "done"};
  say(port, last);
  request.poll(0.5);
  EXPECT_TRUE(request.over());
  EXPECT_TRUE(port.sent.empty());
}

TEST(IdRequest, SaysGoodbyeUnderItsNonce) {
  FakeAgentPort port;
  IdRequest request(test::kNonce, port, 0.0);
  request.leave(0.0);
  const auto beacons = beacons_of(port);
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_EQ(beacons[0].mode, AgentMode::Leaving);
  EXPECT_EQ(beacons[0].nonce, test::kNonce);
}

}  // namespace
}  // namespace skein
