#include "planner/core/random/random_stream.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace skein {
namespace {

std::vector<std::uint64_t> words(RandomStream stream, int n) {
  std::vector<std::uint64_t> drawn;
  for (int i = 0; i < n; ++i) drawn.push_back(stream.next());
  return drawn;
}

TEST(RandomStream, GoldenWords) {
  const std::vector<std::uint64_t> expected{0x68f4d85d40518033ULL, 0x4d90d154f24f436aULL, 0x63d57444b84bc2a4ULL,
                                            0xcee4f6f6b4fc4808ULL, 0x3a5cc382176ed66aULL, 0x72d3fbe0b223d921ULL};
  EXPECT_EQ(words(RandomStream(1, 2, Purpose::SwarmMove, 3), 6), expected);
}

TEST(RandomStream, GoldenNumbers) {
  RandomStream stream(42, 1, Purpose::SwarmStart, 0);
  EXPECT_EQ(stream.uniform(), 0x1.2b4dd472fd21p-3);
  EXPECT_EQ(stream.below(1000), 8U);
  EXPECT_EQ(stream.normal(), -0x1.44e2129effb5ap+1);
}

TEST(RandomStream, EveryPartOfTheNameMatters) {
  const auto base = words(RandomStream(1, 2, Purpose::Test, 3), 8);
  EXPECT_EQ(words(RandomStream(1, 2, Purpose::Test, 3), 8), base);
  EXPECT_NE(words(RandomStream(2, 2, Purpose::Test, 3), 8), base);
  EXPECT_NE(words(RandomStream(1, 3, Purpose::Test, 3), 8), base);
  EXPECT_NE(words(RandomStream(1, 2, Purpose::SwarmStart, 3), 8), base);
  EXPECT_NE(words(RandomStream(1, 2, Purpose::Test, 4), 8), base);
}

TEST(RandomStream, ACopyContinuesAlike) {
  RandomStream stream(7, 1, Purpose::Test, 0);
  stream.next();
  RandomStream copy = stream;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(copy.next(), stream.next());
}

TEST(RandomStream, MomentsOfUniformAndNormal) {
  constexpr int kDraws = 200000;
  RandomStream stream(5, 1, Purpose::Test, 1);
  double uniform_sum = 0.0;
  double normal_sum = 0.0;
  double normal_squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = stream.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    uniform_sum += u;
    const double z = stream.normal();
    normal_sum += z;
    normal_squares += z * z;
  }
  // Five standard errors.
  EXPECT_NEAR(uniform_sum / kDraws, 0.5, 5.0 * 0.2887 / std::sqrt(kDraws));
  EXPECT_NEAR(normal_sum / kDraws, 0.0, 5.0 / std::sqrt(kDraws));
  EXPECT_NEAR(normal_squares / kDraws, 1.0, 5.0 * std::sqrt(2.0 / kDraws));
}

TEST(RandomStream, UniformStaysBetweenItsEnds) {
  RandomStream stream(5, 1, Purpose::Test, 2);
  for (int i = 0; i < 1000; ++i) {
    const double x = stream.uniform(-3.0, 2.0);
    EXPECT_GE(x, -3.0);
    EXPECT_LE(x, 2.0);
  }
}

TEST(RandomStream, BelowReachesEveryNumberAlike) {
  RandomStream stream(5, 1, Purpose::Test, 3);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(stream.below(7));
  for (const int count : counts) EXPECT_NEAR(count, 10000, 500);
  EXPECT_EQ(stream.below(1), 0U);
}

TEST(RandomStream, BelowZeroIsRefused) {
  RandomStream stream(5, 1, Purpose::Test, 4);
  EXPECT_THROW((void)stream.below(0), std::invalid_argument);
}

}  // namespace
}  // namespace skein
