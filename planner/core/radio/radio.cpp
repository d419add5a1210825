#include "planner/core/radio/radio.hpp"

#include <cmath>

#include "planner/core/random/random_stream.hpp"

namespace skein {

bool in_range(const RadioOptions& options, const Vec3& from_m, const Vec3& to_m) {
  return (to_m - from_m).squaredNorm() <= options.range_m * options.range_m;
}

bool is_lost(const RadioOptions& options, std::uint64_t seed, AgentId sender, AgentId receiver, std::uint32_t step,
             std::uint32_t round) {
  if (options.loss <= 0.0) return false;
  // ids take 9 bits and steps 23: one index for each (receiver, step, round)
  const std::uint64_t index =
      (static_cast<std::uint64_t>(receiver) << 55) ^ (static_cast<std::uint64_t>(step) << 32) ^ round;
  return RandomStream(seed, sender, Purpose::RadioLoss, index).uniform() < options.loss;
}

std::uint32_t latency_of(const RadioOptions& options) {
  return static_cast<std::uint32_t>(std::floor(options.latency_rounds));
}

}  // namespace skein
