#include "idl/bus/memory_bus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/idl/convert/examples.hpp"

namespace skein::bus {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::uint64_t kWorldNonce = 100;

wire::Tick tick(std::uint32_t round) {
  Tick t = examples::tick();
  t.round = round;
  return to_wire(t, examples::kStamp);
}

wire::Representative representative(AgentId agent, std::uint32_t round = 1) {
  Representative r = examples::representative();
  r.agent = agent;
  r.round = round;
  return to_wire(r, examples::kStamp);
}

wire::Sense sense(AgentId agent) {
  Sense s = examples::sense();
  s.agent = agent;
  return to_wire(s, examples::kStamp);
}

template <typename Port>
auto taken(Port& port) {
  using Inbound = std::conditional_t<std::is_base_of_v<AgentPort, Port>, AgentInbound, WorldInbound>;
  std::vector<Inbound> into;
  port.take(into);
  return into;
}

/// Rounds of the ticks and representatives that the port has, in order.
template <typename Port>
std::vector<std::uint32_t> rounds(Port& port) {
  std::vector<std::uint32_t> out;
  for (const auto& sample : taken(port)) {
    std::visit(
        [&](const auto& held) {
          if constexpr (requires { held.round(); }) out.push_back(held.round());
        },
        sample);
  }
  return out;
}

TEST(MemoryBus, MatchedNamesTheOthersByAscendingNonce) {
  MemoryBus bus(kWorldNonce);
  EXPECT_THAT(bus.world().matched(), IsEmpty());
  const auto one = bus.attach(1, 300);
  auto two = bus.attach(2, 50);
  EXPECT_THAT(bus.world().matched(), ElementsAre(50, 300));
  EXPECT_THAT(one->matched(), ElementsAre(50, 100));
  EXPECT_THAT(two->matched(), ElementsAre(100, 300));
  two.reset();
  EXPECT_THAT(bus.world().matched(), ElementsAre(300));
  EXPECT_THAT(one->matched(), ElementsAre(100));
}

TEST(MemoryBus, ObstacleMapsGoToAllOthers) {
  MemoryBus bus(kWorldNonce);
  const auto one = bus.attach(1, 1);
  const auto two = bus.attach(2, 2);
  const wire::ObstacleMap map = to_wire(examples::obstacle_map(), examples::kStamp);
  one->publish(map);
  EXPECT_THAT(rounds(*one), IsEmpty());
  EXPECT_THAT(rounds(bus.world()), ElementsAre(6));
  const auto got = taken(*two);
  ASSERT_EQ(got.size(), 1u);
  EXPECT_EQ(from_wire(std::get<wire::ObstacleMap>(got[0]), {}).value(), examples::obstacle_map());
  bus.world().publish(map);
  EXPECT_THAT(rounds(*one), ElementsAre(6));
  EXPECT_THAT(rounds(*two), ElementsAre(6));
}

TEST(MemoryBus, TheMissionReachesALateJoinerOnce) {
  MemoryBus bus(kWorldNonce);
  const auto early = bus.attach(1, 1);
  bus.world().publish(to_wire(examples::mission(), examples::kStamp));
  bus.world().publish(tick(1));
  const auto late = bus.attach(2, 2);
  EXPECT_EQ(taken(*early).size(), 2u);
  const auto got = taken(*late);
  ASSERT_EQ(got.size(), 1u);
  EXPECT_EQ(from_wire(std::get<wire::Mission>(got[0]), {}).value(), examples::mission());
  EXPECT_THAT(taken(*late), IsEmpty());
}

TEST(MemoryBus, SenseReachesItsAgentAlone) {
  MemoryBus bus(kWorldNonce);
  const auto one = bus.attach(1, 1);
  const auto two = bus.attach(2, 2);
  const auto two_again = bus.attach(2, 3);
  bus.world().publish(sense(2));
  EXPECT_THAT(taken(*one), IsEmpty());
  EXPECT_EQ(taken(*two).size(), 1u);
  EXPECT_EQ(taken(*two_again).size(), 1u);
}

TEST(MemoryBus, RepresentativesReachPeersAndWorldBeaconsTheWorldNobodyHimself) {
  MemoryBus bus(kWorldNonce);
  const auto one = bus.attach(1, 1);
  const auto two = bus.attach(2, 2);
  one->publish(representative(1));
  one->publish(to_wire(examples::beacon(), examples::kStamp));
  EXPECT_THAT(taken(*one), IsEmpty());
  EXPECT_EQ(taken(*two).size(), 1u);
  EXPECT_EQ(taken(bus.world()).size(), 2u);
  bus.world().publish(representative(1));
  EXPECT_EQ(taken(*one).size(), 1u);
  EXPECT_EQ(taken(*two).size(), 1u);
  EXPECT_THAT(taken(bus.world()), IsEmpty());
}

TEST(MemoryBus, KeepsOrderAndForgetsWhatADetachedAgentHadNotTaken) {
  MemoryBus bus(kWorldNonce);
  auto one = bus.attach(1, 1);
  for (std::uint32_t round = 1; round <= 300; ++round) bus.world().publish(tick(round));
  const auto got = rounds(*one);
  ASSERT_EQ(got.size(), 300u);
  EXPECT_TRUE(std::ranges::is_sorted(got));
  bus.world().publish(tick(301));
  one.reset();
  one = bus.attach(1, 2);
  EXPECT_THAT(taken(*one), IsEmpty());
}

TEST(MemoryBus, AFullInboxLosesItsOldestSampleAndCountsIt) {
  MemoryBus bus(kWorldNonce);
  auto one = bus.attach(1, 1);
  for (std::uint32_t round = 0; round < kInboxBound + 3; ++round) bus.world().publish(tick(round));
  const auto got = rounds(*one);
  EXPECT_EQ(got.size(), kInboxBound);
  EXPECT_EQ(got.front(), 3u);
  EXPECT_EQ(bus.overflowed(), 3u);
  one.reset();
  EXPECT_EQ(bus.overflowed(), 3u);
}

TEST(MemoryBus, RefusesIdsOutOfRangeAndANonceInUse) {
  MemoryBus bus(kWorldNonce);
  EXPECT_THROW((void)bus.attach(0, 1), std::invalid_argument);
  EXPECT_THROW((void)bus.attach(kMaxAgents + 1, 1), std::invalid_argument);
  EXPECT_THROW((void)bus.attach(1, kWorldNonce), std::invalid_argument);
  EXPECT_THAT(bus.world().matched(), IsEmpty());
}

TEST(Tamper, DropsDuplicatesAltersAndDelays) {
  MemoryBus bus(kWorldNonce);
  const auto one = bus.attach(1, 1);
  bus.set_tamper([](Transit transit) -> std::vector<Transit> {
    auto* passing = std::get_if<wire::Tick>(&transit.sample);
    if (passing == nullptr || passing->round() == 2) return {};
    if (passing->round() == 3) return {transit, transit};
    if (passing->round() == 4) passing->round(40);
    if (passing->round() == 1) transit.held_takes = 1;
    return {transit};
  });
  for (std::uint32_t round = 1; round <= 4; ++round) bus.world().publish(tick(round));
  EXPECT_THAT(rounds(*one), ElementsAre(3, 3, 40));
  EXPECT_THAT(rounds(*one), ElementsAre(1));
  EXPECT_THAT(rounds(*one), IsEmpty());
  bus.set_tamper({});
  bus.world().publish(tick(2));
  EXPECT_THAT(rounds(*one), ElementsAre(2));
}

TEST(Tamper, SeesOneTransitAReceiver) {
  MemoryBus bus(kWorldNonce);
  const auto one = bus.attach(1, 1);
  const auto two = bus.attach(2, 2);
  std::vector<std::pair<AgentId, AgentId>> seen;
  bus.set_tamper([&](Transit transit) -> std::vector<Transit> {
    seen.emplace_back(transit.from, transit.to);
    return {std::move(transit)};
  });
  one->publish(representative(1));
  bus.world().publish(tick(1));
  using Hop = std::pair<AgentId, AgentId>;
  EXPECT_THAT(seen, ElementsAre(Hop(1, 2), Hop(1, 0), Hop(0, 1), Hop(0, 2)));
}

TEST(Tamper, MayNotMakeWhatTheReceiverDoesNotRead) {
  MemoryBus bus(kWorldNonce);
  const auto one = bus.attach(1, 1);
  bus.set_tamper([](Transit transit) -> std::vector<Transit> {
    transit.sample = to_wire(examples::beacon(), examples::kStamp);
    return {transit};
  });
  EXPECT_THROW(bus.world().publish(tick(1)), std::invalid_argument);
}

}  // namespace
}  // namespace skein::bus
