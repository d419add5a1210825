#include "agent/controller/apf.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "agent/controller/evasion.hpp"
#include "planner/core/random/random_stream.hpp"
#include "tests/agent/controller/closed_loop.hpp"

namespace skein {
namespace {

const VehicleSpec kSpec = test::multirotor_spec(1);

Neighbour neighbour_at(const Vec3& place_m, const Vec3& velocity_mps) {
  return {2, place_m, velocity_mps, 0.5, 4.0};
}

TEST(Attraction, IsConstantFarAndLinearNear) {
  EXPECT_NEAR((attraction(Vec3(100, 0, 0), 10, 4) - Vec3(10, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((attraction(Vec3(0, 9, 0), 10, 4) - Vec3(0, 6, 0)).norm(), 0.0, 1e-12);  // sqrt(4 * 9)
  EXPECT_NEAR((attraction(Vec3(0, 0, 2), 10, 4) - Vec3(0, 0, 2)).norm(), 0.0, 1e-12);
  EXPECT_EQ(attraction(Vec3::Zero(), 10, 4), Vec3(Vec3::Zero()));
}

TEST(Repulsion, IsTheSixthEquation) {
  EXPECT_EQ(repulsion(0.0), 1.0);
  EXPECT_NEAR(repulsion(1.0), 0.55, 1e-15);
  EXPECT_NEAR(repulsion(2.0), 0.1, 1e-15);
  EXPECT_NEAR(repulsion(2.0 - 1e-9), repulsion(2.0), 1e-8);
  EXPECT_EQ(repulsion(3.0), 0.0);
}

TEST(Apf, LeavesAWishAloneWithNothingWithinReach) {
  const Vec3 wish_mps(9.87654321, 0.1, -0.3);
  const Neighbour ahead = neighbour_at(Vec3(500, 0, 0), Vec3::Zero());
  const Neighbour leaving = neighbour_at(Vec3(0, 30, 0), Vec3(0, 5, 0));
  for (const Neighbour& other : {ahead, leaving}) {
    const Scene scene{Vec3::Zero(), Vec3(5, 0, 0), {&other, 1}, {}, {}};
    EXPECT_EQ(apf_velocity({}, kSpec, scene, wish_mps), wish_mps);
  }
}

TEST(Apf, FaceToFaceBothGiveWayToTheRight) {
  const Neighbour other = neighbour_at(Vec3(30, 0, 0), Vec3(-8, 0, 0));
  const Neighbour own = neighbour_at(Vec3::Zero(), Vec3(8, 0, 0));
  const Vec3 mine = apf_velocity({}, kSpec, {own.position_m, own.velocity_mps, {&other, 1}, {}, {}}, Vec3(10, 0, 0));
  const Vec3 theirs =
      apf_velocity({}, kSpec, {other.position_m, other.velocity_mps, {&own, 1}, {}, {}}, Vec3(-10, 0, 0));
  EXPECT_LT(mine.y(), -1.0);
  EXPECT_GT(theirs.y(), 1.0);
  EXPECT_EQ(mine.z(), 0.0);
}

TEST(Apf, AboveEachOtherBothGiveWayEastAndWest) {
  const Neighbour other = neighbour_at(Vec3(0, 0, 30), Vec3(0, 0, -8));
  const Vec3 v = apf_velocity({}, kSpec, {Vec3::Zero(), Vec3(0, 0, 8), {&other, 1}, {}, {}}, Vec3(0, 0, 10));
  EXPECT_GT(v.x(), 1.0);
}

TEST(Apf, WhoRestsAmongRestingOthersHoldsStill) {
  const Neighbour other = neighbour_at(Vec3(1.3, 0, 0), Vec3::Zero());
  const Vec3 v = apf_velocity({}, kSpec, {Vec3::Zero(), Vec3::Zero(), {&other, 1}, {}, {}}, Vec3::Zero());
  EXPECT_EQ(v, Vec3(Vec3::Zero()));
}

TEST(Apf, IsContinuousWhereItReachesOut) {
  for (std::uint64_t n = 0; n < 2000; ++n) {
    RandomStream random(8, 0, Purpose::Test, n);
    const auto any = [&](double most) {
      return Vec3(random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most));
    };
    Neighbour other = neighbour_at(any(20), any(6));
    const Vec3 own_mps = any(6);
    const Scene scene{Vec3::Zero(), own_mps, {&other, 1}, {}, {}};
    const Vec3 before = apf_velocity({}, kSpec, scene, Vec3(7, 0, 0.1));
    other.position_m += 1e-7 * any(1);
    EXPECT_LE((apf_velocity({}, kSpec, scene, Vec3(7, 0, 0.1)) - before).norm(), 1e-3) << n;
  }
}

TEST(Evasion, TheSpeedIsOneFromWhichItCanTurnBack) {
  ControllerOptions options;
  EXPECT_EQ(wary_speed_mps(options, kSpec), 10.0);
  options.sensor_range_m = 24.0;
  EXPECT_EQ(wary_speed_mps(options, kSpec), 10.0);
  options.obstacle_speed_mps = 5.0;
  EXPECT_NEAR(wary_speed_mps(options, kSpec), std::sqrt(8.0 * 15.75) - 5.0, 1e-12);
  options.sensor_range_m = 5.0;
  EXPECT_NEAR(wary_speed_mps(options, kSpec), 4.0, 1e-12);
}

TEST(Evasion, RunsFromWhatComesAndSideStepsIt) {
  ControllerOptions options;
  options.sensor_range_m = 24.0;
  options.obstacle_speed_mps = 5.0;
  test::Loop loop;
  loop.options = options;
  loop.arrival_m = -1.0;  // it never ends
  test::Flyer flyer;
  flyer.spec = kSpec;
  flyer.state.position_m = flyer.goal_m = Vec3(50, 50, 0);
  loop.flyers.push_back(flyer);
  test::Obstacle obstacle;
  obstacle.track.id = 1;
  obstacle.track.radius_m = 2.0;
  obstacle.track.position_m = Vec3(5, 50, 0);
  obstacle.track.velocity_mps = Vec3(4.9, 0, 0);
  loop.obstacles.push_back(obstacle);
  const test::Tally tally = loop.run(19.0);  // it passes the goal, and is seen no more
  EXPECT_EQ(tally.collisions + tally.rammed_at_rest, 0);
  EXPECT_GT(tally.least_m, 1.0);
  EXPECT_LT((loop.flyers[0].state.position_m - flyer.goal_m).norm(), 0.1);
  EXPECT_EQ(loop.flyers[0].state.position_m.z(), 0.0);
}

}  // namespace
}  // namespace skein
