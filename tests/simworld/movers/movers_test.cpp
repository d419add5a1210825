// How movers move: straight, round and round, at random in their box; and when those that wait are there.
#include "simworld/movers/movers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace skein {
namespace {

constexpr double kStep_s = 0.5;
constexpr std::array<Bystander, 0> kNobody{};

Mover at(const Vec3& place_m, MoverMotion motion) {
  Mover mover;
  mover.name = "moving_obstacles.1";
  mover.position_m = place_m;
  mover.radius_m = 1.0;
  mover.motion = std::move(motion);
  return mover;
}

Movers one(const Mover& mover, std::uint64_t seed = 1) {
  return {{mover}, {}, 0.0, seed, kStep_s};
}

/// Opens and flies steps 1 to `steps`.
const MoverRecord& after(Movers& movers, std::uint32_t steps, std::span<const Bystander> vehicles = kNobody) {
  for (std::uint32_t step = 1; step <= steps; ++step) {
    movers.open(step, vehicles);
    movers.advance(step);
  }
  return movers.all().front();
}

Bystander hovering(const Vec3& place_m) {
  Bystander vehicle;
  vehicle.spec.id = 3;
  vehicle.spec.type = VehicleType::Multirotor;
  vehicle.spec.speed_mps = 10.0;
  vehicle.spec.max_acceleration_mps2 = 4.0;
  vehicle.spec.radius_m = 0.5;
  vehicle.position_m = place_m;
  return vehicle;
}

Bystander flying(const Vec3& place_m, const Vec3& velocity_mps) {
  Bystander vehicle = hovering(place_m);
  vehicle.velocity_mps = velocity_mps;
  return vehicle;
}

TEST(Movers, FlyAlongALine) {
  Movers movers = one(at({1, 2, 3}, LineMotion{Vec3(4, 0, -2)}));
  const MoverRecord& mover = after(movers, 6);
  EXPECT_TRUE(mover.present);
  EXPECT_EQ(mover.appeared_step, 1U);
  EXPECT_TRUE(mover.position_m.isApprox(Vec3(13, 2, -3)));
  EXPECT_TRUE(mover.before_m.isApprox(Vec3(11, 2, -2)));
  EXPECT_EQ(mover.velocity_mps, Vec3(4, 0, -2));
}

TEST(Movers, GoRoundTheirWaypointsAtOneSpeed) {
  const LoopMotion square{{Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 10, 0), Vec3(0, 10, 0)}, 4.0};
  Movers movers = one(at({0, 0, 0}, square));
  EXPECT_TRUE(after(movers, 2).position_m.isApprox(Vec3(4, 0, 0)));
  for (std::uint32_t step = 3; step <= 6; ++step) movers.advance(step);
  EXPECT_TRUE(movers.all()[0].position_m.isApprox(Vec3(10, 2, 0))) << "round the corner";
  EXPECT_TRUE(movers.all()[0].velocity_mps.isApprox(Vec3(0, 4, 0)));
  for (std::uint32_t step = 7; step <= 20; ++step) movers.advance(step);
  EXPECT_LT(movers.all()[0].position_m.norm(), 1e-9) << "a round is 40 m, 20 steps";
}

TEST(Movers, WalkInTheirBoxAtTheirSpeedAndTurnNowAndThen) {
  const Box box{Vec3(0, 0, 0), Vec3(20, 20, 10)};
  int turns = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Movers movers = one(at({10, 10, 5}, WalkMotion{3.0, 2.0, box}), seed);
    movers.open(1, kNobody);
    Vec3 heading = movers.all()[0].velocity_mps;
    for (std::uint32_t step = 1; step <= 200; ++step) {
      movers.advance(step);
      const MoverRecord& mover = movers.all()[0];
      EXPECT_NEAR(mover.velocity_mps.norm(), 3.0, 1e-9);
      EXPECT_LE((mover.position_m - mover.before_m).norm(), 3.0 * kStep_s + 1e-9);
      EXPECT_GE((mover.position_m - box.min_m).minCoeff(), 0.0);
      EXPECT_GE((box.max_m - mover.position_m).minCoeff(), 0.0);
      const Vec3 change = mover.velocity_mps.cwiseAbs() - heading.cwiseAbs();
      turns += change.norm() > 1e-6 ? 1 : 0;  // a reflection leaves the sizes
      heading = mover.velocity_mps;
    }
  }
  EXPECT_NEAR(turns, 1000, 120) << "4000 steps of half a second, a turn every two";
}

TEST(Movers, AColumnWalksLevelAndSeedsDiffer) {
  Mover column = at({10, 10, 0}, WalkMotion{3.0, 2.0, {Vec3(0, 0, -9), Vec3(20, 20, 9)}});
  column.column = true;
  Movers first = one(column, 1);
  Movers again = one(column, 1);
  Movers second = one(column, 2);
  const Vec3 end_m = after(first, 50).position_m;
  EXPECT_EQ(end_m.z(), 0.0);
  EXPECT_EQ(after(again, 50).position_m, end_m);
  EXPECT_NE(after(second, 50).position_m, end_m);
}

