// Random and mutilated bytes through every decoder: none crashes, and what passes is within the limits.
// SKEIN_FUZZ_RUNS sets how many strings of each sort every decoder gets (default 20000).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "idl/convert/cdr.hpp"
#include "tests/idl/convert/examples.hpp"

namespace skein {
namespace {

int runs() {
  const char* set = std::getenv("SKEIN_FUZZ_RUNS");
  return set == nullptr ? 20000 : std::max(1, std::atoi(set));
}

Bytes random_bytes(std::mt19937_64& random) {
  Bytes bytes(random() % 400);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  if (bytes.size() >= 4) bytes[0] = 0, bytes[1] = static_cast<std::uint8_t>(random() % 2);
  return bytes;
}

/// A valid sample with some bytes changed, and sometimes its end cut off.
Bytes mutilated(Bytes bytes, std::mt19937_64& random) {
  const auto changes = 1 + random() % 4;
  for (std::uint64_t i = 0; i < changes; ++i) {
    const std::size_t place = 4 + random() % (bytes.size() - 4);
    bytes[place] = random() % 3 == 0 ? std::uint8_t{0xff} : static_cast<std::uint8_t>(random());
  }
  if (random() % 8 == 0) bytes.resize(4 + random() % (bytes.size() - 4));
  return bytes;
}

struct Outcome {
  int undecodable = 0;
  int refused = 0;
  int passed = 0;
};

template <typename Wire>
void try_bytes(const Bytes& bytes, Outcome& outcome) {
  const auto sample = from_cdr<Wire>(bytes);
  if (!sample) {
    ++outcome.undecodable;
    return;
  }
  const auto checked = from_wire(*sample, {});
  if (!checked) {
    ++outcome.refused;
    EXPECT_FALSE(checked.fault().where.empty());
    return;
  }
  ++outcome.passed;
  // A NaN would not equal itself: equality after another round proves that none passed, and that nothing was lost.
  const auto again = from_wire(to_wire(checked.value(), examples::kStamp), {});
  ASSERT_TRUE(again.ok()) << again.fault().where;
  EXPECT_EQ(again.value(), checked.value());
}

template <typename Plain>
void fuzz(const Plain& example) {
  const auto valid = to_cdr(to_wire(example, examples::kStamp));
  using Wire = decltype(to_wire(example, examples::kStamp));
  std::mt19937_64 random(20240601);
  const int count = runs();
  Outcome noise;
  Outcome near;
  for (int i = 0; i < count; ++i) {
    try_bytes<Wire>(random_bytes(random), noise);
    try_bytes<Wire>(mutilated(valid, random), near);
  }
  EXPECT_EQ(noise.passed + noise.refused + noise.undecodable, count);
  EXPECT_EQ(noise.passed, 0);
  EXPECT_GT(near.passed, 0);
  EXPECT_GT(near.refused, 0);
  EXPECT_GT(near.undecodable, 0);
}

TEST(Fuzz, Mission) {
  fuzz(examples::mission());
}
TEST(Fuzz, MissionOfATransit) {
  fuzz(examples::crossing());
}
TEST(Fuzz, ObstacleMap) {
  fuzz(examples::obstacle_map());
}
TEST(Fuzz, Tick) {
  fuzz(examples::tick());
}
TEST(Fuzz, Sense) {
  fuzz(examples::sense());
}
TEST(Fuzz, Representative) {
  fuzz(examples::representative());
  fuzz(examples::revision());
}
TEST(Fuzz, Command) {
  fuzz(examples::command());
}
TEST(Fuzz, Inject) {
  fuzz(examples::inject());
}
TEST(Fuzz, Beacon) {
  fuzz(examples::beacon());
}

}  // namespace
}  // namespace skein
