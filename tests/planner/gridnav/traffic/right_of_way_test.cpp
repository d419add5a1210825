#include "planner/gridnav/traffic/right_of_way.hpp"

#include <gtest/gtest.h>

#include "planner/core/geometry/closest_approach.hpp"
#include "planner/core/random/random_stream.hpp"

namespace skein::gridnav {
namespace {

Intent motion(const Vec3& from, const Vec3& to, double to_go_m, AgentId own) {
  Intent intent;
  intent.decision = 1;
  intent.from_m = from;
  intent.to_m = to;
  intent.to_go_m = to_go_m;
  intent.on_behalf_of = own;
  return intent;
}

bool flies(const Intent& own, const std::vector<Neighbour>& others) {
  const std::vector<double> reaches(others.size(), 10.0);
  return may_fly({1, 0.25, 10.0}, own, others, reaches);
}

TEST(Order, IsByGroupRotationsWayToGoAndId) {
  Intent a = motion(Vec3::Zero(), Vec3::Zero(), 50, 1);
  Intent b = motion(Vec3::Zero(), Vec3::Zero(), 40, 2);
  EXPECT_LT(key_of(2, b), key_of(1, a));
  b.waited = 1;
  EXPECT_LT(key_of(1, a), key_of(2, b));
  a.status = NavStatus::Deadlock;
  EXPECT_LT(key_of(2, b), key_of(1, a));
  b.status = NavStatus::Unreachable;
  EXPECT_LT(key_of(1, a), key_of(2, b));
}

TEST(Order, WhoMovesOnBehalfOfAnotherComesRightAfterIt) {
  const Intent root = motion(Vec3::Zero(), Vec3::Zero(), 40, 7);
  EXPECT_LT(key_of(7, root), key_of(2, root));
  EXPECT_LT(key_of(2, root), key_of(3, motion(Vec3::Zero(), Vec3::Zero(), 41, 3)));
}

TEST(MayFly, NotOverWhereAnotherStands) {
  const Intent own = motion({0, 0, 0}, {10, 0, 0}, 10, 1);
  Neighbour other{2, Vec3(5, 0.5, 0), 0.25, motion({5, 0.5, 0}, {5, 9, 0}, 99, 2)};
  EXPECT_FALSE(flies(own, {other})) << "it may not leave";
  other.position_m.y() = 0.6;
  EXPECT_TRUE(flies(own, {other}));
}

TEST(MayFly, TheLowerAvoidsTheMotionOfTheHigher) {
  const Intent own = motion({0, 0, 0}, {10, 0, 0}, 10, 1);
  const Neighbour first{2, Vec3(5, -5, 0), 0.25, motion({5, -5, 0}, {5, 5, 0}, 9, 2)};
  const Neighbour second{2, Vec3(5, -5, 0), 0.25, motion({5, -5, 0}, {5, 5, 0}, 11, 2)};
  EXPECT_FALSE(flies(own, {first}));
  EXPECT_TRUE(flies(own, {second}));
}

TEST(MayFly, WhoWasNotHeardMayBeAnywhereWithinReach) {
  const Intent own = motion({0, 0, 0}, {10, 0, 0}, 10, 1);
  EXPECT_FALSE(flies(own, {{2, Vec3(5, 10.5, 0), 0.25, std::nullopt}}));
  EXPECT_TRUE(flies(own, {{2, Vec3(5, 10.6, 0), 0.25, std::nullopt}}));
}

TEST(MayFly, NoTwoTouchWhateverIsLost) {
  int moved = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 42);
    const double width = stream.uniform(5.0, 40.0);
    std::vector<Neighbour> all;
    std::vector<Intent> intents;
    while (all.size() < 5) {
      const Vec3 at(stream.uniform(0, width), stream.uniform(0, width), 0);
      bool apart = true;
      for (const Neighbour& n : all) apart = apart && (n.position_m - at).norm() > 0.6;
      const double angle = stream.uniform(-1, 1);
      const Vec3 by = stream.uniform(0, 10) * Vec3(angle, std::sqrt(1 - angle * angle), 0);
      const auto id = static_cast<AgentId>(all.size() + 1);
      const Intent intent = motion(at, seed % 2 == 0 ? Vec3(at + by) : Vec3(at - by), stream.uniform(0, 3), id);
      if (!apart) continue;
      all.push_back({id, at, 0.25, std::nullopt});
      intents.push_back(intent);
    }
    std::vector<Vec3> ends;
    for (const Neighbour& own : all) {
      const Intent& intent = intents[own.id - 1];
      std::vector<Neighbour> others;
      for (std::size_t n = 0; n < all.size(); ++n) {
        if (all[n].id == own.id) continue;
        others.push_back({all[n].id, all[n].position_m, 0.25, std::nullopt});
        if (stream.uniform() >= 0.3) others.back().intent = intents[n];
      }
      const std::vector<double> reaches(others.size(), 10.0);
      const bool goes = may_fly({own.id, 0.25, 10.0}, intent, others, reaches);
      moved += goes ? 1 : 0;
      ends.push_back(goes ? intent.to_m : own.position_m);
    }
    for (std::size_t a = 0; a < all.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        EXPECT_GE(closest_approach(all[a].position_m, ends[a], all[b].position_m, ends[b]).distance_m, 0.5)
            << "seed " << seed;
  }
  EXPECT_GT(moved, 1000);
}

TEST(OnWay, SaysHowFarAndWhere) {
  const std::vector<Vec3> way{Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 10, 0)};
  const OnWay at = on_way(Vec3(12, 4, 0), way);
  EXPECT_DOUBLE_EQ(at.distance_m, 2.0);
  EXPECT_DOUBLE_EQ(at.along_m, 14.0);
}

TEST(ConflictOf, TellsStandingMovingAndAgainst) {
  Other other;
  other.id = 2;
  other.clearance_m = 0.52;
  other.now_m = Vec3(20, 0, 0);
  other.next_m = Vec3(10, 0, 0);
  other.way_m = {other.now_m, other.next_m, Vec3(0, 0, 0), Vec3(-10, 0, 0)};
  other.moves_on = true;
  const auto at = [&](const Vec3& from, const Vec3& to, const Vec3& after, bool first) {
    return conflict_of(from, to, after, other, first);
  };
  EXPECT_EQ(at(Vec3(5, -5, 0), Vec3(5, 5, 0), Vec3(5, 9, 0), true), Conflict::Moving);
  EXPECT_EQ(at(Vec3(4, 0, 0), Vec3(12, 0, 0), Vec3(20, 0, 0), false), Conflict::Standing);
  EXPECT_EQ(at(Vec3(-8, 3, 0), Vec3(-8, 0, 0), Vec3(-4, 0, 0), true), Conflict::Against);
  EXPECT_EQ(at(Vec3(-8, 3, 0), Vec3(-8, 0, 0), Vec3(-10, 0, 0), true), Conflict::None) << "the same way";
  EXPECT_EQ(at(Vec3(-8, 3, 0), Vec3(-8, 0, 0), Vec3(-4, 0, 0), false), Conflict::None) << "without right of way";
}

}  // namespace
}  // namespace skein::gridnav
