// What a transit's behaviour puts on air, and what it hears.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/agent/behaviours/crossing.hpp"

namespace skein::test {
namespace {

const Vec3 kNear = kWest + Vec3(20.9, 0, 0);  ///< within 2.1 ways of a decision
const Vec3 kFar = kWest + Vec3(21.1, 0, 0);

/// Whether the map of a new UAV shows, in its second step, what agent 2 told in the first.
bool hears(const Mission& mission, const std::vector<HeardPeer>& heard) {
  Crossing deaf(mission);
  Crossing crossing(mission);
  deaf.step();
  crossing.step();
  const ObstacleMapSample sample = told(crossing.round());
  deaf.step(heard, sight_of(), {});
  crossing.step(heard, sight_of(), {sample});
  return crossing.last.map_hash != deaf.last.map_hash;
}

Mission within(double range_m, double loss = 0.0) {
  Mission mission = crossing();
  mission.transit->radio.range_m = range_m;
  mission.transit->radio.loss = loss;
  return mission;
}

TEST(TransitHearing, ReachesAsFarAsTheRadio) {
  EXPECT_TRUE(hears(within(30.0), {peer_at(kWest + Vec3(30, 0, 0))}));
  EXPECT_FALSE(hears(within(30.0), {peer_at(kWest + Vec3(30.1, 0, 0))}));
  EXPECT_FALSE(hears(within(30.0), {})) << "who is not sensed is not heard";
}

TEST(TransitHearing, MissesWhatIsLost) {
  EXPECT_FALSE(hears(within(1e6, 1.0), {peer_at(kNear)}));
  int heard = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Mission mission = within(1e6, 0.5);
    mission.seed = seed;
    const bool lost = is_lost(mission.transit->radio, seed, 2, 1, 1, 2);
    EXPECT_EQ(hears(mission, {peer_at(kNear)}), !lost) << seed;
    heard += lost ? 0 : 1;
  }
  EXPECT_GT(heard, 8);
  EXPECT_LT(heard, 32);
}

TEST(TransitHearing, IsAsLateAsTheRadio) {
  Mission mission = crossing();
  mission.transit->radio.latency_rounds = 2.0;
  Crossing crossing(mission);
  crossing.step();
  const std::uint64_t own = crossing.last.map_hash;
  crossing.step({peer_at(kNear)}, sight_of(), {told(crossing.round())});
  EXPECT_EQ(crossing.last.map_hash, own);
  crossing.step({peer_at(kNear)});
  EXPECT_EQ(crossing.last.map_hash, own);
  crossing.step({peer_at(kNear)});
  EXPECT_NE(crossing.last.map_hash, own);
}

TEST(TransitHearing, WithoutSharingNoMapIsTakenOver) {
  Mission mission = crossing();
  mission.transit->planner.share_maps = 0.0;
  EXPECT_FALSE(hears(mission, {peer_at(kNear)}));
}

/// Whether the UAV flies on in its second decision, when UAV 2 at (14, 26) said where it goes in `decision`.
bool flies_on(const Vec3& to_m, std::uint32_t decision) {
  Mission mission = crossing();
  mission.transit->planner.share_maps = 0.0;
  Crossing crossing(mission);
  const Vec3 from_m(14, 26, 6);
  crossing.step({peer_at(from_m)});
  ObstacleMapSample sample = told(crossing.round());
  sample.tiles.clear();
  sample.intent = {decision, from_m, to_m, 0, 1.0, NavStatus::Flying, 0, 2, {}};
  crossing.step({peer_at(from_m)}, sight_of(), {sample});
  return crossing.last.commanded_velocity_mps.norm() > 0.0;
}

TEST(TransitHearing, GivesWayToAnIntentOfHigherRight) {
  EXPECT_FALSE(flies_on(Vec3(16, 18, 6), 2));
  EXPECT_TRUE(flies_on(Vec3(14, 34, 6), 2)) << "away from it";
}

TEST(TransitHearing, AnIntentStandsForItsDecisionAlone) {
  // of whom it did not hear for this decision it keeps clear as far as that can fly
  EXPECT_FALSE(flies_on(Vec3(14, 34, 6), 1));
  EXPECT_FALSE(flies_on(Vec3(14, 34, 6), 3));
}

Mission unshared() {
  Mission mission = crossing();
  mission.transit->planner.share_maps = 0.0;
  return mission;
}

TEST(TransitSending, TellsIntentsOnlyWhereItIsCrowded) {
  Crossing crossing(unshared());
  EXPECT_FALSE(crossing.step().obstacle_map.has_value()) << "nobody is there";
  crossing.position_m = kWest;
  EXPECT_FALSE(crossing.step({peer_at(kFar)}).obstacle_map.has_value());
  crossing.position_m = kWest;
  EXPECT_FALSE(crossing.step({peer_at(kNear, true)}).obstacle_map.has_value()) << "who landed is no obstacle";
  crossing.position_m = kWest;
  const RoundOutput& out = crossing.step({peer_at(kNear)});
  ASSERT_TRUE(out.obstacle_map.has_value());
  EXPECT_EQ(out.obstacle_map->intent.decision, crossing.steps + 1) << "it stands for the next decision";
  EXPECT_EQ(out.obstacle_map->intent.status, NavStatus::Flying);
}

TEST(TransitSending, WhoHasArrivedSaysNoMore) {
  Mission mission = unshared();
  mission.transit->goals_m[0] = kWest + Vec3(1, 0, 0);
  Crossing crossing(mission);
  EXPECT_FALSE(crossing.step({peer_at(kNear)}).obstacle_map.has_value());
  EXPECT_EQ(crossing.last.mode, AgentMode::Arrived);
}

TEST(TransitSending, WithoutSharingNoMapGoesOnAir) {
  Crossing crossing(unshared());
  for (int step = 0; step < 5; ++step) {
    const RoundOutput& out = crossing.step({peer_at(crossing.position_m + Vec3(0, 12, 0))}, sight_of({{19, step, 0}}));
    ASSERT_TRUE(out.obstacle_map.has_value());
    EXPECT_TRUE(out.obstacle_map->tiles.empty());
    EXPECT_TRUE(out.obstacle_map->seen.empty());
  }
}

TEST(TransitSending, TellsWhoeverIsInReachWhatItSaw) {
  Crossing crossing(within(30.0));
  EXPECT_FALSE(crossing.step().obstacle_map.has_value()) << "nobody is there";
  crossing.position_m = kWest;
  EXPECT_FALSE(crossing.step({peer_at(kWest + Vec3(30.1, 0, 0))}).obstacle_map.has_value()) << "seen, not reached";
  crossing.position_m = kWest;
  const RoundOutput& out = crossing.step({peer_at(kWest + Vec3(29, 0, 0))});
  ASSERT_TRUE(out.obstacle_map.has_value());
  EXPECT_EQ(out.obstacle_map->tiles.size(), 6U) << "3 x 2 tiles of 8 x 8 cells";
  for (const MapTile& tile : out.obstacle_map->tiles) EXPECT_EQ(tile.origin, 1U);
}

TEST(TransitSending, IsSilentWhereNothingFits) {
  Mission mission = crossing();
  mission.transit->radio.bit_rate_bps = 1.0;
  Crossing crossing(mission);
  for (int step = 0; step < 5; ++step) EXPECT_FALSE(crossing.step({peer_at(kNear)}).obstacle_map.has_value());
}

TEST(TransitSending, KeepsItsShareOfTheChannelInEveryFrame) {
  Mission mission = crossing(0.5);
  RadioOptions& radio = mission.transit->radio;
  radio.bit_rate_bps = 2500.0;
  radio.send_period_s = 2.0;  // two decisions: 2500 bits for each of the two, 516 of them for the map
  Crossing crossing(mission);
  double frame_bits = 0.0;
  double most_bits = 0.0;
  std::size_t tiles = 0;
  std::uint32_t samples = 0;
  for (std::uint32_t step = 1; step <= 80; ++step) {
    if ((step - 1) % 4 == 0) frame_bits = 0.0;
    std::vector<Cell> occupied;  // another column in each decision: there is always something to tell
    occupied.reserve(8);
    for (std::int32_t j = 0; j < 8; ++j) occupied.push_back({static_cast<std::int32_t>(step / 2 % 20), j, 0});
    crossing.position_m = kWest;
    const RoundOutput& out = crossing.step({peer_at(kWest + Vec3(0, 12, 0))}, sight_of(occupied));
    if (!out.obstacle_map) continue;
    ++samples;
    tiles += out.obstacle_map->tiles.size();
    frame_bits += radio.header_bits + 8.0 * static_cast<double>(payload_bytes(out.obstacle_map->tiles.size(),
                                                                              out.obstacle_map->seen.size()));
    EXPECT_LE(frame_bits, 2500.0) << step;
    most_bits = std::max(most_bits, frame_bits);
  }
  EXPECT_EQ(samples, 40U) << "an intent in each decision";
  EXPECT_GT(tiles, 15U);
  EXPECT_GT(most_bits, 2200.0);
}

/// Agent 1 or 2, at rest on the west side, which hears the other one's samples.
class AtRest {
 public:
  AtRest(const Mission& mission, AgentId self, bool rejoined)
      : mission_(mission), behaviour_(mission, self, rejoined), self_(self) {}

