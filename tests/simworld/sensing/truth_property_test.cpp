// Random shapes: a cell is occupied exactly if a point of its inside is inside a shape, tried on a fine lattice.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "planner/core/geometry/distance.hpp"
#include "tests/simworld/sensing/fields.hpp"

namespace skein::test {
namespace {

Obstacle random_obstacle(std::uint64_t seed) {
  RandomStream stream(seed, 0, Purpose::Test, 1);
  const auto place = [&] { return Vec3(stream.uniform(-2, 12), stream.uniform(-2, 12), stream.uniform(-2, 12)); };
  const Vec3 p = place();
  const double r = stream.uniform(0.3, 4.0);
  if (seed % 3 == 0) return {Sphere{p, r}, "sphere"};
  if (seed % 3 == 1) return {Cylinder{p.head<2>(), r, p.z() - 1.0, p.z() + r}, "cylinder"};
  return {Box{p, p + Vec3(r, stream.uniform(0.3, 4.0), stream.uniform(0.3, 4.0))}, "box"};
}

double depth(const Obstacle& obstacle, const Vec3& p) {
  if (const auto* sphere = std::get_if<Sphere>(&obstacle.shape))
    return (p - sphere->centre_m).norm() - sphere->radius_m;
  if (const auto* box = std::get_if<Box>(&obstacle.shape)) return signed_distance(p, *box);
  return signed_distance(p, std::get<Cylinder>(obstacle.shape));
}

TEST(TruthProperty, ACellIsOccupiedExactlyIfAPointOfItIsInside) {
  constexpr int kSteps = 16;
  const CellGrid grid = grid_over({Vec3::Zero(), Vec3(10, 10, 9)}, 2.0, 1.5);
  const double spacing_m = Vec3(2.0, 2.0, 1.5).norm() / kSteps;
  int occupied = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Obstacle obstacle = random_obstacle(seed);
    const TruthGrid truth(grid, std::vector{obstacle});
    for (CellIndex cell = 0; cell < grid.size(); ++cell) {
      const Box box = grid.box_of(grid.cell_at(cell));
      double least_m = std::numeric_limits<double>::infinity();
      for (int n = 0; n < kSteps * kSteps * kSteps; ++n) {
        const Vec3 part((n % kSteps + 0.5) / kSteps, (n / kSteps % kSteps + 0.5) / kSteps,
                        (n / kSteps / kSteps + 0.5) / kSteps);
        least_m = std::min(least_m, depth(obstacle, box.min_m + part.cwiseProduct(box.max_m - box.min_m)));
      }
      occupied += truth.occupied(cell) ? 1 : 0;
      if (least_m < 0.0) {
        EXPECT_TRUE(truth.occupied(cell)) << "seed " << seed << " cell " << cell;
      }
      if (least_m > spacing_m) {
        EXPECT_FALSE(truth.occupied(cell)) << "seed " << seed << " cell " << cell;
      }
    }
  }
  EXPECT_GT(occupied, 200);
}

TEST(TruthProperty, OccupiedCellsOfABlockAreCounted) {
  const TruthGrid truth = random_field(4, 9, 5, 0.3);
  const CellGrid& grid = truth.grid();
  RandomStream stream(1, 0, Purpose::Test, 2);
  for (int n = 0; n < 500; ++n) {
    const Cell a = grid.cell_at(static_cast<CellIndex>(stream.below(grid.size())));
    const Cell b = grid.cell_at(static_cast<CellIndex>(stream.below(grid.size())));
    std::uint32_t count = 0;
    for (CellIndex index = 0; index < grid.size(); ++index) {
      const Cell c = grid.cell_at(index);
      const auto between = [](std::int32_t x, std::int32_t p, std::int32_t q) {
        return x >= std::min(p, q) && x <= std::max(p, q);
      };
      if (between(c.i, a.i, b.i) && between(c.j, a.j, b.j) && between(c.k, a.k, b.k)) count += truth.occupied(index);
    }
    EXPECT_EQ(truth.occupied_between(a, b), count);
  }
}

}  // namespace
}  // namespace skein::test
