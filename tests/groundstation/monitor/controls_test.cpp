#include "groundstation/monitor/controls.hpp"

#include <gtest/gtest.h>

#include "tests/groundstation/monitor/views.hpp"

namespace skein::monitor {
namespace {

Choices press(const std::string& keys, const watch::SwarmView& view, Choices choices = {}) {
  for (const char key : keys) choices = after_key(choices, {key, Special::None}, view);
  return choices;
}

TEST(Controls, AgentsGoRound) {
  const auto view = row_of(3);
  EXPECT_EQ(selected_agent({}, view)->id, 1U);
  EXPECT_EQ(selected_agent(press("n", view), view)->id, 2U);
  EXPECT_EQ(selected_agent(press("nnn", view), view)->id, 1U);
  EXPECT_EQ(selected_agent(press("p", view), view)->id, 3U);
  EXPECT_EQ(selected_agent(press("n", watch::SwarmView{}), watch::SwarmView{}), nullptr);
}

TEST(Controls, ZoomHasLimitsAndZeroTakesItBack) {
  const auto view = row_of(2);
  EXPECT_GT(press("+", view).zoom, 1.0);
  EXPECT_LT(press("-", view).zoom, 1.0);
  EXPECT_LE(press(std::string(100, '+'), view).zoom, 1e4);
  const Choices back = press("++f0", view);
  EXPECT_EQ(back.zoom, 1.0);
  EXPECT_FALSE(back.follow);
}

TEST(Controls, FollowingLooksAtTheAgent) {
  const auto view = row_of(3);
  EXPECT_FALSE(centre_of({}, view));
  EXPECT_EQ(*centre_of(press("nf", view), view), Vec3(400.0, 1000.0, 100.0));
}

TEST(Controls, PanningEndsFollowingFromWhereItWas) {
  const auto view = row_of(3);
  const Choices panned = after_key(press("f", view), {0, Special::Up}, view);
  EXPECT_FALSE(panned.follow);
  EXPECT_GT(panned.centre_m->y(), 1000.0);
  EXPECT_EQ(panned.centre_m->x(), 200.0);
  const Choices right = after_key(press("3", view), {0, Special::Right}, view);
  EXPECT_GT(right.centre_m->y(), 1000.0);  // u of y-z
}

TEST(Controls, PlanesFollowEachOther) {
  const auto view = row_of(1);
  EXPECT_EQ(press("v", view).plane, Plane::XZ);
  EXPECT_EQ(press("vv", view).plane, Plane::YZ);
  EXPECT_EQ(press("vvv", view).plane, Plane::XY);
  EXPECT_EQ(press("2", view).plane, Plane::XZ);
}

TEST(Controls, SwitchesSwitchAndQLeaves) {
  const auto view = row_of(1);
  EXPECT_TRUE(press("t", view).table);
  EXPECT_FALSE(press("tt", view).table);
  EXPECT_FALSE(press("d", view).plans);
  EXPECT_FALSE(press("w", view).trails);
  EXPECT_FALSE(press("z", view).zones);
  EXPECT_FALSE(press("c", view).cells);
  EXPECT_FALSE(press("l", view).links);
  EXPECT_TRUE(press("?", view).help);
  EXPECT_FALSE(press("xyXY\x01", view).quit);
  EXPECT_TRUE(press("q", view).quit);
}

}  // namespace
}  // namespace skein::monitor
