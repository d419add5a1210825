// From controls to path in space: SpatialHermite::path and SpatialPath's construction and elastic energy, in lanes.
//
// Source: ph/spatial_hermite.hpp, ph/spatial_path.hpp. Departs from source: as interpolate.hpp.
// Complexity: O(1) a pack.
#pragma once

#include "planner/rendezvous/kernel/interpolate.hpp"
#include "planner/rendezvous/kernel/kernel.hpp"
#include "planner/rendezvous/kernel/lanes.hpp"

namespace skein::rendezvous::kernel {
namespace {

/// Part of its terms below which the numerator of the torsion is rounding alone: the path lies in a plane.
constexpr double kPlane = 1e-12;

template <typename Pack>
struct SpatialPreimages {
  Triple<Pack> a0;
  Triple<Pack> a1;
  Triple<Pack> a2;
};

/// By powers of q: a, speed, b, |b|^2 and N of ph/spatial_path.hpp.
template <typename Pack>
struct SpatialPowers {
  Triple<Pack> p[3];
  Pack speed[5];
  Number<Pack> bend[3];
  Pack bend_squared[5];
  Pack twist[7];
};

/// a with 2 a1 a - |a|^2 e1 = v and a1 not negative.
template <typename Lanes>
Triple<typename Lanes::Pack> root_of(Triple<typename Lanes::Pack> v) {
  using Pack = typename Lanes::Pack;
  const Pack zero = Lanes::all(0.0);
  const Pack modulus = Lanes::root(dot(v, v));
  const Pack larger = Lanes::root(0.5 * (modulus + Lanes::magnitude(v.x)));
  const Pack across = Lanes::root(v.y * v.y + v.z * v.z);
  const auto ahead = v.x >= 0.0;
  const auto straight = across == 0.0;
  const Pack turned_y = straight ? larger : larger * v.y / across;
  const Pack turned_z = straight ? zero : larger * v.z / across;
  const Pack turned_x = straight ? zero : 0.5 * across / larger;
  const Pack x = ahead ? larger : turned_x;
  const Pack y = ahead ? 0.5 * v.y / larger : turned_y;
  const Pack z = ahead ? 0.5 * v.z / larger : turned_z;
  const auto nothing = modulus == 0.0;
  return {nothing ? zero : x, nothing ? zero : y, nothing ? zero : z};
}

/// (x u y* + y u x*) / 2, u the first axis.
template <typename Pack>
Triple<Pack> product(Triple<Pack> x, Triple<Pack> y) {
  return {x.x * y.x - x.y * y.y - x.z * y.z, x.x * y.y + x.y * y.x, x.x * y.z + x.z * y.x};
}

template <typename Pack>
Triple<Pack> square_of(Triple<Pack> a) {
  const Pack twice = 2.0 * a.x;
  return {twice * a.x - dot(a, a), twice * a.y, twice * a.z};
}

template <typename Lanes>
SpatialPreimages<typename Lanes::Pack> solution_in_space(typename Lanes::Pack chord, Triple<typename Lanes::Pack> a0,
                                                         Triple<typename Lanes::Pack> a2, double root_sign) {
  using Pack = typename Lanes::Pack;
  const Pack zero = Lanes::all(0.0);
  const Pack twice_dot = 2.0 * dot(a0, a2);
  const Triple<Pack> both{2.0 * (a0.x * a2.x + a2.x * a0.x) - twice_dot, 2.0 * (a0.x * a2.y + a2.x * a0.y),
                          2.0 * (a0.x * a2.z + a2.x * a0.z)};
  const Triple<Pack> whole{120.0 * chord, zero, zero};
  const Triple<Pack> d = whole - scaled(15.0, square_of(a0) + square_of(a2)) + scaled(5.0, both);
  return {a0, scaled(0.25, scaled(root_sign, root_of<Lanes>(d)) - scaled(3.0, a0 + a2)), a2};
}

/// The torsion's numerator N = c sigma - 2 n1 |b|^2, or 0 where it is rounding alone.
template <typename Lanes>
void set_twist(const SpatialPreimages<typename Lanes::Pack>& a, const Triple<typename Lanes::Pack> (&n)[3],
               SpatialPowers<typename Lanes::Pack>& p) {
  using Pack = typename Lanes::Pack;
  const Pack turn[3] = {cross(p.bend[0], p.bend[1]), 2.0 * cross(p.bend[0], p.bend[2]), cross(p.bend[1], p.bend[2])};
  for (Pack& t : p.twist) t = Lanes::all(0.0);
  for (std::size_t j = 0; j < 5; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      p.twist[i + j] = p.twist[i + j] + (turn[i] * p.speed[j] - 2.0 * n[i].x * p.bend_squared[j]);
    }
  }
  Pack largest = Lanes::all(0.0);
  for (const Pack& t : p.twist) largest = Lanes::most(largest, Lanes::magnitude(t));
  Pack largest_bend = Lanes::all(0.0);
  for (const Number<Pack>& b : p.bend) largest_bend = Lanes::most(largest_bend, dot(b, b));
  const Pack size = Lanes::most(Lanes::most(dot(a.a0, a.a0), dot(a.a1, a.a1)), dot(a.a2, a.a2));
  const auto flat = largest <= kPlane * size * size * Lanes::root(largest_bend);
  for (Pack& t : p.twist) t = flat ? Lanes::all(0.0) : t;
}

template <typename Lanes>
SpatialPowers<typename Lanes::Pack> spatial_powers_of(const SpatialPreimages<typename Lanes::Pack>& a) {
  using Pack = typename Lanes::Pack;
  SpatialPowers<Pack> p;
  const Triple<Pack> p0 = a.a0;
  const Triple<Pack> p1 = scaled(2.0, a.a1 - a.a0);
  const Triple<Pack> p2 = a.a0 - scaled(2.0, a.a1) + a.a2;
  p.p[0] = p0;
  p.p[1] = p1;
  p.p[2] = p2;
  p.speed[0] = dot(p0, p0);
  p.speed[1] = 2.0 * dot(p0, p1);
  p.speed[2] = dot(p1, p1) + 2.0 * dot(p0, p2);
  p.speed[3] = 2.0 * dot(p1, p2);
  p.speed[4] = dot(p2, p2);
  const Triple<Pack> n[3] = {cross(p0, p1), scaled(2.0, cross(p0, p2)), cross(p1, p2)};
  for (std::size_t k = 0; k < 3; ++k) p.bend[k] = {n[k].y, n[k].z};
  for (Pack& b : p.bend_squared) b = Lanes::all(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) p.bend_squared[i + j] = p.bend_squared[i + j] + dot(p.bend[i], p.bend[j]);
  }
  set_twist<Lanes>(a, n, p);
  return p;
}

