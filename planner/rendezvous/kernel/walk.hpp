// Points of equal arc distance along paths, in lanes: a fixed number of Newton-Raphson steps from point to point.
//
// The parameter of the next point starts at that of the point before. The first step follows Halley's rule,
//   dq = h / (1 + sigma' h / (2 sigma)),  h = (s_k - s(q)) / sigma,
// the next ones Newton's. No lane leaves early, so all lanes take the same operations. Arc length is monotone in q, so
// there is one solution and a small residual proves it. Lanes that still miss, near a cusp or where the speed rises
// steeply, take bracketed steps more, which leave the others as they are. With fewer than kLeastGaps gaps each is
// walked in parts of at most that size.
//
// Source: papers/001, section 3.2.3 (Newton-Raphson). Departs from source: fixed steps, warm start, Halley's first.
// Complexity: O(max(points, kLeastGaps)) a pack.
#pragma once

#include "planner/rendezvous/kernel/kernel.hpp"
#include "planner/rendezvous/kernel/lanes.hpp"

namespace skein::rendezvous::kernel {
namespace {

/// Rows that do not depend on the number of coordinates.
using Common = PathRows<2>;

constexpr std::size_t kLeastGaps = 49;
/// Newton's steps after Halley's, for gaps of kLeastGaps and for finer ones.
constexpr int kNewtonSteps = 2;
constexpr int kFineNewtonSteps = 1;
constexpr double kFineGaps = 400.0;
/// Part of the length by which the last but one step may miss; the last one squares it.
constexpr double kArcTolerance = 1e-7;
constexpr int kMostSteps = 60;  ///< of those few lanes that need more

/// Arc length and speed of the paths of one pack, by parameter.
template <typename Lanes>
struct Walker {
  using Pack = typename Lanes::Pack;
  using Mask = typename Lanes::Mask;

  const double* path;
  std::size_t stride;

  Pack row(std::size_t r) const { return Lanes::load(path + r * stride); }
  Pack arc(Pack q) const { return q * wide_quartic(Common::S, q); }
  Pack speed(Pack q) const { return wide_quartic(Common::Speed, q); }
  /// A quartic in pairs of terms: a shorter chain of dependent operations than Horner's.
  Pack wide_quartic(std::size_t r, Pack q) const {
    const Pack squared = q * q;
    return (row(r) + q * row(r + 1)) + squared * ((row(r + 2) + q * row(r + 3)) + squared * row(r + 4));
  }
  /// d speed / dq
  Pack slope(Pack q) const {
    const Pack cubic = 3.0 * row(Common::Speed + 3) + q * (4.0 * row(Common::Speed + 4));
    return row(Common::Speed + 1) + q * (2.0 * row(Common::Speed + 2) + q * cubic);
  }
  Pack tolerance() const { return kArcTolerance * row(Common::Length); }

  /// From `before` towards arc length s.
  Pack halley(Pack s, Pack before) const {
    const Pack sigma = speed(before);
    const Pack missing = s - arc(before);
    return before + missing * sigma / (sigma * sigma + 0.5 * slope(before) * missing);
  }

  /// For the lanes of `open`: Newton's steps within a bracket that bisection narrows where they would leave it.
  Pack narrowed(Pack s, Pack before, Pack q, Mask open) const {
    Pack low = before;
    Pack high = Lanes::all(1.0);
    q = open ? Lanes::most(Lanes::least(q, high), low) : q;  // a number, whatever it was
    for (int i = 0; i < kMostSteps && Lanes::any(open); ++i) {
      const Pack excess = arc(q) - s;
      low = excess > 0.0 ? low : q;
      high = excess > 0.0 ? q : high;
      const Pack next = q - excess / speed(q);
      const Mask inside = (next >= low) & (next <= high);
      const Mask done = Lanes::magnitude(excess) <= tolerance();
      const Pack halved = done ? q : 0.5 * (low + high);
      const Pack moved = inside ? next : halved;
      q = open ? moved : q;
      open = open & !done;
    }
    return q;
  }
};

/// Several packs, whose chains of dependent steps overlap: each step of all, then the next one.
template <typename Lanes, std::size_t kPacks>
struct Walkers {
  using Pack = typename Lanes::Pack;

  const double* path;
  std::size_t stride;
  Pack q[kPacks];

  Walker<Lanes> of(std::size_t p) const { return {path + p * Lanes::kWidth, stride}; }