TEST(Movers, ComeAtTheirTimeAndGo) {
  Mover mover = at({1, 2, 3}, LineMotion{Vec3(4, 0, 0)});
  mover.at_s = 1.0;
  mover.until_s = 2.0;
  Movers movers = one(mover);
  EXPECT_FALSE(after(movers, 2).present) << "until t = 1 s";
  movers.open(3, kNobody);
  EXPECT_TRUE(movers.all()[0].present);
  EXPECT_EQ(movers.all()[0].appeared_step, 3U);
  movers.advance(3);
  movers.open(4, kNobody);
  movers.advance(4);
  EXPECT_TRUE(movers.all()[0].position_m.isApprox(Vec3(5, 2, 3)));
  movers.open(5, kNobody);
  EXPECT_FALSE(movers.all()[0].present);
  EXPECT_EQ(movers.all()[0].gone_step, 5U);
  movers.open(6, kNobody);
  EXPECT_FALSE(movers.all()[0].present) << "once gone, always gone";
}

TEST(Movers, AppearOnceSomebodyCameNear) {
  Mover mover = at({0, 0, 0}, StillMotion{});
  mover.sudden = true;
  mover.near_m = 20.0;
  Movers movers = one(mover);
  movers.open(1, std::array{hovering({20.1, 0, 0})});
  EXPECT_FALSE(movers.all()[0].present);
  Bystander landed = hovering({5, 0, 0});
  landed.in_the_air = false;
  movers.open(2, std::array{landed});
  EXPECT_FALSE(movers.all()[0].present) << "who landed comes near nothing";
  movers.open(3, std::array{hovering({20, 0, 0})});
  EXPECT_TRUE(movers.all()[0].present);
}

TEST(Movers, WaitWhileSomebodyIsWhereTheyWouldBe) {
  Mover mover = at({0, 0, 0}, StillMotion{});
  mover.sudden = true;
  mover.at_s = 0.5;
  Movers movers = one(mover);
  movers.open(1, kNobody);
  movers.open(2, std::array{hovering({1.4, 0, 0})});
  EXPECT_FALSE(movers.all()[0].present) << "on top of it";
  movers.open(3, std::array{hovering({1.6, 0, 0})});
  EXPECT_TRUE(movers.all()[0].present);
  EXPECT_EQ(movers.all()[0].appeared_step, 3U);
}

TEST(Movers, AppearOnTheCourseOfTheirUav) {
  Mover mover = at({0, 0, 0}, StillMotion{});
  mover.sudden = true;
  mover.ahead = AheadOf{3, 40.0};
  Movers movers = one(mover);
  movers.open(1, std::array{hovering({5, 5, 5})});
  EXPECT_FALSE(movers.all()[0].present) << "it has no course";
  movers.open(2, std::array{flying({5, 5, 5}, {0, 6, 8})});
  EXPECT_TRUE(movers.all()[0].present);
  EXPECT_TRUE(movers.all()[0].position_m.isApprox(Vec3(5, 29, 37)));
}

TEST(Movers, OfAheadTheSeedDrawsAUavAndNoGoalIsBarred) {
  Mover mover = at({0, 0, 0}, StillMotion{});
  mover.sudden = true;
  mover.ahead = AheadOf{0, 40.0};
  std::array<int, 2> drawn{};
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    std::array vehicles{flying({0, 0, 0}, {10, 0, 0}), flying({0, 500, 0}, {10, 0, 0})};
    vehicles[1].spec.id = 4;
    Movers movers = one(mover, seed);
    movers.open(1, vehicles);
    ASSERT_TRUE(movers.all()[0].present);
    ++drawn[movers.all()[0].position_m.y() > 100.0 ? 1 : 0];
    Movers barring({mover}, {Vec3(42, 0, 0), Vec3(42, 500, 0)}, 4.0, seed, kStep_s);
    barring.open(1, vehicles);
    EXPECT_FALSE(barring.all()[0].present) << "2 m from a goal that wants 1 m and 4 m";
  }
  EXPECT_GT(drawn[0], 30);
  EXPECT_GT(drawn[1], 30);
}

TEST(Movers, CrossTheCourseSoThatTheyWouldMeetTheirUav) {
  Mover mover = at({0, 0, 0}, LineMotion{Vec3(3, 0, 0)});
  mover.sudden = true;
  mover.ahead = AheadOf{3, 80.0, true};
  int from_left = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Movers movers = one(mover, seed);
    const Bystander vehicle = flying({5, 5, 5}, {0, 10, 0});
    movers.open(1, std::array{vehicle});
    const MoverRecord& record = movers.all()[0];
    ASSERT_TRUE(record.present);
    EXPECT_NEAR(record.velocity_mps.norm(), 3.0, 1e-12);
    EXPECT_NEAR(record.velocity_mps.dot(vehicle.velocity_mps), 0.0, 1e-12);
    from_left += record.position_m.x() < 5.0 ? 1 : 0;
    for (std::uint32_t step = 1; step <= 16; ++step) movers.advance(step);
    EXPECT_LT((record.position_m - Vec3(5, 85, 5)).norm(), 1e-9) << "8 s later both are there";
  }
  EXPECT_GT(from_left, 15);
  EXPECT_LT(from_left, 45);
}

TEST(Movers, EnterTheHash) {
  const auto hash_after = [](const Mover& mover, std::uint32_t steps) {
    Movers movers = one(mover);
    (void)after(movers, steps);
    StateHash hash;
    movers.add_to(hash);
    return hash.value();
  };
  const Mover mover = at({1, 2, 3}, LineMotion{Vec3(4, 0, 0)});
  EXPECT_EQ(hash_after(mover, 3), hash_after(mover, 3));
  EXPECT_NE(hash_after(mover, 3), hash_after(mover, 4));
  StateHash none;
  Movers().add_to(none);
  EXPECT_EQ(none.value(), StateHash().value());
}

}  // namespace
}  // namespace skein
