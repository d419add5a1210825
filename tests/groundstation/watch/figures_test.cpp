#include "groundstation/watch/figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/groundstation/watch/samples.hpp"

namespace skein::watch {
namespace {

using ::testing::HasSubstr;

SwarmView one_step() {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  watch.take(at(tick_at(4, Phase::Flying, 3)), 0.0);
  watch.take(at(beacon_of(2, 4, AgentMode::Flying, 3, {75.0, 500.0, 0.0})), 0.0);
  return watch.view(0.5, {});
}

TEST(Figures, StatusAsJsonHasEveryAgentAndNullWhereNothingIsKnown) {
  const auto json = status_json(one_step(), "geese");
  EXPECT_EQ(json.at("swarm"), "geese");
  EXPECT_EQ(json.at("scenario"), "east");
  EXPECT_EQ(json.at("phase"), "flying");
  EXPECT_EQ(json.at("step"), 3);
  EXPECT_TRUE(json.at("outcome").is_null());
  ASSERT_EQ(json.at("agents").size(), 2U);
  EXPECT_EQ(json.at("agents")[0].at("heard"), false);
  const auto& second = json.at("agents")[1];
  EXPECT_EQ(second.at("mode"), "flying");
  EXPECT_EQ(second.at("position_m")[0], 75.0);
  EXPECT_TRUE(second.at("separation_m").is_null());
  EXPECT_EQ(second.at("to_go_by"), "straight");
  EXPECT_EQ(json.at("topics").size(), bus::kTopics.size());
}

TEST(Figures, BeforeATickTheRunIsNull) {
  const auto json = status_json(SwarmView{}, "geese");
  EXPECT_TRUE(json.at("phase").is_null());
  EXPECT_TRUE(json.at("scenario").is_null());
}

TEST(Figures, StatusAsTextIsATable) {
  const std::string text = status_text(one_step(), "geese", 5);
  EXPECT_THAT(text, HasSubstr("swarm geese, east (seed 3): flying, step 3, 1.5 s, 2 live"));
  EXPECT_THAT(text, HasSubstr("   1  not heard yet\n"));
  EXPECT_THAT(text, HasSubstr("   2  flying"));
  EXPECT_THAT(text, HasSubstr("~9925.0"));
  EXPECT_THAT(text, HasSubstr("1.5 s  world flying: first_heard"));
}

TEST(Figures, TopicsSayWhatIsNotRead) {
  const auto json = topics_json(one_step(), "geese");
  const auto& sense = json.at("topics")[static_cast<std::size_t>(bus::TopicId::Sense)];
  EXPECT_EQ(sense.at("name"), "skein/sense");
  EXPECT_TRUE(sense.at("samples_per_s").is_null());
  EXPECT_EQ(sense.at("writers"), 0);
  EXPECT_THAT(topics_text(one_step()), HasSubstr("skein/beacon"));
}

}  // namespace
}  // namespace skein::watch
