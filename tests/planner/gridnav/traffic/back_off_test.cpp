#include "planner/gridnav/traffic/back_off.hpp"

#include <gtest/gtest.h>

#include "tests/planner/gridnav/swarm_world.hpp"

namespace skein::gridnav {
namespace {

KnownMap seen(const std::vector<std::string>& rows) {
  const Layout layout = drawn(rows, 2.0);
  KnownMap map(layout.grid);
  for (CellIndex n = 0; n < layout.grid.size(); ++n)
    map.set(n, layout.occupied[n] ? CellState::Occupied : CellState::Free);
  return map;
}

Vec3 at(double i, double j) {
  return {2 * i + 1, 2 * j + 1, 1};
}

Other standing(AgentId id, const Vec3& place, const std::vector<Vec3>& way) {
  Other other;
  other.id = id;
  other.clearance_m = 0.52;
  other.now_m = other.next_m = place;
  other.way_m = {place, place};
  other.way_m.insert(other.way_m.end(), way.begin(), way.end());
  return other;
}

TEST(BackOff, TakesTheBay) {
  const KnownMap map = seen({"#####.##", "........"});
  const std::vector<Other> others{standing(2, at(2, 0), {at(7, 0)})};
  const BackOff found = find_back_off(map, at(3, 0), others, {true});
  ASSERT_EQ(found.cells.size(), 3u);
  EXPECT_EQ(found.cells.back(), map.grid().index_of({5, 1, 0}));
  EXPECT_EQ(found.blocked_by, 0u);
}

TEST(BackOff, GoesAwayWhereThereIsNoBay) {
  const KnownMap map = seen({"........"});
  const std::vector<Other> others{standing(2, at(2, 0), {at(5, 0)})};
  const BackOff found = find_back_off(map, at(3, 0), others, {true});
  ASSERT_FALSE(found.cells.empty());
  EXPECT_EQ(found.cells.back(), map.grid().index_of({6, 0, 0}));
}

TEST(BackOff, FindsNothingAtTheEnd) {
  const KnownMap map = seen({"...."});
  const std::vector<Other> others{standing(2, at(2, 0), {at(3, 0)})};
  EXPECT_TRUE(find_back_off(map, at(3, 0), others, {true}).cells.empty());
}

TEST(BackOff, NamesWhoMustBeAsked) {
  const KnownMap map = seen({"......"});
  const std::vector<Other> others{standing(2, at(1, 0), {at(3, 0)}), standing(3, at(3, 0), {})};
  const BackOff found = find_back_off(map, at(2, 0), others, {true, false});
  EXPECT_EQ(found.blocked_by, 3u);
  EXPECT_EQ(find_back_off(map, at(2, 0), others, {true, true}).blocked_by, 0u) << "who has right of way is not asked";
}

TEST(BackOff, KeepsToCellsThatWereSeen) {
  KnownMap map = seen({"#####.##", "........"});
  map.set(map.grid().index_of({5, 1, 0}), CellState::Unknown);
  const std::vector<Other> others{standing(2, at(2, 0), {at(7, 0)})};
  const BackOff found = find_back_off(map, at(3, 0), others, {true});
  ASSERT_FALSE(found.cells.empty());
  EXPECT_EQ(found.cells.back(), map.grid().index_of({7, 0, 0})) << "along the way, not into the unseen bay";
}

}  // namespace
}  // namespace skein::gridnav
