// Shortest ways by hand, and the regions that paths join.
#include "simworld/sensing/shortest_paths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/simworld/sensing/fields.hpp"

namespace skein::test {
namespace {

std::optional<double> length_m(const TruthGrid& truth, const Vec3& start_m, const Vec3& goal_m) {
  return shortest_paths_m(truth, std::vector{start_m}, std::vector{goal_m})[0];
}

TEST(ShortestPaths, GoDiagonallyButCutNoCorner) {
  EXPECT_DOUBLE_EQ(*length_m(field({"...", "...", "..."}), {0.5, 0.5, 0.5}, {2.5, 2.5, 0.5}), 2.0 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(*length_m(field({"...", ".#.", "..."}), {0.5, 0.5, 0.5}, {2.5, 2.5, 0.5}), 4.0);
}

TEST(ShortestPaths, AreNothingWhereNoneIs) {
  const TruthGrid truth = field({".#.", ".#.", ".#."});
  EXPECT_EQ(length_m(truth, {0.5, 0.5, 0.5}, {2.5, 0.5, 0.5}), std::nullopt);
  EXPECT_EQ(length_m(truth, {0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}), std::nullopt) << "the goal is occupied";
  EXPECT_EQ(length_m(truth, {9.5, 0.5, 0.5}, {0.5, 0.5, 0.5}), std::nullopt) << "the start is outside";
  EXPECT_EQ(length_m(truth, {0.1, 0.1, 0.5}, {0.9, 0.9, 0.5}), 0.0);
}

TEST(ShortestPaths, ClimbByTheHeightOfACell) {
  const TruthGrid truth(CellGrid{Vec3::Zero(), 3.0, 4.0, 2, 1, 2}, {});
  EXPECT_DOUBLE_EQ(*length_m(truth, {1, 1, 1}, {4, 1, 5}), 5.0);
}

TEST(ShortestPaths, KeepTheOrderOfStartsWithGoalsOfTheirOwn) {
  const TruthGrid truth = field({"....."});
  const std::vector<Vec3> starts{{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}, {4.5, 0.5, 0.5}};
  const std::vector<Vec3> goals{{4.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {4.5, 0.5, 0.5}};
  const auto lengths_m = shortest_paths_m(truth, starts, goals);
  EXPECT_EQ(lengths_m, (std::vector<std::optional<double>>{4.0, 1.0, 0.0}));
  EXPECT_THROW((void)shortest_paths_m(truth, starts, {}), std::invalid_argument);
}

TEST(Regions, AreWhatPathsJoin) {
  const TruthGrid truth = field({".#.", "#..", "..#"});
  const std::vector<std::uint32_t> regions = regions_of(truth);
  EXPECT_EQ(regions, (std::vector<std::uint32_t>{1, 1, 0, 0, 1, 1, 2, 0, 1}));
}

TEST(Regions, AreJoinedExactlyWhereShortestPathsAre) {
  const TruthGrid truth = random_field(11, 12, 2, 0.45);
  const std::vector<std::uint32_t> regions = regions_of(truth);
  const Vec3 goal_m = truth.grid().centre_m({6, 6, 1});
  const std::uint32_t home = regions[truth.grid().index_of({6, 6, 1})];
  for (CellIndex cell = 0; cell < regions.size(); ++cell) {
    const bool joined = length_m(truth, truth.grid().centre_m(truth.grid().cell_at(cell)), goal_m).has_value();
    EXPECT_EQ(joined, home != 0 && regions[cell] == home);
  }
}

}  // namespace
}  // namespace skein::test
