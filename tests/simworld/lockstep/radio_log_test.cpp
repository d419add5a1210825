// What the radio of a transit is reported to have carried: the same that its agents heard, by the same functions.
#include "simworld/lockstep/radio_log.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "planner/core/radio/radio.hpp"
#include "tests/simworld/lockstep/samples.hpp"
#include "tests/simworld/transits.hpp"

namespace skein {
namespace {

using test::map_sample;

/// Three UAVs on a line, 20 m apart.
Mission three(const RadioOptions& radio) {
  Mission mission = test::transit_of(
      {test::crosser(1, Vec3(6, 18, 6)), test::crosser(2, Vec3(26, 18, 6)), test::crosser(3, Vec3(46, 18, 6))},
      {Vec3(74, 18, 6), Vec3(74, 26, 6), Vec3(74, 34, 6)});
  mission.transit->radio = radio;
  return mission;
}

/// A step in which the agents of `senders` send; flight step k is round k + 1.
void add(RadioLog& log, const Mission& mission, std::uint32_t step, const std::vector<AgentId>& senders,
         std::array<std::uint64_t, 3> maps = {1, 2, 3}) {
  std::vector<ObstacleMapSample> samples;
  for (AgentId id = 1; id <= 3; ++id) samples.push_back(map_sample(id, step + 1));
  std::vector<OnAir> agents;
  for (AgentId id = 1; id <= 3; ++id) {
    const bool sends = std::ranges::find(senders, id) != senders.end();
    agents.push_back({id, mission.vehicles[id - 1].start.position_m, sends ? &samples[id - 1] : nullptr, maps[id - 1]});
  }
  log.add(step, step + 1, agents);
}

LinkCount link(const RadioLog& log, AgentId from, AgentId to) {
  const auto found = log.counts().links().find({from, to});
  return found == log.counts().links().end() ? LinkCount{} : found->second;
}

TEST(RadioLog, CountsWhatIsHeardInRange) {
  const Mission mission = three({.range_m = 25.0});
  RadioLog log(mission);
  add(log, mission, 1, {1, 2});
  add(log, mission, 2, {2});
  const std::size_t bytes = payload_bytes(1, 0);
  EXPECT_EQ(link(log, 1, 2).samples, 1U);
  EXPECT_EQ(link(log, 1, 2).bytes, bytes);
  EXPECT_EQ(link(log, 2, 1).samples, 2U);
  EXPECT_EQ(link(log, 2, 3).samples, 2U);
  EXPECT_EQ(link(log, 2, 3).bytes, 2 * bytes);
  EXPECT_EQ(link(log, 1, 3).samples, 0U) << "40 m apart";
  EXPECT_EQ(link(log, 1, 3).lost, 0U) << "nor is it lost";
  EXPECT_EQ(log.sent_samples(), 3U);
  EXPECT_EQ(log.sent_bytes(), 3 * bytes);
}

TEST(RadioLog, LosesWhatTheAgentsLose) {
  const RadioOptions radio{.loss = 0.4};
  const Mission mission = three(radio);
  RadioLog log(mission);
  constexpr std::uint32_t kSteps = 60;
  for (std::uint32_t step = 1; step <= kSteps; ++step) add(log, mission, step, {1, 2, 3});
  std::uint64_t lost_in_all = 0;
  for (AgentId from = 1; from <= 3; ++from) {
    for (AgentId to = 1; to <= 3; ++to) {
      if (from == to) continue;
      std::uint64_t lost = 0;
      for (std::uint32_t step = 1; step <= kSteps; ++step) {
        lost += is_lost(radio, mission.seed, from, to, step, step + 1) ? 1 : 0;
      }
      EXPECT_EQ(link(log, from, to).lost, lost);
      EXPECT_EQ(link(log, from, to).samples, kSteps - lost);
      lost_in_all += lost;
    }
  }
  EXPECT_GT(lost_in_all, 100U);
  EXPECT_LT(lost_in_all, 190U);
}

TEST(RadioLog, AgesAreThoseOfWhatTheReceiverUses) {
  const Mission prompt = three({});
  RadioLog log(prompt);
  for (std::uint32_t step = 1; step <= 4; ++step) add(log, prompt, step, {1});
  EXPECT_EQ(link(log, 1, 2).age_quantile(1.0), 1U);
  for (std::uint32_t step = 5; step <= 8; ++step) add(log, prompt, step, {});
  EXPECT_EQ(link(log, 1, 2).age_quantile(0.5), 1U) << "1 1 1 1 2 3 4 5";
  EXPECT_EQ(link(log, 1, 2).age_quantile(0.75), 3U);
  EXPECT_EQ(link(log, 1, 2).age_quantile(1.0), 5U);

  const Mission late = three({.latency_rounds = 2.0});
  RadioLog delayed(late);
  for (std::uint32_t step = 1; step <= 2; ++step) add(delayed, late, step, {1});
  EXPECT_EQ(link(delayed, 1, 2).age_quantile(1.0), 0U) << "nothing is used yet";
  add(delayed, late, 3, {1});
  EXPECT_EQ(link(delayed, 1, 2).age_quantile(1.0), 3U);
  add(delayed, late, 4, {1});
  EXPECT_EQ(link(delayed, 1, 2).age_quantile(1.0), 3U);
}

TEST(RadioLog, NamesSamplesThatAreOverTheBudget) {
  // a frame of one decision, of which each of three has a third: 1600 bits, less 192 of the header: 176 bytes
  const Mission mission = three({.bit_rate_bps = 4800.0, .send_period_s = 1.0});
  RadioLog log(mission);
  const auto send = [&](std::uint32_t step, std::uint32_t tiles) {
    const ObstacleMapSample sample = map_sample(1, step + 1, tiles);
    const std::vector<OnAir> agents{{1, mission.vehicles[0].start.position_m, &sample, 0}};
    log.add(step, step + 1, agents);
  };
  send(1, 2);
  EXPECT_EQ(log.over_budget(), 0U);
  EXPECT_EQ(log.slot_bits(), 1600.0);
  EXPECT_EQ(log.peak_bits(), 192.0 + 8.0 * static_cast<double>(payload_bytes(2, 0)));
  send(2, 3);
  EXPECT_EQ(log.over_budget(), 1U);
  send(3, 2);
  EXPECT_EQ(log.over_budget(), 1U);
  EXPECT_LE(log.peak_bits(), log.slot_bits());
}

TEST(RadioLog, NotesWhenGroupsPartAndMeet) {
  Mission mission = three({.range_m = 25.0});
  RadioLog log(mission);
  add(log, mission, 1, {});
  add(log, mission, 2, {});
  mission.vehicles[2].start.position_m.x() = 60.0;
  add(log, mission, 3, {});
  mission.vehicles[0].start.position_m.x() = 0.0;
  add(log, mission, 4, {});
  mission.vehicles[1].start.position_m.x() = 36.0;
  add(log, mission, 5, {});
  std::vector<std::pair<std::uint32_t, std::size_t>> changes;
  for (const PartitionChange& change : log.partitions()) changes.emplace_back(change.step, change.groups);
  EXPECT_EQ(changes, (std::vector<std::pair<std::uint32_t, std::size_t>>{{1, 1}, {3, 2}, {4, 3}, {5, 2}}));
}

TEST(RadioLog, KnowsSinceWhenTheMapsAreEqual) {
  const Mission mission = three({});
  RadioLog log(mission);
  EXPECT_FALSE(log.equal_since().has_value());
  add(log, mission, 1, {}, {7, 7, 8});
  EXPECT_FALSE(log.equal_since().has_value());
  add(log, mission, 2, {}, {7, 7, 7});
  add(log, mission, 3, {}, {9, 9, 9});
  EXPECT_EQ(log.equal_since(), 2U);
  add(log, mission, 4, {}, {9, 9, 7});
  EXPECT_FALSE(log.equal_since().has_value());
  add(log, mission, 5, {}, {9, 9, 9});
  EXPECT_EQ(log.equal_since(), 5U);
}

}  // namespace
}  // namespace skein
