#include "planner/core/random/random_stream.hpp"

#include <Random123/philox.h>

#include <cmath>
#include <stdexcept>

#include "planner/core/math/det_math.hpp"

namespace skein {

RandomStream::RandomStream(std::uint64_t seed, std::uint32_t agent, Purpose purpose, std::uint64_t index)
    : key_{seed, (static_cast<std::uint64_t>(agent) << 32) | static_cast<std::uint64_t>(purpose)}, index_(index) {}

void RandomStream::refill() {
  const r123::Philox4x64::ctr_type counter{{block_++, index_, 0, 0}};
  const r123::Philox4x64::key_type key{{key_[0], key_[1]}};
  const r123::Philox4x64::ctr_type drawn = r123::Philox4x64()(counter, key);
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] = drawn[i];
  used_ = 0;
}

std::uint64_t RandomStream::below(std::uint64_t n) {
  if (n == 0) throw std::invalid_argument("RandomStream::below: n is 0; allowed: 1 and more");
  // Words below 2^64 mod n would make small results likelier; they are drawn again.
  const std::uint64_t rejected = (0 - n) % n;
  std::uint64_t word = next();
  while (word < rejected) word = next();
  return word % n;
}

double RandomStream::normal() {
  const double radius = std::sqrt(-2.0 * math::log(1.0 - uniform()));
  return radius * math::cos(math::kTwoPi * uniform());
}

}  // namespace skein
