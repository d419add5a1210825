#include "planner/core/radio/radio.hpp"

#include <gtest/gtest.h>

#include <array>

#include "planner/core/radio/link_counts.hpp"

namespace skein {
namespace {

struct Said {
  AgentId agent = 0;
  std::uint32_t round = 0;
};

TEST(Radio, IsHeardWithinItsRangeInSpace) {
  RadioOptions options;
  options.range_m = 90.0;
  EXPECT_TRUE(in_range(options, Vec3(0.0, 0.0, 10.0), Vec3(54.0, 72.0, 10.0)));
  EXPECT_FALSE(in_range(options, Vec3(0.0, 0.0, 10.0), Vec3(54.0, 72.0, 11.0)));
  EXPECT_TRUE(in_range(RadioOptions{}, Vec3::Zero(), Vec3(1e5, 1e5, 0.0)));
}

TEST(Radio, LosesTheShareThatIsSetForEachReceiverAlone) {
  RadioOptions options;
  options.loss = 0.1;
  int lost = 0;
  int differ = 0;
  for (std::uint32_t round = 1; round <= 20000; ++round) {
    const bool first = is_lost(options, 7, 3, 1, round / 2, round);
    EXPECT_EQ(first, is_lost(options, 7, 3, 1, round / 2, round));
    lost += first ? 1 : 0;
    differ += first != is_lost(options, 7, 3, 2, round / 2, round) ? 1 : 0;
  }
  EXPECT_NEAR(lost, 2000, 200);  // 4.7 standard deviations
  EXPECT_NEAR(differ, 3600, 260);
  options.loss = 0.0;
  EXPECT_FALSE(is_lost(options, 7, 3, 1, 1, 1));
  options.loss = 1.0;
  EXPECT_TRUE(is_lost(options, 7, 3, 1, 1, 1));
}

TEST(Radio, EverythingThatNamesALossChangesIt) {
  RadioOptions options;
  options.loss = 0.5;
  std::array<int, 5> differ{};
  for (std::uint32_t n = 1; n <= 2000; ++n) {
    const bool base = is_lost(options, 1, 2, 3, n, n);
    differ[0] += base != is_lost(options, 2, 2, 3, n, n) ? 1 : 0;
    differ[1] += base != is_lost(options, 1, 3, 3, n, n) ? 1 : 0;
    differ[2] += base != is_lost(options, 1, 2, 4, n, n) ? 1 : 0;
    differ[3] += base != is_lost(options, 1, 2, 3, n + 1, n) ? 1 : 0;
    differ[4] += base != is_lost(options, 1, 2, 3, n, n + 1) ? 1 : 0;
  }
  for (const int count : differ) EXPECT_NEAR(count, 1000, 120);
}

TEST(RadioReceiver, HearsEachSampleOnceWhenItIsDueInOrderOfRoundAndAgent) {
  RadioReceiver<Said> radio;
  EXPECT_EQ(radio.last_of(2), nullptr);
  radio.receive({5, 1}, 2);
  radio.receive({2, 1}, 2);
  radio.receive({2, 2}, 2);
  EXPECT_TRUE(radio.hear(3).empty());
  const std::vector<Said> first = radio.hear(4);
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].agent, 2u);
  EXPECT_EQ(first[1].agent, 5u);
  EXPECT_TRUE(radio.hear(4).empty());
  EXPECT_EQ(radio.last_of(2)->round, 1u);
  EXPECT_EQ(radio.hear(9).size(), 1u);
  EXPECT_EQ(radio.last_of(2)->round, 2u);
  radio.receive({5, 20}, 0);
  radio.forget(5);
  EXPECT_TRUE(radio.hear(30).empty());
  EXPECT_EQ(radio.last_of(5), nullptr);
}

TEST(LinkCounts, CountsSamplesBytesLossesAndAges) {
  LinkCounts counts;
  counts.heard(1, 2, 100);
  counts.heard(1, 2, 50);
  counts.lost(1, 2);
  counts.lost(2, 1);
  for (int i = 0; i < 90; ++i) counts.age(1, 2, 1);
  for (int i = 0; i < 10; ++i) counts.age(1, 2, 4);
  const LinkCount& link = counts.links().at({1, 2});
  EXPECT_EQ(link.samples, 2u);
  EXPECT_EQ(link.bytes, 150u);
  EXPECT_EQ(link.lost, 1u);
  EXPECT_EQ(link.age_quantile(0.5), 1u);
  EXPECT_EQ(link.age_quantile(0.9), 1u);
  EXPECT_EQ(link.age_quantile(0.95), 4u);
  EXPECT_EQ(counts.links().at({2, 1}).age_quantile(0.5), 0u);
  EXPECT_EQ(counts.total().lost, 2u);
  EXPECT_EQ(counts.total().age_quantile(0.95), 4u);
}

TEST(LinkCounts, PartitionsAreWhatNoLinkJoins) {
  constexpr std::array<AgentId, 5> kIds{1, 2, 4, 7, 9};
  EXPECT_EQ(count_partitions(kIds, {}), 5u);
  const std::array<RadioLink, 3> links{{{1, 4}, {9, 2}, {4, 1}}};
  EXPECT_EQ(count_partitions(kIds, links), 3u);
  const std::array<RadioLink, 5> joined{{{1, 4}, {9, 2}, {4, 9}, {7, 2}, {7, 8}}};
  EXPECT_EQ(count_partitions(kIds, joined), 1u);
  EXPECT_EQ(count_partitions({}, {}), 0u);
}

}  // namespace
}  // namespace skein