  /// To arc length s of each pack.
  void advance(const Pack (&s)[kPacks], int newton_steps) {
    Pack before[kPacks];
    Pack excess[kPacks];
    for (std::size_t p = 0; p < kPacks; ++p) {
      before[p] = q[p];
      q[p] = of(p).halley(s[p], before[p]);
    }
    for (int i = 0; i < newton_steps; ++i) {
      for (std::size_t p = 0; p < kPacks; ++p) {
        excess[p] = of(p).arc(q[p]) - s[p];
        q[p] = q[p] - excess[p] / of(p).speed(q[p]);
      }
    }
    for (std::size_t p = 0; p < kPacks; ++p) {
      const typename Lanes::Mask open = !(Lanes::magnitude(excess[p]) <= of(p).tolerance());
      if (Lanes::any(open)) q[p] = of(p).narrowed(s[p], before[p], q[p], open);
    }
  }

  /// From the start of each path to arc length s, wherever that is.
  void jump(const Pack (&s)[kPacks]) {
    for (std::size_t p = 0; p < kPacks; ++p) {
      const Pack zero = Lanes::all(0.0);
      const Pack length = of(p).row(Common::Length);
      q[p] = of(p).narrowed(s[p], zero, s[p] / length, s[p] > 0.0);
    }
  }
};

template <typename Rows, typename Lanes, std::size_t kPacks>
void walk_packs(const double* path, std::size_t stride, const Stretch& stretch, Table points_m) {
  using Pack = typename Lanes::Pack;
  const std::size_t parts = (kLeastGaps + stretch.gaps - 1) / stretch.gaps;
  const double gaps = static_cast<double>(stretch.gaps * parts);
  const int newton_steps = gaps < kFineGaps ? kNewtonSteps : kFineNewtonSteps;
  Walkers<Lanes, kPacks> walkers{path, stride, {}};
  Pack first[kPacks];
  Pack gap[kPacks];
  Pack passed[kPacks];
  Pack s[kPacks];
  for (std::size_t p = 0; p < kPacks; ++p) {
    first[p] = walkers.of(p).row(Common::First) * static_cast<double>(parts);
    gap[p] = walkers.of(p).row(Common::Length) / gaps;
  }
  const auto aim = [&](std::size_t steps) {
    for (std::size_t p = 0; p < kPacks; ++p) {
      passed[p] = first[p] + static_cast<double>(steps);
      s[p] = gap[p] * passed[p];
    }
  };
  aim(0);
  walkers.jump(s);
  for (std::size_t k = 0; k < stretch.points; ++k) {
    for (std::size_t part = 1; k > 0 && part <= parts; ++part) {
      aim((k - 1) * parts + part);
      walkers.advance(s, newton_steps);
    }
    for (std::size_t p = 0; p < kPacks; ++p) {
      const Walker<Lanes> of = walkers.of(p);
      const Pack q = passed[p] < gaps ? walkers.q[p] : Lanes::all(1.0);
      double* to = points_m.data + k * points_m.stride + p * Lanes::kWidth;
      for (std::size_t axis = 0; axis < Rows::kDimensions; ++axis) {
        const double* place = of.path + (Rows::Place + 5 * axis) * stride;
        const Pack at = of.row(Rows::Start + axis) + q * quartic<Lanes>(place, stride, q);
        Lanes::store(to + axis * stretch.points * points_m.stride, at);
      }
    }
  }
}

/// `packs` packs, at most kPacks, all in turn.
template <typename Rows, typename Lanes, std::size_t kPacks>
void walk_together(std::size_t packs, const double* path, std::size_t stride, const Stretch& stretch, Table points_m) {
  if (packs == kPacks) return walk_packs<Rows, Lanes, kPacks>(path, stride, stretch, points_m);
  if constexpr (kPacks > 1) walk_together<Rows, Lanes, kPacks - 1>(packs, path, stride, stretch, points_m);
}

/// `Rows`: Paths or SpatialPaths.
template <typename Rows, typename Lanes>
void walk(ConstTable paths, const Stretch& stretch, std::size_t lanes, Table points_m) {
  constexpr std::size_t kMost = Lanes::kInterleaved;
  for (std::size_t l = 0; l < lanes;) {
    const std::size_t packs = (lanes - l + Lanes::kWidth - 1) / Lanes::kWidth;
    const std::size_t turns =
        (packs + kMost - 1) / kMost;  // of about as many packs each: one alone would wait for itself
    const std::size_t now = (packs + turns - 1) / turns;
    walk_together<Rows, Lanes, kMost>(now, paths.data + l, paths.stride, stretch, {points_m.data + l, points_m.stride});
    l += now * Lanes::kWidth;
  }
}

}  // namespace
}  // namespace skein::rendezvous::kernel
