#include "planner/rendezvous/ph/hermite.hpp"

#include <cmath>
#include <stdexcept>

#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"

namespace skein::rendezvous::ph {
namespace {

Complex unit(double angle_rad) {
  const math::SinCos both = math::sincos(angle_rad);
  return {both.cos, both.sin};
}

}  // namespace

Hermite::Hermite(const PlanarPose& start, const PlanarPose& end)
    : start_m_(start.position_m), chord_m_((end.position_m - start.position_m).norm()) {
  if (!(chord_m_ > 0.0)) throw std::invalid_argument("a path needs a start and an end at different places");
  const double phi = heading_of(end.position_m - start.position_m);
  const double a0 = math::wrap_angle(start.heading_rad - phi);
  const double a1 = math::wrap_angle(end.heading_rad - phi);
  forward_ = std::fabs(a0) <= 0.5 * math::kPi && std::fabs(a1) <= 0.5 * math::kPi;
  half_start_ = unit(0.5 * a0);
  half_end_ = unit(0.5 * a1);
  half_chord_ = unit(0.5 * phi);
}

Preimage Hermite::solution(Complex w0, Complex w2, double root_sign) const {
  const Complex radicand = Complex{120.0 * chord_m_, 0.0} - 15.0 * (w0 * w0) - 15.0 * (w2 * w2) + 10.0 * (w0 * w2);
  const Complex w1 = 0.25 * (root_sign * square_root(radicand) - 3.0 * (w0 + w2));
  return {w0, w1, w2};
}

Preimage Hermite::in_chord_frame(const Controls& m) const {
  const Complex w0 = std::sqrt(m.m0_m) * half_start_;
  const Complex w2 = std::sqrt(m.m1_m) * half_end_;
  Preimage best = solution(w0, w2, 1.0);
  if (forward_) return best;
  double least = PlanarPath(Vec2::Zero(), best).elastic_energy_per_m();
  for (const Preimage& other : {solution(w0, w2, -1.0), solution(w0, -w2, 1.0), solution(w0, -w2, -1.0)}) {
    const double energy = PlanarPath(Vec2::Zero(), other).elastic_energy_per_m();
    if (energy < least) {
      least = energy;
      best = other;
    }
  }
  return best;
}

PlanarPath Hermite::path(const Controls& m) const {
  const Preimage w = in_chord_frame(m);
  return PlanarPath(start_m_, {half_chord_ * w.w0, half_chord_ * w.w1, half_chord_ * w.w2});
}

double Hermite::length_m(const Controls& m) const {
  return length_of(in_chord_frame(m));
}

}  // namespace skein::rendezvous::ph