template <typename Lanes>
typename Lanes::Pack spatial_density(const SpatialPowers<typename Lanes::Pack>& p, double q) {
  using Pack = typename Lanes::Pack;
  const Pack sigma = p.speed[0] + q * (p.speed[1] + q * (p.speed[2] + q * (p.speed[3] + q * p.speed[4])));
  const Number<Pack> bend = p.bend[0] + scaled(q, p.bend[1] + scaled(q, p.bend[2]));
  const Pack squared = dot(bend, bend);
  Pack twist = p.twist[6];
  for (std::size_t k = 6; k-- > 0;) twist = p.twist[k] + q * twist;
  const Pack torsion = twist == 0.0 ? Lanes::all(0.0) : 0.5 * twist / squared;
  return (squared + torsion * torsion) / (sigma * sigma * sigma);
}

template <typename Lanes>
typename Lanes::Pack spatial_energy_of(const SpatialPowers<typename Lanes::Pack>& p) {
  typename Lanes::Pack sum = Lanes::all(0.0);
  for (std::size_t i = 0; i < 8; ++i) {
    sum = sum + kWeights[i] * (spatial_density<Lanes>(p, 0.5 - 0.5 * kNodes[i]) +
                               spatial_density<Lanes>(p, 0.5 + 0.5 * kNodes[i]));
  }
  return 2.0 * sum;
}

template <typename Pack>
Pack length_of(const SpatialPreimages<Pack>& a) {
  const Pack middle = (2.0 * dot(a.a1, a.a1) + dot(a.a0, a.a2)) / 3.0;
  return (dot(a.a0, a.a0) + dot(a.a0, a.a1) + middle + dot(a.a1, a.a2) + dot(a.a2, a.a2)) / 5.0;
}

template <typename Lanes>
Triple<typename Lanes::Pack> load_triple(const double* rows, std::size_t stride) {
  return {Lanes::load(rows), Lanes::load(rows + stride), Lanes::load(rows + 2 * stride)};
}

