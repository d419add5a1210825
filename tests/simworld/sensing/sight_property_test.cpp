// What random looks report is true and in sight, and what must be seen is seen.
#include <gtest/gtest.h>

#include <algorithm>

#include "simworld/sensing/sensor.hpp"
#include "tests/simworld/sensing/fields.hpp"

namespace skein::test {
namespace {

struct Case {
  TruthGrid truth;
  Look from;
  SensorOptions options;
};

/// A field and a look from anywhere inside one of its free cells; half the time from the cell's centre.
Case random_case(std::uint64_t seed, std::int32_t levels) {
  RandomStream stream(seed, 1, Purpose::Test, 0);
  Case test{random_field(seed, 14, levels, stream.uniform(0.02, 0.4)), {}, {}};
  const CellGrid& grid = test.truth.grid();
  CellIndex cell = 0;
  do {
    cell = static_cast<CellIndex>(stream.below(grid.size()));
  } while (test.truth.occupied(cell));
  const Box box = grid.box_of(grid.cell_at(cell));
  const bool centre = stream.uniform() < 0.5;
  for (Eigen::Index a = 0; a < 3; ++a) {
    const double part = centre ? 0.5 : stream.uniform(0.01, 0.99);
    test.from.position_m[a] = box.min_m[a] + part * (box.max_m[a] - box.min_m[a]);
  }
  test.from.agent = 1;
  test.from.step = 1;
  test.options.range_m = stream.uniform(1.0, 20.0);
  return test;
}

/// Points along the segment, but for its last thousandth, in cells other than the first and the last are all free.
bool free_between(const TruthGrid& truth, const Vec3& from, const Vec3& to, const Cell& last) {
  const CellGrid& grid = truth.grid();
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = from + (to - from) * (i / 1000.0);
    const Cell at = grid.cell_of(p);
    if (!(at == grid.cell_of(from)) && !(at == last) && truth.occupied(at)) return false;
  }
  return true;
}

/// Some point of the cell can be seen, tried on a lattice that holds its centre and the centres of its faces.
bool lattice_sees(const TruthGrid& truth, const Vec3& from, const Cell& cell) {
  const Box box = truth.grid().box_of(cell);
  const int levels = truth.grid().nz == 1 ? 1 : 5;
  for (int n = 0; n < 25 * levels; ++n) {
    const Vec3 part(n % 5 / 4.0, n / 5 % 5 / 4.0, levels == 1 ? 0.5 : n / 25 / 4.0);
    if (free_between(truth, from, box.min_m + part.cwiseProduct(box.max_m - box.min_m), cell)) return true;
  }
  return false;
}

class Sight : public testing::TestWithParam<std::int32_t> {};

TEST_P(Sight, ReportsWhatIsThereAndWithinRangeAndInSight) {
  int seen = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Case test = random_case(seed, GetParam());
    const CellGrid& grid = test.truth.grid();
    if (grid.nz == 1) test.from.position_m.z() = grid.centre_m({0, 0, 0}).z();
    const CellWindow window = look(test.truth, test.options, seed, test.from);
    for (CellIndex index = 0; index < grid.size(); ++index) {
      const Cell cell = grid.cell_at(index);
      const CellState state = window.at(cell);
      if (state == CellState::Unknown) continue;
      ++seen;
      EXPECT_EQ(state == CellState::Occupied, test.truth.occupied(index));
      const Box box = grid.box_of(cell);
      const Vec3& p = test.from.position_m;
      EXPECT_LE((p - p.cwiseMax(box.min_m).cwiseMin(box.max_m)).norm(), test.options.range_m);
      if (seed % 4 == 0) {
        EXPECT_TRUE(lattice_sees(test.truth, p, cell)) << "seed " << seed << " cell " << index;
      }
    }
  }
  EXPECT_GT(seen, 1000);
}

TEST_P(Sight, KnowsEveryCellToWhichItMayMove) {
  for (std::uint64_t seed = 100; seed < 300; ++seed) {
    Case test = random_case(seed, GetParam());
    test.options.range_m = 3.0;  // the diagonal of a cell
    const CellWindow window = look(test.truth, test.options, seed, test.from);
    const Cell own = test.truth.grid().cell_of(test.from.position_m);
    EXPECT_EQ(window.at(own), CellState::Free);
    for (int n = 0; n < 27; ++n) {
      const Cell next{own.i + n % 3 - 1, own.j + n / 3 % 3 - 1, own.k + n / 9 - 1};
      if (test.truth.may_move(own, next)) {
        EXPECT_EQ(window.at(next), CellState::Free) << seed << " " << n;
      }
    }
  }
}

TEST_P(Sight, OfAnEmptySpaceEverythingWithinRangeIsSeen) {
  for (std::uint64_t seed = 300; seed < 330; ++seed) {
    Case test = random_case(seed, GetParam());
    const TruthGrid empty(test.truth.grid(), {});
    if (empty.grid().nz == 1) test.from.position_m.z() = empty.grid().centre_m({0, 0, 0}).z();
    const CellWindow window = look(empty, test.options, seed, test.from);
    for (CellIndex index = 0; index < empty.grid().size(); ++index) {
      const Cell cell = empty.grid().cell_at(index);
      const Box box = empty.grid().box_of(cell);
      const Vec3& p = test.from.position_m;
      const bool near = (p - p.cwiseMax(box.min_m).cwiseMin(box.max_m)).norm() <= test.options.range_m;
      EXPECT_EQ(window.at(cell), near ? CellState::Free : CellState::Unknown);
    }
  }
}

TEST_P(Sight, BehindAClosedRoomNothingIsSeen) {
  for (std::int32_t away = 1; away <= 4; ++away) {
    const CellGrid grid{Vec3::Zero(), 2.0, 1.0, 13, 13, GetParam()};
    std::vector<Obstacle> walls;
    const auto outside = [&](const Cell& c) { return std::max(std::abs(c.i - 6), std::abs(c.j - 6)) - away; };
    for (CellIndex index = 0; index < grid.size(); ++index) {
      if (outside(grid.cell_at(index)) == 0) walls.push_back({grid.box_of(grid.cell_at(index)), "wall"});
    }
    const TruthGrid truth(grid, walls);
    SensorOptions options;
    options.range_m = 50;
    const CellWindow window = look(truth, options, 1, {1, 1, grid.centre_m({6, 6, 0}), 0.0});
    for (CellIndex index = 0; index < grid.size(); ++index) {
      const Cell cell = grid.cell_at(index);
      if (outside(cell) > 0) {
        EXPECT_EQ(window.at(cell), CellState::Unknown);
      }
      if (outside(cell) < 0) {
        EXPECT_EQ(window.at(cell), CellState::Free);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, Sight, testing::Values(1, 4));

}  // namespace
}  // namespace skein::test
