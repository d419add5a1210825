// Samples and bytes a second over the last two seconds, at times that the caller gives.
//
//   rate(t) = what came in (max(t - W, t0), t] / min(W, t - t0),  W = 1.8 to 2 s, in ten buckets of 0.2 s
// t0 is when the first sample came, which itself counts in no rate: one alone has none.
// Source: none needed. Departs from source: none. Complexity: O(buckets).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace skein::watch {

struct Rate {
  double samples_per_s = 0.0;
  double bytes_per_s = 0.0;
};

class RateMeter {
 public:
  /// @param now_s of any steady clock, not before the last
  void add(double now_s, std::size_t bytes) {
    ++samples_;
    bytes_ += bytes;
    if (!first_s_) {
      first_s_ = now_s;
      return;
    }
    const std::int64_t slot = slot_of(now_s);
    Bucket& bucket = buckets_[static_cast<std::size_t>(slot) % kBuckets];
    if (bucket.slot != slot) bucket = {slot, 0.0, 0.0};
    bucket.samples += 1.0;
    bucket.bytes += static_cast<double>(bytes);
  }
  [[nodiscard]] Rate at(double now_s) const {
    if (!first_s_) return {};
    const std::int64_t slot = slot_of(now_s);
    Rate rate;
    for (const Bucket& bucket : buckets_) {
      if (bucket.slot <= slot - kBuckets || bucket.slot > slot) continue;
      rate.samples_per_s += bucket.samples;
      rate.bytes_per_s += bucket.bytes;
    }
    const double oldest_s = static_cast<double>(slot - kBuckets + 1) * kBucket_s;
    const double window_s = std::max(now_s - std::max(oldest_s, *first_s_), kBucket_s);
    return {rate.samples_per_s / window_s, rate.bytes_per_s / window_s};
  }
  [[nodiscard]] std::uint64_t samples() const { return samples_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

 private:
  struct Bucket {
    std::int64_t slot = -1000;
    double samples = 0.0;
    double bytes = 0.0;
  };
  static constexpr std::int64_t kBuckets = 10;
  static constexpr double kBucket_s = 0.2;
  static std::int64_t slot_of(double t_s) { return static_cast<std::int64_t>(std::floor(t_s / kBucket_s)); }

  std::array<Bucket, kBuckets> buckets_{};
  std::optional<double> first_s_;
  std::uint64_t samples_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace skein::watch
