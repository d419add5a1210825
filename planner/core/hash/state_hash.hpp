// Hash of a state, equal on every machine and over every carrier, so that two runs can be compared round by round.
//
// A 64-bit accumulator: h <- finalise(h xor word) * odd constant, one step per word. Doubles enter by bit pattern, with
// -0 as +0; sequences enter with their length first, so that neighbouring fields cannot be confused.
// Source: the finaliser is that of SplitMix64 (Steele, Lea, Flood 2014). Complexity: O(words).
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "planner/core/geometry/types.hpp"

namespace skein {

class StateHash {
 public:
  /// Starts from a seed word; two hashes with different seeds never meet by construction of their content alone.
  explicit StateHash(std::uint64_t seed = 0x736b65696eULL) : value_(finalise(seed)) {}

  template <typename Integer>
  requires(std::is_integral_v<Integer> || std::is_enum_v<Integer>) StateHash& add(Integer word) {
    value_ = finalise(value_ ^ static_cast<std::uint64_t>(word)) * 0x9e3779b97f4a7c15ULL;
    return *this;
  }
  StateHash& add(double value) { return add(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value)); }
  StateHash& add(std::string_view text) {
    add(text.size());
    for (const char c : text) add(static_cast<unsigned char>(c));
    return *this;
  }
  StateHash& add(std::span<const double> values) {
    add(values.size());
    for (const double value : values) add(value);
    return *this;
  }
  StateHash& add(const Vec2& v) { return add(v.x()).add(v.y()); }
  StateHash& add(const Vec3& v) { return add(v.x()).add(v.y()).add(v.z()); }
  StateHash& add(const Pose& pose) { return add(pose.position_m).add(pose.heading_rad).add(pose.climb_rad); }

  [[nodiscard]] std::uint64_t value() const { return finalise(value_); }

 private:
  static std::uint64_t finalise(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  std::uint64_t value_;
};

}  // namespace skein
