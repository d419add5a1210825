// Which cells count as occupied, by hand.
#include "simworld/sensing/truth_grid.hpp"

#include <gtest/gtest.h>

#include "tests/simworld/sensing/fields.hpp"

namespace skein::test {
namespace {

const CellGrid kPlane = grid_over({Vec3(0, 0, 4), Vec3(40, 40, 8)}, 4.0, 4.0);

std::size_t count(const TruthGrid& truth) {
  std::size_t cells = 0;
  for (CellIndex cell = 0; cell < truth.grid().size(); ++cell) cells += truth.occupied(cell) ? 1 : 0;
  return cells;
}

TEST(TruthGrid, AWallThatEndsAtAnEdgeLeavesTheNextCellFree) {
  const TruthGrid truth(kPlane, std::vector<Obstacle>{{Box{Vec3(8, 0, 0), Vec3(16, 12, 5)}, "wall"}});
  EXPECT_EQ(count(truth), 6U);
  EXPECT_TRUE(truth.occupied(Cell{2, 0, 0}));
  EXPECT_TRUE(truth.occupied(Cell{3, 2, 0}));
  EXPECT_FALSE(truth.occupied(Cell{4, 0, 0}));
  EXPECT_FALSE(truth.occupied(Cell{2, 3, 0}));
}

TEST(TruthGrid, EdgesThatNoBinaryFractionHitsDoNotCount) {
  const CellGrid grid = grid_over({Vec3::Zero(), Vec3(3, 3, 1)}, 0.1, 1.0);
  EXPECT_EQ(grid.nx, 30);
  const TruthGrid truth(grid, std::vector<Obstacle>{{Box{Vec3(0.3, 0.3, 0), Vec3(0.6, 0.7, 1)}, "box"}});
  EXPECT_EQ(count(truth), 12U);
}

TEST(TruthGrid, WhatIsBelowTheLevelOrOutsideDoesNotCount) {
  const TruthGrid truth(kPlane, std::vector<Obstacle>{{Box{Vec3(8, 0, 0), Vec3(16, 12, 4)}, "low"},
                                                      {Sphere{Vec3(-5, 10, 6), 5.0}, "touches the area"},
                                                      {Cylinder{Vec2(60, 60), 10.0}, "outside"}});
  EXPECT_EQ(count(truth), 0U);
}

TEST(TruthGrid, ACylinderOccupiesTheCellsThatItReachesInto) {
  const TruthGrid truth(kPlane, std::vector<Obstacle>{{Cylinder{Vec2(18, 18), 4.5, 0.0, 9.0}, "tree"}});
  EXPECT_EQ(count(truth), 9U) << "3 x 3 cells: 4.5 m is more than the 2 m to an edge, the corners are 2.8 m away";
  const TruthGrid thin(kPlane, std::vector<Obstacle>{{Cylinder{Vec2(18, 18), 2.5, 0.0, 9.0}, "tree"}});
  EXPECT_EQ(count(thin), 5U) << "without the corners";
}

TEST(TruthGrid, ASphereIsSmallerOnOtherLevels) {
  const CellGrid grid = grid_over({Vec3::Zero(), Vec3(12, 12, 12)}, 4.0, 4.0);
  const TruthGrid truth(grid, std::vector<Obstacle>{{Sphere{Vec3(6, 6, 6), 2.5}, "ball"}});
  EXPECT_EQ(count(truth), 7U) << "the middle and its six sides";
}

TEST(TruthGrid, TerrainFillsFromBelow) {
  const CellGrid grid = grid_over({Vec3::Zero(), Vec3(12, 12, 12)}, 4.0, 4.0);
  const Terrain level{.e = 5.0};  // 5 m everywhere
  const TruthGrid truth(grid, std::vector<Obstacle>{{level, "terrain"}});
  EXPECT_EQ(count(truth), 18U);
  EXPECT_TRUE(truth.occupied(Cell{1, 1, 1}));
  EXPECT_FALSE(truth.occupied(Cell{1, 1, 2}));
}

TEST(TruthGrid, AMeshOccupiesTheCellsOfItsSurface) {
  const CellGrid grid = grid_over({Vec3::Zero(), Vec3(12, 12, 4)}, 4.0, 4.0);
  const Mesh triangle({Vec3(1, 1, 2), Vec3(11, 1, 2), Vec3(1, 11, 2)}, {{0, 1, 2}});
  const TruthGrid truth(grid, std::vector<Obstacle>{{triangle, "roof"}});
  EXPECT_EQ(count(truth), 6U) << "below and on the diagonal";
  EXPECT_FALSE(truth.occupied(Cell{2, 1, 0}));
  EXPECT_TRUE(truth.occupied(Cell{1, 1, 0}));
}

TEST(TruthGrid, MovesCutNoCorner) {
  const TruthGrid truth = field({"..", ".#"});
  EXPECT_TRUE(truth.may_move({0, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(truth.may_move({0, 0, 0}, {1, 1, 0}));
  EXPECT_FALSE(truth.may_move({0, 0, 0}, {-1, 0, 0})) << "outside nobody flies";
}

TEST(TruthGrid, AGridWithoutCellsIsRefused) {
  EXPECT_THROW(TruthGrid(grid_over({Vec3::Zero(), Vec3(1, 1, 1)}, 2.0, 1.0), {}), std::invalid_argument);
}

TEST(AllObstacles, AreTheHiddenOnesAndWhatTheMissionTells) {
  Mission mission;
  mission.zones = {{Box{}, true}, {Cylinder{}, false}};
  mission.terrain = Terrain{};
  const std::vector<Obstacle> hidden{{Sphere{}, "hidden_obstacles.1"}};
  const std::vector<Obstacle> all = all_obstacles(mission, hidden);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0], hidden[0]);
  EXPECT_EQ(all[1].name, "no_fly");
  EXPECT_TRUE(std::holds_alternative<Terrain>(all[3].shape));
}

}  // namespace
}  // namespace skein::test
