// One look, by hand: range, occlusion, field of view, rate, faults.
#include "simworld/sensing/sensor.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "planner/core/math/det_math.hpp"
#include "tests/simworld/sensing/fields.hpp"

namespace skein::test {
namespace {

constexpr CellState kFree = CellState::Free;
constexpr CellState kOccupied = CellState::Occupied;
constexpr CellState kUnknown = CellState::Unknown;

SensorOptions reaching(double range_m) {
  SensorOptions options;
  options.range_m = range_m;
  return options;
}

Look from(double x_m, double y_m, double heading_rad = 0.0) {
  return {1, 1, Vec3(x_m, y_m, 0.5), heading_rad};
}

/// The rows of what was seen, northernmost first: '.', '#', and '?' for what was not.
std::vector<std::string> drawn(const TruthGrid& truth, const CellWindow& seen) {
  std::vector<std::string> rows;
  for (std::int32_t j = truth.grid().ny - 1; j >= 0; --j) {
    std::string& row = rows.emplace_back();
    for (std::int32_t i = 0; i < truth.grid().nx; ++i) {
      const CellState state = seen.at({i, j, 0});
      row += state == kFree ? '.' : state == kOccupied ? '#' : '?';
    }
  }
  return rows;
}

using Rows = std::vector<std::string>;

TEST(Sensor, SeesAWallAndNothingBehindIt) {
  const TruthGrid truth = field({".....", ".....", "#####", ".....", "....."});
  EXPECT_EQ(drawn(truth, look(truth, reaching(9), 1, from(2.5, 0.5))),
            (Rows{"?????", "?????", "#####", ".....", "....."}));
}

TEST(Sensor, AnObstacleThrowsAShadow) {
  const TruthGrid truth = field({".....", ".....", "..#..", ".....", "....."});
  EXPECT_EQ(drawn(truth, look(truth, reaching(9), 1, from(2.5, 0.5))),
            (Rows{".???.", "..?..", "..#..", ".....", "....."}));
}

TEST(Sensor, SeesAlongTheWallOfItsOwnRow) {
  const TruthGrid truth = field({"######", "......", "######"});
  EXPECT_EQ(drawn(truth, look(truth, reaching(9), 1, from(0.5, 1.5))), (Rows{"######", "......", "######"}));
}

TEST(Sensor, RangeIsToTheNearestPointOfACell) {
  const TruthGrid truth = field({"......."});
  EXPECT_EQ(drawn(truth, look(truth, reaching(3.5), 1, from(0.5, 0.5)))[0], ".....??");
  EXPECT_EQ(drawn(truth, look(truth, reaching(3.49), 1, from(0.5, 0.5)))[0], "....???");
  const CellWindow seen = look(truth, reaching(3.0), 1, from(3.5, 0.5));
  EXPECT_EQ((std::array<std::int32_t, 3>{seen.ni, seen.nj, seen.nk}), (std::array<std::int32_t, 3>{7, 1, 1}));
}

TEST(Sensor, APlaneHasNoHeight) {
  const TruthGrid truth = field({"....."});
  const Look high{1, 1, Vec3(0.5, 0.5, 0.99), 0.0};
  EXPECT_EQ(look(truth, reaching(2.6), 1, high), look(truth, reaching(2.6), 1, from(0.5, 0.5)));
}

TEST(Sensor, TheFieldOfViewIsAboutTheHeading) {
  const TruthGrid truth = field({".....", ".....", ".....", ".....", "....."});
  SensorOptions options = reaching(9);
  options.horizontal_fov_rad = math::kPi / 2;
  EXPECT_EQ(drawn(truth, look(truth, options, 1, from(2.5, 2.5, 0.0))),
            (Rows{"????.", "???..", "??...", "???..", "????."}));
  EXPECT_EQ(drawn(truth, look(truth, options, 1, from(2.5, 2.5, math::kPi / 2))),
            (Rows{".....", "?...?", "??.??", "?????", "?????"}));
}

TEST(Sensor, TheVerticalFieldOfViewIsAboutTheHorizontal) {
  const TruthGrid truth(CellGrid{Vec3::Zero(), 1.0, 1.0, 5, 1, 5}, {});
  SensorOptions options = reaching(9);
  options.vertical_fov_rad = math::kPi / 2;
  const CellWindow seen = look(truth, options, 1, {1, 1, Vec3(2.5, 0.5, 2.5), 0.0});
  EXPECT_EQ(seen.at({2, 0, 3}), kUnknown);
  EXPECT_EQ(seen.at({3, 0, 3}), kFree);
  EXPECT_EQ(seen.at({3, 0, 4}), kUnknown);
  EXPECT_EQ(seen.at({0, 0, 4}), kFree);
}

TEST(Sensor, OutsideItsRangeThereIsNoWindow) {
  const TruthGrid truth = field({"...", "...", "..."});
  EXPECT_TRUE(look(truth, reaching(2), 1, from(9.0, 0.5)).empty());
  EXPECT_EQ(CellWindow{}.at({0, 0, 0}), kUnknown);
}

TEST(Sensor, LooksOnceAPeriod) {
  const auto steps = [](double step_s, double period_s, std::uint32_t count) {
    std::vector<std::uint32_t> looks;
    for (std::uint32_t step = 1; step <= count; ++step) {
      if (looks_at(step, step_s, period_s)) looks.push_back(step);
    }
    return looks;
  };
  EXPECT_EQ(steps(1.0, 0.0, 4), (std::vector<std::uint32_t>{1, 2, 3, 4}));
  EXPECT_EQ(steps(0.5, 0.1, 3), (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(steps(0.1, 0.3, 10), (std::vector<std::uint32_t>{1, 4, 7, 10}));
  EXPECT_EQ(steps(1.0, 2.5, 12), (std::vector<std::uint32_t>{1, 4, 6, 9, 11}));
  EXPECT_EQ(steps(0.1, 1.0, 1000).size(), 100U);
}

TEST(SensorFaults, HaveTheirRatesAndNeverTakeAnObstacleForFree) {
  const TruthGrid truth = random_field(3, 40, 1, 0.1);
  SensorOptions options = reaching(200);
  options.miss = 0.2;
  options.false_alarm = 0.1;
  int seen = 0, missed = 0, clear = 0, alarms = 0;
  for (std::uint32_t step = 1; step <= 50; ++step) {
    Look at{4, step, truth.grid().centre_m({20, 20, 0}), 0.0};
    const CellWindow good = look(truth, reaching(200), 9, at);
    const CellWindow bad = look(truth, options, 9, at);
    for (std::size_t c = 0; c < good.size(); ++c) {
      if (good.at(c) == kUnknown) {
        EXPECT_EQ(bad.at(c), kUnknown);
        continue;
      }
      ++seen;
      missed += bad.at(c) == kUnknown ? 1 : 0;
      if (good.at(c) == kOccupied) {
        EXPECT_NE(bad.at(c), kFree);
      } else if (bad.at(c) != kUnknown) {
        ++clear;
        alarms += bad.at(c) == kOccupied ? 1 : 0;
      }
    }
  }
  ASSERT_GT(seen, 10000);
  EXPECT_NEAR(static_cast<double>(missed) / seen, 0.2, 0.015);
  EXPECT_NEAR(static_cast<double>(alarms) / clear, 0.1, 0.015);
}

TEST(SensorFaults, NeverTouchTheOwnCell) {
  const TruthGrid truth = field({"...", "...", "..."});
  SensorOptions options = reaching(5);
  options.miss = 0.9;
  options.false_alarm = 0.5;
  for (std::uint32_t step = 1; step <= 100; ++step) {
    EXPECT_EQ(look(truth, options, 2, {1, step, Vec3(1.5, 1.5, 0.5), 0.0}).at({1, 1, 0}), kFree);
  }
}

TEST(SensorFaults, DependOnSeedAgentAndStepAlone) {
  const TruthGrid truth = random_field(5, 30, 1, 0.05);
  SensorOptions options = reaching(30);
  options.miss = 0.3;
  const Look here{3, 17, truth.grid().centre_m({15, 15, 0}), 0.0};
  const CellWindow first = look(truth, options, 8, here);
  EXPECT_EQ(look(truth, options, 8, here), first);
  EXPECT_NE(look(truth, options, 9, here), first);
  EXPECT_NE(look(truth, options, 8, {4, 17, here.position_m, 0.0}), first);
  EXPECT_NE(look(truth, options, 8, {3, 18, here.position_m, 0.0}), first);
}

}  // namespace
}  // namespace skein::test
