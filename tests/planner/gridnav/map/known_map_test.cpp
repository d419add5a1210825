#include "planner/gridnav/map/known_map.hpp"

#include <gtest/gtest.h>

#include "planner/core/geometry/distance.hpp"
#include "planner/core/random/random_stream.hpp"

namespace skein::gridnav {
namespace {

TEST(KnownMap, UnknownCellsServePlanningOnly) {
  KnownMap map({Vec3::Zero(), 2.0, 2.0, 4, 1, 1});
  const Vec3 a(1, 1, 1), b(7, 1, 1);
  EXPECT_TRUE(map.motion_clear(a, b, 0.5, Need::NotOccupied));
  EXPECT_FALSE(map.motion_clear(a, b, 0.5, Need::SeenFree));
  for (CellIndex n = 0; n < 4; ++n) map.set(n, n % 2 == 0 ? CellState::Free : CellState::Revisited);
  EXPECT_TRUE(map.motion_clear(a, b, 0.5, Need::SeenFree));
  map.set(2, CellState::Occupied);
  EXPECT_FALSE(map.motion_clear(a, b, 0.5, Need::NotOccupied));
  EXPECT_TRUE(map.motion_clear(a, Vec3(3.5, 1, 1), 0.5, Need::NotOccupied)) << "a body may touch";
  EXPECT_FALSE(map.motion_clear(a, Vec3(3.51, 1, 1), 0.5, Need::NotOccupied));
}

TEST(KnownMap, TheBodyMustStayInside) {
  const KnownMap map({Vec3::Zero(), 2.0, 2.0, 4, 1, 1});
  EXPECT_FALSE(map.motion_clear(Vec3(1, 1, 1), Vec3(7.6, 1, 1), 0.5, Need::NotOccupied));
  EXPECT_FALSE(map.motion_clear(Vec3(1, 1, 1), Vec3(1, 1.6, 1), 0.5, Need::NotOccupied));
}

TEST(KnownMap, EqualsTheDistanceToEveryBox) {
  int clear = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 41);
    const bool planar = seed % 2 == 0;
    const CellGrid grid{Vec3(3, -2, 1), 1.5, 2.5, 12, 9, planar ? 1 : 4};
    KnownMap map(grid);
    for (CellIndex n = 0; n < grid.size(); ++n)
      if (stream.uniform() < 0.12) map.set(n, CellState::Occupied);
    const double radius_m = stream.uniform(0.1, 0.7);
    const auto point = [&] {
      return Vec3(grid.origin_m +
                  Vec3(stream.uniform(0.7, 17.3), stream.uniform(0.7, 12.8), stream.uniform(0.7, grid.nz * 2.5 - 0.7)));
    };
    const Vec3 a = point(), b = point();
    bool expected = true;
    for (CellIndex n = 0; n < grid.size(); ++n) {
      if (map.state(n) != CellState::Occupied) continue;
      const Box box = grid.box_of(grid.cell_at(n));
      const double d = planar ? signed_distance(Vec2(a.head<2>()), Vec2(b.head<2>()), box) : signed_distance(a, b, box);
      expected = expected && d >= radius_m;
    }
    EXPECT_EQ(map.motion_clear(a, b, radius_m, Need::NotOccupied), expected) << "seed " << seed;
    clear += expected ? 1 : 0;
  }
  EXPECT_GT(clear, 100);
  EXPECT_LT(clear, 500);
}

}  // namespace
}  // namespace skein::gridnav