template <typename Pack, typename Mask>
Triple<Pack> chosen(Mask mask, Triple<Pack> a, Triple<Pack> b) {
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

template <typename Pack>
Triple<Pack> times(Pack k, Triple<Pack> a) {
  return {k * a.x, k * a.y, k * a.z};
}

template <typename Lanes>
SpatialPreimages<typename Lanes::Pack> in_space(const double* ends, std::size_t stride, typename Lanes::Pack m0,
                                                typename Lanes::Pack m1) {
  using Pack = typename Lanes::Pack;
  const auto triple = [&](std::size_t r) { return load_triple<Lanes>(ends + r * stride, stride); };
  const Triple<Pack> a0 = times(Lanes::root(m0), triple(SpatialEnds::HalfStart));
  const Triple<Pack> a2 = times(Lanes::root(m1), triple(SpatialEnds::HalfEnd));
  const Pack chord = Lanes::load(ends + SpatialEnds::Chord * stride);
  SpatialPreimages<Pack> best = solution_in_space<Lanes>(chord, a0, a2, 1.0);
  const auto backward = Lanes::load(ends + SpatialEnds::Forward * stride) == 0.0;
  if (!Lanes::any(backward)) return best;
  Pack least_energy = spatial_energy_of<Lanes>(spatial_powers_of<Lanes>(best));
  const Triple<Pack> opposite = scaled(-1.0, a2);
  for (int i = 1; i < 4; ++i) {
    const SpatialPreimages<Pack> other =
        solution_in_space<Lanes>(chord, a0, i == 1 ? a2 : opposite, i == 2 ? 1.0 : -1.0);
    const Pack energy = spatial_energy_of<Lanes>(spatial_powers_of<Lanes>(other));
    const auto better = backward & (energy < least_energy);
    least_energy = better ? energy : least_energy;
    best.a1 = chosen(better, other.a1, best.a1);
    best.a2 = chosen(better, other.a2, best.a2);
  }
  return best;
}

/// Coefficients of position in world coordinates.
template <typename Lanes>
void store_places(const SpatialPowers<typename Lanes::Pack>& p, const double* ends, std::size_t ends_stride,
                  double* path, std::size_t stride) {
  using Pack = typename Lanes::Pack;
  const Triple<Pack> hodograph[5] = {product(p.p[0], p.p[0]), scaled(2.0, product(p.p[0], p.p[1])),
                                     product(p.p[1], p.p[1]) + scaled(2.0, product(p.p[0], p.p[2])),
                                     scaled(2.0, product(p.p[1], p.p[2])), product(p.p[2], p.p[2])};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto row = [&](std::size_t r) { return Lanes::load(ends + (r + axis) * ends_stride); };
    for (std::size_t k = 0; k < 5; ++k) {
      const Triple<Pack>& h = hodograph[k];
      const Pack world = h.x * row(SpatialEnds::Along) + h.y * row(SpatialEnds::Left) + h.z * row(SpatialEnds::Up);
      Lanes::store(path + (SpatialPaths::Place + 5 * axis + k) * stride, world / static_cast<double>(k + 1));
    }
    Lanes::store(path + (SpatialPaths::Start + axis) * stride, row(SpatialEnds::Start));
  }
}

template <typename Lanes>
void interpolate_in_space(ConstTable ends, const double* m0_m, const double* m1_m, std::size_t lanes, Table paths) {
  using Pack = typename Lanes::Pack;
  for (std::size_t l = 0; l < lanes; l += Lanes::kWidth) {
    const auto a = in_space<Lanes>(ends.data + l, ends.stride, Lanes::load(m0_m + l), Lanes::load(m1_m + l));
    const SpatialPowers<Pack> p = spatial_powers_of<Lanes>(a);
    double* path = paths.data + l;
    const auto put = [&](std::size_t row, Pack value) { Lanes::store(path + row * paths.stride, value); };
    store_places<Lanes>(p, ends.data + l, ends.stride, path, paths.stride);
    for (std::size_t k = 0; k < 5; ++k) {
      put(SpatialPaths::S + k, p.speed[k] / static_cast<double>(k + 1));
      put(SpatialPaths::Speed + k, p.speed[k]);
      put(SpatialPaths::BendSquared + k, p.bend_squared[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      put(SpatialPaths::Bend + k, p.bend[k].re);
      put(SpatialPaths::Bend + 3 + k, p.bend[k].im);
    }
    for (std::size_t k = 0; k < 7; ++k) put(SpatialPaths::Twist + k, p.twist[k]);
    put(SpatialPaths::Length, length_of(a));
    put(SpatialPaths::First, Lanes::all(0.0));
  }
}

template <typename Lanes>
void measure_in_space(ConstTable ends, const double* m0_m, const double* m1_m, std::size_t lanes, double* length_m) {
  for (std::size_t l = 0; l < lanes; l += Lanes::kWidth) {
    const auto a = in_space<Lanes>(ends.data + l, ends.stride, Lanes::load(m0_m + l), Lanes::load(m1_m + l));
    Lanes::store(length_m + l, length_of(a));
  }
}

}  // namespace
}  // namespace skein::rendezvous::kernel
