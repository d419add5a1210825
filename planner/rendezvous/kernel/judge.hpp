// Elastic energy, and curvature and zones at Np points of equal parameter distance, and the chords between them, in
// lanes.
//
// Everything is compared in squares and products, without roots and quotients:
//   curvature   2 |n| > K sigma^2
//   circle      the chord comes nearer to the centre than r: an end does, or, between them, cross^2 < r^2 |chord|^2
//   rectangle   an end comes nearer than the distance d to be kept, or a corner is nearer to the chord, or the chord
//               crosses the open rectangle (separating axes)
// A zone is left out for blocks of chords, and then for chords, whose bounding box reaches it in no lane of the pack.
//
// Source: papers/001, Eq. 11 and 12. Departs from source: the chords are checked as well.
// Complexity: O(Np zones) a pack.
#pragma once

#include "planner/rendezvous/kernel/interpolate.hpp"
#include "planner/rendezvous/kernel/kernel.hpp"
#include "planner/rendezvous/kernel/lanes.hpp"

namespace skein::rendezvous::kernel {
namespace {

/// A chord from a to b with what all zones need of it.
template <typename Pack>
struct Chord {
  Number<Pack> a;
  Number<Pack> b;
  Number<Pack> along;
  Number<Pack> middle;
  Number<Pack> half;  ///< half the size of its bounding box
  Pack squared;       ///< length squared
};

template <typename Lanes>
Chord<typename Lanes::Pack> chord_between(Number<typename Lanes::Pack> a, Number<typename Lanes::Pack> b) {
  using Pack = typename Lanes::Pack;
  const Number<Pack> along = b - a;
  const Number<Pack> half = scaled(0.5, along);
  return {a, b, along, a + half, {Lanes::magnitude(half.re), Lanes::magnitude(half.im)}, dot(along, along)};
}

/// Whether a place between the chord's ends is nearer to p than the root of `reach_squared`.
template <typename Pack>
auto passes(const Chord<Pack>& chord, Number<Pack> p, double reach_squared) {
  const Number<Pack> to = p - chord.a;
  const Pack forward = dot(to, chord.along);
  const Pack aside = cross(to, chord.along);
  return (forward > 0.0) & (forward < chord.squared) & (aside * aside < reach_squared * chord.squared);
}

/// The bounding box of a chord.
template <typename Lanes>
struct Extent {
  using Pack = typename Lanes::Pack;
  Number<Pack> low;
  Number<Pack> high;

  Extent(Number<Pack> a, Number<Pack> b)
      : low{Lanes::least(a.re, b.re), Lanes::least(a.im, b.im)},
        high{Lanes::most(a.re, b.re), Lanes::most(a.im, b.im)} {}
  auto meets(const Rectangle& box) const {
    return (low.re <= box.x_m + box.half_x_m) & (high.re >= box.x_m - box.half_x_m) &
           (low.im <= box.y_m + box.half_y_m) & (high.im >= box.y_m - box.half_y_m);
  }
};

template <typename Lanes>
auto enters(const Chord<typename Lanes::Pack>& chord, const Circle& circle) {
  using Pack = typename Lanes::Pack;
  const double reach_squared = circle.reach_m * circle.reach_m;
  const Number<Pack> centre{Lanes::all(circle.x_m), Lanes::all(circle.y_m)};
  const Number<Pack> from_a = chord.a - centre;
  const Number<Pack> from_b = chord.b - centre;
  return (dot(from_a, from_a) < reach_squared) | (dot(from_b, from_b) < reach_squared) |
         passes(chord, centre, reach_squared);
}

/// Whether a point is in the open rectangle, or nearer to it than the root of `keep_squared`.
template <typename Lanes>
auto touches(Number<typename Lanes::Pack> p, const Rectangle& box, double keep_squared) {
  using Pack = typename Lanes::Pack;
  const Pack beyond_x = Lanes::magnitude(p.re - box.x_m) - box.half_x_m;
  const Pack beyond_y = Lanes::magnitude(p.im - box.y_m) - box.half_y_m;
  const Pack zero = Lanes::all(0.0);
  const Number<Pack> outside{Lanes::most(beyond_x, zero), Lanes::most(beyond_y, zero)};
  return ((beyond_x < 0.0) & (beyond_y < 0.0)) | (dot(outside, outside) < keep_squared);
}

template <typename Lanes>
auto crosses(const Chord<typename Lanes::Pack>& chord, const Rectangle& box) {
  using Pack = typename Lanes::Pack;
  const Number<Pack> to{chord.middle.re - box.x_m, chord.middle.im - box.y_m};
  const Number<Pack> half = scaled(0.5, chord.along);
  const Pack across = Lanes::magnitude(half.re * to.im - half.im * to.re);
  return (Lanes::magnitude(to.re) < box.half_x_m + chord.half.re) &
         (Lanes::magnitude(to.im) < box.half_y_m + chord.half.im) &
         (across < box.half_x_m * chord.half.im + box.half_y_m * chord.half.re);
}

template <typename Lanes>
auto enters(const Chord<typename Lanes::Pack>& chord, const Rectangle& box, double keep_squared) {
  using Pack = typename Lanes::Pack;
  auto met = touches<Lanes>(chord.a, box, keep_squared) | touches<Lanes>(chord.b, box, keep_squared) |
             crosses<Lanes>(chord, box);
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const double x = box.x_m + (corner < 2 ? -box.half_x_m : box.half_x_m);
    const double y = box.y_m + (corner % 2 == 0 ? -box.half_y_m : box.half_y_m);
    met = met | passes(chord, Number<Pack>{Lanes::all(x), Lanes::all(y)}, keep_squared);
  }
  return met;
}

/// The constraints that lanes of one pack have been seen to violate.
template <typename Lanes>
struct Findings {
  typename Lanes::Mask violated[Verdicts::kConstraints] = {};

