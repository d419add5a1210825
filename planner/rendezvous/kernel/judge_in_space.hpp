// Elastic energy, and curvature, torsion, zones and terrain at Np points of equal parameter distance, and the chords
// between them, in lanes.
//
// Compared without roots and quotients:
//   curvature   4 |b|^2 > K^2 sigma^4
//   torsion     |N| > T sigma^2 |b|^2
// A chord whose bounding box meets that of a zone, and a point below the terrain's roof, are handed lane by lane to the
// functions of the rules: few are.
//
// Source: papers/001, Eq. 11-13. Departs from source: the chords are checked as well.
// Complexity: O(Np zones) a pack.
#pragma once

#include "planner/rendezvous/kernel/interpolate_in_space.hpp"
#include "planner/rendezvous/kernel/judge.hpp"

namespace skein::rendezvous::kernel {
namespace {

/// One pack at two neighbouring points.
template <typename Lanes>
struct Move {
  using Pack = typename Lanes::Pack;
  using Mask = typename Lanes::Mask;

  Triple<Pack> a;
  Triple<Pack> b;

  /// Lanes whose chord's box meets the volume's.
  Mask meets(const Volume& v) const {
    return (Lanes::least(a.x, b.x) <= v.x_m + v.half_x_m) & (Lanes::most(a.x, b.x) >= v.x_m - v.half_x_m) &
           (Lanes::least(a.y, b.y) <= v.y_m + v.half_y_m) & (Lanes::most(a.y, b.y) >= v.y_m - v.half_y_m) &
           (Lanes::least(a.z, b.z) <= v.z_max_m) & (Lanes::most(a.z, b.z) >= v.z_min_m);
  }
};

template <typename Lanes>
void store_triple(double (&to)[3][Lanes::kWidth], const Triple<typename Lanes::Pack>& from) {
  Lanes::store(to[0], from.x);
  Lanes::store(to[1], from.y);
  Lanes::store(to[2], from.z);
}

/// The lanes of `near` for which `is_so(lane)` holds.
template <typename Lanes, typename Test>
typename Lanes::Mask each_of(typename Lanes::Mask near, const Test& is_so) {
  double found[Lanes::kWidth] = {};
  for (unsigned left = Lanes::bits(near); left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
    if (is_so(lane)) found[lane] = 1.0;
  }
  return Lanes::load(found) > 0.0;
}

template <typename Lanes>
void check_volumes(const Move<Lanes>& move, const SpatialRules& rules, Findings<Lanes>& findings) {
  for (std::size_t i = 0; i < rules.volume_count; ++i) {
    const Verdicts::Row kind = rules.volumes[i].kind;
    const auto near = move.meets(rules.volumes[i]);
    if (!Lanes::any(near) || findings.known(kind)) continue;
    double a[3][Lanes::kWidth];
    double b[3][Lanes::kWidth];
    store_triple<Lanes>(a, move.a);
    store_triple<Lanes>(b, move.b);
    findings.note(kind, each_of<Lanes>(near, [&](std::size_t lane) {
                    const double from[3] = {a[0][lane], a[1][lane], a[2][lane]};
                    const double to[3] = {b[0][lane], b[1][lane], b[2][lane]};
                    return rules.enters(rules.context, i, from, to);
                  }));
  }
}

template <typename Lanes>
void check_terrain(const Triple<typename Lanes::Pack>& here, const SpatialRules& rules, Findings<Lanes>& findings) {
  const auto near = here.z < rules.terrain_roof_m;
  if (!Lanes::any(near) || findings.known(Verdicts::Terrain)) return;
  double p[3][Lanes::kWidth];
  store_triple<Lanes>(p, here);
  findings.note(Verdicts::Terrain, each_of<Lanes>(near, [&](std::size_t lane) {
                  const double at[3] = {p[0][lane], p[1][lane], p[2][lane]};
                  return rules.is_low(rules.context, at);
                }));
}

/// The rows of one pack of paths.
template <typename Lanes>
struct SpatialView {
  using Pack = typename Lanes::Pack;

  const double* path;
  std::size_t stride;

  Pack row(std::size_t r) const { return Lanes::load(path + r * stride); }
  Pack speed(Pack q) const { return quartic<Lanes>(path + SpatialPaths::Speed * stride, stride, q); }
  Pack coordinate(std::size_t axis, Pack q) const {
    return row(SpatialPaths::Start + axis) +
           q * quartic<Lanes>(path + (SpatialPaths::Place + 5 * axis) * stride, stride, q);
  }
  Triple<Pack> position(Pack q) const { return {coordinate(0, q), coordinate(1, q), coordinate(2, q)}; }
  /// |b|^2
  Pack bend_squared(double q) const {
    const auto component = [&](std::size_t r) { return row(r) + q * (row(r + 1) + q * row(r + 2)); };
    const Number<Pack> bend{component(SpatialPaths::Bend), component(SpatialPaths::Bend + 3)};
    return dot(bend, bend);
  }
  Pack twist(double q) const {
    Pack value = row(SpatialPaths::Twist + 6);
    for (std::size_t k = 6; k-- > 0;) value = row(SpatialPaths::Twist + k) + q * value;
    return value;
  }
  SpatialPowers<Pack> powers() const {
    SpatialPowers<Pack> p{};
    for (std::size_t k = 0; k < 5; ++k) p.speed[k] = row(SpatialPaths::Speed + k);
    for (std::size_t k = 0; k < 3; ++k) p.bend[k] = {row(SpatialPaths::Bend + k), row(SpatialPaths::Bend + 3 + k)};
    for (std::size_t k = 0; k < 7; ++k) p.twist[k] = row(SpatialPaths::Twist + k);
    return p;
  }
};

template <typename Lanes>
void judge_in_space(ConstTable paths, const Rules& rules, std::size_t lanes, Table verdicts) {
  using Pack = typename Lanes::Pack;
  for (std::size_t l = 0; l < lanes; l += Lanes::kWidth) {
    const SpatialView<Lanes> path{paths.data + l, paths.stride};
    const Pack energy = spatial_energy_of<Lanes>(path.powers());
    Lanes::store(verdicts.data + Verdicts::Energy * verdicts.stride + l, energy);
    Findings<Lanes> findings;
    Triple<Pack> before{};
    for (std::size_t k = 0; k < rules.place_count; ++k) {
      const double q = rules.places[k];
      const Pack sigma = path.speed(Lanes::all(q));
      const Pack squared = sigma * sigma;
      const Pack bend = path.bend_squared(q);
      const Pack bound = rules.max_curvature_per_m * squared;
      findings.note(Verdicts::Unflyable, 4.0 * bend > bound * bound);
      findings.note(Verdicts::Twisted,
                    Lanes::magnitude(path.twist(q)) > rules.spatial.max_torsion_per_m * (squared * bend));
      const Triple<Pack> here = path.position(Lanes::all(q));
      check_terrain<Lanes>(here, rules.spatial, findings);
      if (k > 0) check_volumes<Lanes>({before, here}, rules.spatial, findings);
      before = here;
    }
    for (std::size_t r = 0; r < Verdicts::kConstraints; ++r) {
      Lanes::store(verdicts.data + r * verdicts.stride + l, findings.violated[r] ? Lanes::all(1.0) : Lanes::all(0.0));
    }
  }
}

}  // namespace
}  // namespace skein::rendezvous::kernel
