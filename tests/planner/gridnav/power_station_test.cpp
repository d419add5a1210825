#include <gtest/gtest.h>

#include <algorithm>

#include "tests/planner/gridnav/maps.hpp"

namespace skein::gridnav {
namespace {

class PowerStation : public testing::TestWithParam<double> {};

TEST_P(PowerStation, NineArriveWithoutTouching) {
  const double cell_m = GetParam();
  const Layout layout = power_station(cell_m, 9);
  const Outcome outcome = fly(layout, {});
  EXPECT_EQ(outcome.count(NavStatus::Arrived), 9) << "after " << outcome.decisions << " decisions";
  EXPECT_EQ(outcome.hits, 0u);
  EXPECT_GE(outcome.closest_m, 0.5);
  for (std::size_t n = 0; n < 9; ++n) {
    const double least = shortest_m(layout, layout.starts[n], layout.grid.cell_of(layout.goals_m[n]));
    EXPECT_LT(outcome.flights[n].length_m, 2.5 * least) << "UAV " << n + 1;
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, PowerStation, testing::Values(2.0, 4.0, 6.0));

}  // namespace
}  // namespace skein::gridnav
