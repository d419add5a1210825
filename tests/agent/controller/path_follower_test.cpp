// The path follower on paths that can be worked out by hand, flown by the constant-speed vehicle.
#include "agent/controller/path_follower.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/rendezvous/ph/hermite.hpp"
#include "tests/agent/controller/flight.hpp"

namespace skein {
namespace {

using test::fly;
using test::kSpec;

/// 2000 m east from the origin.
const rendezvous::ph::PlanarPath kEast =
    rendezvous::ph::Hermite({Vec2(0.0, 0.0), 0.0}, {Vec2(2000.0, 0.0), 0.0}).path({2000.0, 2000.0});

TEST(PathFollower, OnAStraightPathItFliesStraight) {
  PathFollower follower(kSpec, test::kStep_s);
  for (int step = 0; step < 10; ++step) {
    const PathFollower::Command command = follower.command(kEast, {Vec3(25.0 * step, 0.0, 0.0), 0.0, 0.0});
    EXPECT_NEAR(command.velocity_mps.x(), 50.0, 1e-9);
    EXPECT_NEAR(command.velocity_mps.y(), 0.0, 1e-9);
    EXPECT_FALSE(command.path_flown);
  }
}

TEST(PathFollower, TurnsTowardsThePathFromBothSides) {
  PathFollower left(kSpec, test::kStep_s);
  EXPECT_LT(left.command(kEast, {Vec3(0.0, 1.0, 0.0), 0.0, 0.0}).velocity_mps.y(), 0.0);
  PathFollower right(kSpec, test::kStep_s);
  EXPECT_GT(right.command(kEast, {Vec3(0.0, -1.0, 0.0), 0.0, 0.0}).velocity_mps.y(), 0.0);
  PathFollower askew(kSpec, test::kStep_s);
  EXPECT_LT(askew.command(kEast, {Vec3(0.0, 0.0, 0.0), 0.1, 0.0}).velocity_mps.y(), 50.0 * std::sin(0.1));
}

TEST(PathFollower, FirstCommandIsThatOfTheHeader) {
  // p = 0.5, D = 25 m, e_y = 1 m to the left, e_chi = 0.01: the turn is -0.25 / 25 - 0.875 * 0.01
  PathFollower follower(kSpec, test::kStep_s);
  const Vec3 velocity_mps = follower.command(kEast, {Vec3(0.0, 1.0, 0.0), 0.01, 0.0}).velocity_mps;
  EXPECT_NEAR(std::atan2(velocity_mps.y(), velocity_mps.x()), 0.01 - 0.01 - 0.00875, 1e-9);
}

TEST(PathFollower, CommandsNeverTurnFasterThanTheVehicleCan) {
  PathFollower follower(kSpec, test::kStep_s);
  const double most_rad = kSpec.max_curvature_per_m * 25.0;
  const Vec3 velocity_mps = follower.command(kEast, {Vec3(0.0, 500.0, 0.0), 0.0, 0.0}).velocity_mps;
  EXPECT_NEAR(std::atan2(velocity_mps.y(), velocity_mps.x()), -most_rad, 1e-12);
  EXPECT_NEAR(velocity_mps.norm(), 50.0, 1e-9);
}

TEST(PathFollower, ReportsTheEndOfThePathAndGoesStraightOn) {
  const test::Flown flown = fly(kEast, {Vec3::Zero(), 0.0, 0.0});
  EXPECT_EQ(flown.steps, 81);  // 80 steps of 25 m, and the one that finds the path behind
  EXPECT_LT(flown.end_error_m, 1e-6);
  PathFollower follower(kSpec, test::kStep_s);
  PathFollower::Command command;
  for (int step = 0; step <= 90; ++step) command = follower.command(kEast, {Vec3(25.0 * step, 0.0, 0.0), 0.0, 0.0});
  EXPECT_TRUE(command.path_flown);
  EXPECT_NEAR(command.velocity_mps.y(), 0.0, 1e-9);
}

TEST(PathFollower, NoticesThatItIsBehindOrAhead) {
  PathFollower follower(kSpec, test::kStep_s);
  (void)follower.command(kEast, {Vec3(1990.0, 0.0, 0.0), 0.0, 0.0});
  EXPECT_TRUE(follower.command(kEast, {Vec3(2015.0, 0.0, 0.0), 0.0, 0.0}).path_flown);
}

TEST(PathFollower, HashTellsPlacesApart) {
  const auto hash_of = [](const PathFollower& follower) {
    StateHash hash;
    follower.add_to(hash);
    return hash.value();
  };
  PathFollower a(kSpec, test::kStep_s);
  PathFollower b(kSpec, test::kStep_s);
  (void)a.command(kEast, {Vec3::Zero(), 0.0, 0.0});
  (void)b.command(kEast, {Vec3(0.5, 0.0, 0.0), 0.0, 0.0});
  EXPECT_NE(hash_of(a), hash_of(b));
}

}  // namespace
}  // namespace skein
