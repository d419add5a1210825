// From controls to path: Hermite::path and PlanarPath's construction and elastic energy, in lanes, bit for bit.
//
// Source: ph/hermite.hpp, ph/planar_path.hpp. Departs from source: all four interpolants are computed when a lane of
// the pack needs them, and the one of least energy is selected. Complexity: O(1) a pack.
#pragma once

#include "planner/rendezvous/kernel/kernel.hpp"
#include "planner/rendezvous/kernel/lanes.hpp"

namespace skein::rendezvous::kernel {
namespace {

/// Nodes and weights of Gauss-Legendre quadrature, 16 points, on [-1, 1]: the positive half.
constexpr double kNodes[8] = {0.0950125098376374402, 0.2816035507792589132, 0.4580167776572273863,
                              0.6178762444026437484, 0.7554044083550030339, 0.8656312023878317439,
                              0.9445750230732325761, 0.9894009349916499326};
constexpr double kWeights[8] = {0.1894506104550684963, 0.1826034150449235889, 0.1691565193950025382,
                                0.1495959888165767321, 0.1246289712555338720, 0.0951585116824927848,
                                0.0622535239386478929, 0.0271524594117540949};

template <typename Pack>
struct Preimages {
  Number<Pack> w0;
  Number<Pack> w1;
  Number<Pack> w2;
};

/// By powers: w = a + b q + c q^2; speed and the numerator of curvature.
template <typename Pack>
struct Powers {
  Number<Pack> a;
  Number<Pack> b;
  Number<Pack> c;
  Pack speed[5];
  Pack bend[3];
};

template <typename Lanes>
Number<typename Lanes::Pack> square_root(Number<typename Lanes::Pack> z) {
  using Pack = typename Lanes::Pack;
  const Pack modulus = Lanes::root(z.re * z.re + z.im * z.im);
  const Pack larger = Lanes::root(0.5 * (modulus + Lanes::magnitude(z.re)));
  const Pack smaller = 0.5 * Lanes::magnitude(z.im) / larger;
  const Pack one = Lanes::all(1.0);
  const Pack sign = z.im < 0.0 ? -one : one;
  const Pack re = z.re >= 0.0 ? larger : smaller;
  const Pack im = z.re >= 0.0 ? sign * smaller : sign * larger;
  const Pack zero = Lanes::all(0.0);
  return {modulus == 0.0 ? zero : re, modulus == 0.0 ? zero : im};
}

template <typename Lanes>
Preimages<typename Lanes::Pack> solution(typename Lanes::Pack chord, Number<typename Lanes::Pack> w0,
                                         Number<typename Lanes::Pack> w2, double root_sign) {
  using Pack = typename Lanes::Pack;
  const Number<Pack> whole{120.0 * chord, Lanes::all(0.0)};
  const Number<Pack> radicand = whole - scaled(15.0, w0 * w0) - scaled(15.0, w2 * w2) + scaled(10.0, w0 * w2);
  const Number<Pack> root = square_root<Lanes>(radicand);
  return {w0, scaled(0.25, scaled(root_sign, root) - scaled(3.0, w0 + w2)), w2};
}

template <typename Pack>
Powers<Pack> powers_of(const Preimages<Pack>& w) {
  Powers<Pack> p;
  p.a = w.w0;
  p.b = scaled(2.0, w.w1 - w.w0);
  p.c = w.w0 - scaled(2.0, w.w1) + w.w2;
  p.speed[0] = dot(p.a, p.a);
  p.speed[1] = 2.0 * dot(p.a, p.b);
  p.speed[2] = dot(p.b, p.b) + 2.0 * dot(p.a, p.c);
  p.speed[3] = 2.0 * dot(p.b, p.c);
  p.speed[4] = dot(p.c, p.c);
  p.bend[0] = cross(p.a, p.b);
  p.bend[1] = 2.0 * cross(p.a, p.c);
  p.bend[2] = cross(p.b, p.c);
  return p;
}

template <typename Pack>
Pack energy_density(const Powers<Pack>& p, double q) {
  const Pack sigma = p.speed[0] + q * (p.speed[1] + q * (p.speed[2] + q * (p.speed[3] + q * p.speed[4])));
  const Pack bend = p.bend[0] + q * (p.bend[1] + q * p.bend[2]);
  return bend * bend / (sigma * sigma * sigma);
}

template <typename Lanes>
typename Lanes::Pack energy_of(const Powers<typename Lanes::Pack>& p) {
  typename Lanes::Pack sum = Lanes::all(0.0);
  for (std::size_t i = 0; i < 8; ++i) {
    sum += kWeights[i] * (energy_density(p, 0.5 - 0.5 * kNodes[i]) + energy_density(p, 0.5 + 0.5 * kNodes[i]));
  }
  return 2.0 * sum;
}

template <typename Pack>
Pack length_of(const Preimages<Pack>& w) {
  const Pack middle = (2.0 * dot(w.w1, w.w1) + dot(w.w0, w.w2)) / 3.0;
  return (dot(w.w0, w.w0) + dot(w.w0, w.w1) + middle + dot(w.w1, w.w2) + dot(w.w2, w.w2)) / 5.0;
}

/// The interpolant in the chord frame: both signs plus where both headings are within 90 degrees of the chord.
template <typename Lanes>
Preimages<typename Lanes::Pack> in_chord_frame(const double* ends, std::size_t stride, typename Lanes::Pack m0,
                                               typename Lanes::Pack m1) {
  using Pack = typename Lanes::Pack;
  const auto row = [&](Ends::Row r) { return Lanes::load(ends + r * stride); };
  const Pack root0 = Lanes::root(m0);
  const Pack root1 = Lanes::root(m1);
  const Number<Pack> w0{root0 * row(Ends::HalfStartRe), root0 * row(Ends::HalfStartIm)};
  const Number<Pack> w2{root1 * row(Ends::HalfEndRe), root1 * row(Ends::HalfEndIm)};
  const Pack chord = row(Ends::Chord);
  Preimages<Pack> best = solution<Lanes>(chord, w0, w2, 1.0);
  const auto backward = row(Ends::Forward) == 0.0;
  if (!Lanes::any(backward)) return best;
  Pack least_energy = energy_of<Lanes>(powers_of(best));
  for (int i = 1; i < 4; ++i) {
    const Preimages<Pack> other = solution<Lanes>(chord, w0, i == 1 ? w2 : -w2, i == 2 ? 1.0 : -1.0);
    const Pack energy = energy_of<Lanes>(powers_of(other));
    const auto better = backward & (energy < least_energy);
    least_energy = better ? energy : least_energy;
    best.w1.re = better ? other.w1.re : best.w1.re;
    best.w1.im = better ? other.w1.im : best.w1.im;
    best.w2.re = better ? other.w2.re : best.w2.re;
    best.w2.im = better ? other.w2.im : best.w2.im;
  }
  return best;
}

template <typename Lanes>
void store_path(const Preimages<typename Lanes::Pack>& w, double* path, std::size_t stride) {
  using Pack = typename Lanes::Pack;
  const auto put = [&](std::size_t row, Pack value) { Lanes::store(path + row * stride, value); };
  const Powers<Pack> p = powers_of(w);
  const Number<Pack> hodograph[5] = {p.a * p.a, scaled(2.0, p.a * p.b), p.b * p.b + scaled(2.0, p.a * p.c),
                                     scaled(2.0, p.b * p.c), p.c * p.c};
  for (std::size_t k = 0; k < 5; ++k) {
    const double divisor = static_cast<double>(k + 1);
    put(Paths::Place + k, hodograph[k].re / divisor);
    put(Paths::Place + 5 + k, hodograph[k].im / divisor);
    put(Paths::S + k, p.speed[k] / divisor);
    put(Paths::Speed + k, p.speed[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) put(Paths::Bend + k, p.bend[k]);
  put(Paths::Length, length_of(w));
  put(Paths::First, Lanes::all(0.0));
}

template <typename Lanes>
void interpolate(ConstTable ends, const double* m0_m, const double* m1_m, std::size_t lanes, Table paths) {
  using Pack = typename Lanes::Pack;
  for (std::size_t l = 0; l < lanes; l += Lanes::kWidth) {
    const double* from = ends.data + l;
    const auto row = [&](Ends::Row r) { return Lanes::load(from + r * ends.stride); };
    const Preimages<Pack> w = in_chord_frame<Lanes>(from, ends.stride, Lanes::load(m0_m + l), Lanes::load(m1_m + l));
    const Number<Pack> turn{row(Ends::HalfChordRe), row(Ends::HalfChordIm)};
    double* path = paths.data + l;
    Lanes::store(path + Paths::Start * paths.stride, row(Ends::StartX));
    Lanes::store(path + (Paths::Start + 1) * paths.stride, row(Ends::StartY));
    store_path<Lanes>({turn * w.w0, turn * w.w1, turn * w.w2}, path, paths.stride);
  }
}

template <typename Lanes>
void measure(ConstTable ends, const double* m0_m, const double* m1_m, std::size_t lanes, double* length_m) {
  for (std::size_t l = 0; l < lanes; l += Lanes::kWidth) {
    const auto w = in_chord_frame<Lanes>(ends.data + l, ends.stride, Lanes::load(m0_m + l), Lanes::load(m1_m + l));
    Lanes::store(length_m + l, length_of(w));
  }
}

}  // namespace
}  // namespace skein::rendezvous::kernel