  RoundOutput step(std::uint32_t step, std::uint32_t life_of_1, const std::vector<ObstacleMapSample>& maps,
                   const CellWindow& sight) {
    Tick tick;
    tick.step = step;
    tick.round = step + 1;
    tick.phase = Phase::Flying;
    tick.roster = {{.agent = 1, .incarnation = life_of_1}, {.agent = 2, .incarnation = 1}};
    Sense sense;
    sense.pose.position_m = vehicle_of(mission_, self_).start.position_m;
    sense.velocity_mps = Vec3(0.5, 0.0, 0.0);
    sense.heard = {{3 - self_, vehicle_of(mission_, 3 - self_).start.position_m, Vec3::Zero(), false}};
    sense.sight = sight;
    RoundOutput out = behaviour_.on_round({tick, &sense, {}, maps});
    if (out.obstacle_map) {  // signed as the runtime does
      out.obstacle_map->agent = self_;
      out.obstacle_map->incarnation = self_ == 1 ? life_of_1 : 1;
      out.obstacle_map->round = tick.round;
    }
    return out;
  }

 private:
  Mission mission_;
  TransitBehaviour behaviour_;
  AgentId self_;
};

TEST(TransitReturn, WhoCameBackFliesNothingAndHasTheSwarmsMapAgain) {
  const Mission mission = crossing();
  AtRest before(mission, 1, false);
  AtRest other(mission, 2, false);
  std::vector<ObstacleMapSample> said;  // by agent 1, whose former life alone sees a wall
  for (std::uint32_t step = 1; step <= 3; ++step) {
    const RoundOutput out = before.step(step, 1, {}, sight_of(wall_at(12)));
    (void)other.step(step, 1, said, free_block({0, 0, 0}, 4, 4));
    said.clear();
    if (out.obstacle_map) said.push_back(*out.obstacle_map);
  }
  AtRest back(mission, 1, true);
  std::vector<ObstacleMapSample> by_back;
  std::vector<ObstacleMapSample> by_other;
  std::uint64_t of_back = 0;
  std::uint64_t of_other = 1;
  for (std::uint32_t step = 4; step <= 40; ++step) {
    const RoundOutput first = back.step(step, 2, by_other, free_block({0, 0, 0}, 4, 4));
    const RoundOutput second = other.step(step, 2, by_back, free_block({0, 0, 0}, 4, 4));
    EXPECT_EQ(first.mode, AgentMode::Rejoined);
    EXPECT_EQ(first.commanded_velocity_mps, Vec3(0.5, 0.0, 0.0)) << "it holds its course";
    EXPECT_FALSE(step == 4 && first.obstacle_map) << "its former life may have filled this frame";
    by_back.clear();
    by_other.clear();
    if (first.obstacle_map) {
      EXPECT_EQ(first.obstacle_map->intent.decision, 0U) << "it announces no motion";
      by_back.push_back(*first.obstacle_map);
    }
    if (second.obstacle_map) by_other.push_back(*second.obstacle_map);
    of_back = first.map_hash;
    of_other = second.map_hash;
  }
  EXPECT_EQ(of_back, of_other);
  AtRest ignorant(mission, 2, false);
  EXPECT_NE(ignorant.step(1, 1, {}, free_block({0, 0, 0}, 4, 4)).map_hash, of_other) << "the wall is in it";
}

}  // namespace
}  // namespace skein::test
