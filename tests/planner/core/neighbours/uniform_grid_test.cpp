#include "planner/core/neighbours/uniform_grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "planner/core/random/random_stream.hpp"

namespace skein {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(UniformGrid, FindsTheRimAndCountsUp) {
  const std::vector<Vec3> points{{3, 0, 0}, {0, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, 0, 2.001}};
  const UniformGrid grid(points, 1.0);
  std::vector<std::uint32_t> found;
  grid.within(Vec3::Zero(), 2.0, found);
  EXPECT_THAT(found, ElementsAre(1, 2, 3));
  grid.within(Vec3(3, 0, 0), 0.0, found);
  EXPECT_THAT(found, ElementsAre(0));
}

TEST(UniformGrid, OfNothingFindsNothing) {
  const UniformGrid grid({}, 5.0);
  std::vector<std::uint32_t> found{7};
  grid.within(Vec3::Zero(), 100.0, found);
  EXPECT_THAT(found, IsEmpty());
}

TEST(UniformGrid, RefusesWhatIsNotFinite) {
  const std::vector<Vec3> broken{{0, std::numeric_limits<double>::quiet_NaN(), 0}};
  EXPECT_THROW(UniformGrid(broken, 1.0), std::invalid_argument);
  EXPECT_THROW(UniformGrid({}, 0.0), std::invalid_argument);
  EXPECT_THROW(UniformGrid({}, std::numeric_limits<double>::infinity()), std::invalid_argument);
  const std::vector<Vec3> points{{0, 0, 0}};
  const UniformGrid grid(points, 1.0);
  std::vector<std::uint32_t> found;
  grid.within(Vec3::Zero(), std::numeric_limits<double>::quiet_NaN(), found);
  EXPECT_THAT(found, IsEmpty());
  grid.within(Vec3::Zero(), -1.0, found);
  EXPECT_THAT(found, IsEmpty());
}

TEST(UniformGrid, FindsWhatBruteForceFinds) {
  for (std::uint64_t round = 0; round < 200; ++round) {
    RandomStream random(5, 0, Purpose::Test, round);
    const double extent_m = random.uniform() < 0.2 ? 1e12 : random.uniform(1.0, 300.0);
    std::vector<Vec3> points(random.below(400));
    for (Vec3& p : points) {
      p = Vec3(random.uniform(-extent_m, extent_m), random.uniform(-extent_m, extent_m), random.uniform(-20, 20));
    }
    const UniformGrid grid(points, random.uniform(0.5, 40.0));
    for (int query = 0; query < 10; ++query) {
      const Vec3 place(random.uniform(-extent_m, extent_m), random.uniform(-extent_m, extent_m), 0.0);
      const double radius_m = random.uniform(0.0, random.uniform() < 0.1 ? 2.0 * extent_m : 60.0);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t n = 0; n < points.size(); ++n) {
        if ((points[n] - place).squaredNorm() <= radius_m * radius_m) expected.push_back(n);
      }
      std::vector<std::uint32_t> found;
      grid.within(place, radius_m, found);
      ASSERT_EQ(found, expected) << "round " << round;
    }
  }
}

}  // namespace
}  // namespace skein