  void note(Verdicts::Row kind, typename Lanes::Mask mask) { violated[kind] = violated[kind] | mask; }
  /// Whether all lanes violate it already.
  bool known(Verdicts::Row kind) const { return Lanes::every(violated[kind]); }
};

/// Neighbouring points of a pack of paths: zones beyond the box of all of them need no look at each chord.
template <typename Lanes>
struct Block {
  using Point = Number<typename Lanes::Pack>;
  static constexpr std::size_t kPoints = 8;

  Point points[kPoints];
  std::size_t count = 0;

  Extent<Lanes> extent() const {
    Extent<Lanes> box(points[0], points[1]);
    for (std::size_t k = 2; k < count; ++k) {
      box.low = {Lanes::least(box.low.re, points[k].re), Lanes::least(box.low.im, points[k].im)};
      box.high = {Lanes::most(box.high.re, points[k].re), Lanes::most(box.high.im, points[k].im)};
    }
    return box;
  }
};

/// Notes where chords of the block enter a zone within the box about (x, y).
template <typename Lanes, typename Enters>
void check_chords(const Block<Lanes>& block, const Rectangle& box, Findings<Lanes>& findings, const Enters& enters) {
  for (std::size_t k = 1; k < block.count && !findings.known(box.kind); ++k) {
    const auto near = Extent<Lanes>(block.points[k - 1], block.points[k]).meets(box);
    if (!Lanes::any(near)) continue;
    findings.note(box.kind, near & enters(chord_between<Lanes>(block.points[k - 1], block.points[k])));
  }
}

template <typename Lanes>
void check_zones(const Block<Lanes>& block, const Rules& rules, Findings<Lanes>& findings) {
  const Extent<Lanes> extent = block.extent();
  for (std::size_t i = 0; i < rules.circle_count; ++i) {
    const Circle& circle = rules.circles[i];
    const Rectangle box{circle.x_m, circle.y_m, circle.reach_m, circle.reach_m, circle.kind};
    if (!Lanes::any(extent.meets(box))) continue;
    check_chords(block, box, findings, [&](const auto& chord) { return enters<Lanes>(chord, circle); });
  }
  const double keep_m = rules.keep_out_m;
  for (std::size_t i = 0; i < rules.rectangle_count; ++i) {
    const Rectangle& inner = rules.rectangles[i];
    const Rectangle box{inner.x_m, inner.y_m, inner.half_x_m + keep_m, inner.half_y_m + keep_m, inner.kind};
    if (!Lanes::any(extent.meets(box))) continue;
    check_chords(block, box, findings, [&](const auto& chord) { return enters<Lanes>(chord, inner, keep_m * keep_m); });
  }
}

template <typename Lanes>
void judge(ConstTable paths, const Rules& rules, std::size_t lanes, Table verdicts) {
  using Pack = typename Lanes::Pack;
  const std::size_t stride = paths.stride;
  for (std::size_t l = 0; l < lanes; l += Lanes::kWidth) {
    const double* path = paths.data + l;
    const auto row = [&](std::size_t r) { return Lanes::load(path + r * stride); };
    const Number<Pack> start{row(Paths::Start), row(Paths::Start + 1)};
    Powers<Pack> powers;
    for (std::size_t k = 0; k < 5; ++k) powers.speed[k] = row(Paths::Speed + k);
    for (std::size_t k = 0; k < 3; ++k) powers.bend[k] = row(Paths::Bend + k);
    Lanes::store(verdicts.data + Verdicts::Energy * verdicts.stride + l, energy_of<Lanes>(powers));
    Findings<Lanes> findings;
    Block<Lanes> block;
    for (std::size_t k = 0; k < rules.place_count; ++k) {
      const double q = rules.places[k];
      const Pack place = Lanes::all(q);
      const Pack sigma = quartic<Lanes>(path + Paths::Speed * stride, stride, place);
      const Pack bend = row(Paths::Bend) + q * (row(Paths::Bend + 1) + q * row(Paths::Bend + 2));
      findings.note(Verdicts::Unflyable, 2.0 * Lanes::magnitude(bend) > rules.max_curvature_per_m * (sigma * sigma));
      const Number<Pack> here{start.re + q * quartic<Lanes>(path + Paths::Place * stride, stride, place),
                              start.im + q * quartic<Lanes>(path + (Paths::Place + 5) * stride, stride, place)};
      block.points[block.count++] = here;
      if (block.count < Block<Lanes>::kPoints && k + 1 < rules.place_count) continue;
      if (block.count > 1) check_zones(block, rules, findings);
      block.points[0] = here;  // the next block begins where this one ends
      block.count = 1;
    }
    for (std::size_t r = 0; r < Verdicts::kPlanarConstraints; ++r) {
      Lanes::store(verdicts.data + r * verdicts.stride + l, findings.violated[r] ? Lanes::all(1.0) : Lanes::all(0.0));
    }
  }
}

}  // namespace
}  // namespace skein::rendezvous::kernel
