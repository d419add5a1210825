#include "planner/rendezvous/ph/joined_hermite.hpp"

#include <cmath>

#include "planner/core/math/det_math.hpp"
#include "planner/rendezvous/ph/preimage_spline.hpp"

namespace skein::rendezvous::ph {
namespace {

using PlanarSpline = SplineCoefficients<Complex>;
using SpatialSpline = SplineCoefficients<Vec3>;

constexpr std::size_t kPlanar = JoinedHermite::kPerCoefficient;
constexpr std::size_t kSpatial = SpatialJoinedHermite::kPerCoefficient;

/// The path of a spline in the chord frame; `put` makes a piece of its start and the coefficients of its preimage.
template <typename Piece, typename T, typename Put>
JoinedPath<Piece> assemble(const SplineCoefficients<T>& c, std::size_t segments, const Put& put) {
  const double part = 1.0 / std::sqrt(static_cast<double>(segments));  // dr/dt = (1 / n) dr/dq
  JoinedPath<Piece> path = JoinedPath<Piece>::empty();
  for (std::size_t i = 0; i < segments; ++i) {
    const std::array<T, 3> w = piece_of(c, segments, i);
    path.append(put(i == 0 ? nullptr : &path.pieces()[i - 1], std::array<T, 3>{part * w[0], part * w[1], part * w[2]}));
  }
  return path;
}

JoinedPlanarPath in_plane(const PlanarSpline& c, std::size_t segments, const Vec2& start_m, Complex half_chord) {
  return assemble<PlanarPath>(c, segments, [&](const PlanarPath* before, const std::array<Complex, 3>& w) {
    return PlanarPath(before == nullptr ? start_m : before->position(1.0),
                      {half_chord * w[0], half_chord * w[1], half_chord * w[2]});
  });
}

JoinedSpatialPath in_space(const SpatialSpline& c, std::size_t segments, const Vec3& start_m, const Axes& axes) {
  return assemble<SpatialPath>(c, segments, [&](const SpatialPath* before, const std::array<Vec3, 3>& w) {
    return SpatialPath(before == nullptr ? start_m : before->position(1.0), axes, {w[0], w[1], w[2]});
  });
}

/// Closed to the chord; of the four signs those of least energy, unless `forward`.
template <typename T, typename Energy>
SplineCoefficients<T> with_signs(SplineCoefficients<T> c, std::size_t segments, const T& end, bool forward,
                                 const Energy& energy_of) {
  SplineCoefficients<T> best = closed(c, segments, end, 1.0);
  if (forward) return best;
  double least = energy_of(best);
  for (const auto& [end_sign, root_sign] : {std::array{1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}}) {
    SplineCoefficients<T> other = c;
    other[segments + 1] = end_sign * other[segments + 1];
    other = closed(other, segments, end, root_sign);
    const double energy = energy_of(other);
    if (energy < least) {
      least = energy;
      best = other;
    }
  }
  return best;
}

PlanarSpline spline_of(const Hermite& ends, const Controls& m, std::size_t segments) {
  PlanarSpline c{};
  c[0] = std::sqrt(m.m0_m) * ends.half_start();
  c[segments + 1] = std::sqrt(m.m1_m) * ends.half_end();
  const double* value = m.interior.values.data();
  for (std::size_t j = 1; j <= segments; ++j) {
    if (j == closing_coefficient(segments)) continue;
    const math::SinCos half = math::sincos(0.5 * value[1]);
    c[j] = std::sqrt(value[0]) * Complex{half.cos, half.sin};
    value += kPlanar;
  }
  return with_signs(c, segments, Complex{ends.chord_m(), 0.0}, ends.forward(), [&](const PlanarSpline& candidate) {
    return in_plane(candidate, segments, Vec2::Zero(), {1.0, 0.0}).elastic_energy_per_m();
  });
}

SpatialSpline spline_of(const SpatialHermite& ends, const Controls& m, std::size_t segments) {
  SpatialSpline c;
  c.fill(Vec3::Zero());
  c[0] = std::sqrt(m.m0_m) * ends.half_start();
  c[segments + 1] = std::sqrt(m.m1_m) * ends.half_end();
  const double* value = m.interior.values.data();
  for (std::size_t j = 1; j <= segments; ++j) {
    if (j == closing_coefficient(segments)) continue;
    const math::SinCos a = math::sincos(0.5 * value[1]);
    const math::SinCos e = math::sincos(0.5 * value[2]);
    c[j] = std::sqrt(value[0]) * Vec3(a.cos * e.cos, a.sin * e.cos, e.sin);
    value += kSpatial;
  }
  const Vec3 end(ends.chord_m(), 0.0, 0.0);
  return with_signs(c, segments, end, ends.forward(), [&](const SpatialSpline& candidate) {
    return in_space(candidate, segments, Vec3::Zero(), {}).elastic_energy_per_m();
  });
}

/// Puts a value, and of a spline's coefficient the sign in which its first coordinate is not negative.
void put(Controls& m, double value) {
  m.interior.values[m.interior.size++] = value;
}

void put(Controls& m, Complex c) {
  if (c.re < 0.0) c = -c;
  put(m, dot(c, c));
  put(m, 2.0 * math::atan2(c.im, c.re));
}

void put(Controls& m, Vec3 a) {
  if (a[0] < 0.0) a = -a;
  put(m, a.squaredNorm());
  put(m, 2.0 * math::atan2(a[1], a[0]));
  put(m, 2.0 * math::atan2(a[2], std::sqrt(a[0] * a[0] + a[1] * a[1])));
}

template <typename T>
Controls followed_by(const SplineCoefficients<T>& c, std::size_t segments, const Controls& m, std::size_t n) {
  Controls shaped{m.m0_m, m.m1_m};
  for (std::size_t j = 1; j <= n; ++j) {
    if (j != closing_coefficient(n)) put(shaped, followed(c, segments, n, j));
  }
  return shaped;
}

/// Sum of the lengths of the pieces; `Of` is the preimage of one.
template <typename Of, typename T>
double length_of_spline(const SplineCoefficients<T>& c, std::size_t segments) {
  double sum_m = 0.0;
  for (std::size_t i = 0; i < segments; ++i) {
    const std::array<T, 3> w = piece_of(c, segments, i);
    sum_m += length_of(Of{w[0], w[1], w[2]});
  }
  return sum_m / static_cast<double>(segments);
}

}  // namespace

JoinedPlanarPath JoinedHermite::path(const Controls& m) const {
  if (!m.is_joined()) return Hermite::path(m);
  const std::size_t segments = 1 + m.interior.size / kPlanar;
  return in_plane(spline_of(*this, m, segments), segments, start_m(), half_chord());
}

double JoinedHermite::length_m(const Controls& m) const {
  if (!m.is_joined()) return Hermite::length_m(m);
  const std::size_t segments = 1 + m.interior.size / kPlanar;
  return length_of_spline<Preimage>(spline_of(*this, m, segments), segments);
}

Controls JoinedHermite::reshaped(const Controls& m, std::size_t n) const {
  const std::size_t segments = 1 + m.interior.size / kPlanar;
  return n == segments ? m : followed_by(spline_of(*this, m, segments), segments, m, n);
}

JoinedSpatialPath SpatialJoinedHermite::path(const Controls& m) const {
  if (!m.is_joined()) return SpatialHermite::path(m);
  const std::size_t segments = 1 + m.interior.size / kSpatial;
  return in_space(spline_of(*this, m, segments), segments, start_m(), axes());
}

double SpatialJoinedHermite::length_m(const Controls& m) const {
  if (!m.is_joined()) return SpatialHermite::length_m(m);
  const std::size_t segments = 1 + m.interior.size / kSpatial;
  return length_of_spline<SpatialPreimage>(spline_of(*this, m, segments), segments);
}

Controls SpatialJoinedHermite::reshaped(const Controls& m, std::size_t n) const {
  const std::size_t segments = 1 + m.interior.size / kSpatial;
  return n == segments ? m : followed_by(spline_of(*this, m, segments), segments, m, n);
}

}  // namespace skein::rendezvous::ph
