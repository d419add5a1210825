// A path of 1 to 4 joined PH segments, with the interface of one: position, direction, curvature and arc length.
//
// The parameter q in [0, 1] runs over all pieces, each taking an equal part of it. A path of a single piece gives what
// the piece gives, bit for bit. Curvature is continuous across the joints if the pieces come from one spline
// (preimage_spline.hpp); torsion in general is not.
//
// Source: papers/001, Remark 4. Departs from source: none. Complexity: O(pieces) and that of one piece.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "planner/rendezvous/ph/controls.hpp"
#include "planner/rendezvous/ph/curvature_bound.hpp"
#include "planner/rendezvous/ph/planar_path.hpp"
#include "planner/rendezvous/ph/spatial_path.hpp"
#include "planner/rendezvous/ph/torsion_bound.hpp"

namespace skein::rendezvous::ph {

template <typename Piece>
class JoinedPath {
 public:
  JoinedPath() = default;                                                     ///< a point at the origin, of length 0
  JoinedPath(const Piece& only) : pieces_{only}, ends_m_{only.length_m()} {}  // a piece is such a path

  /// Puts a piece at the end, which it must start from. @pre fewer than kMaxSegments pieces
  void append(const Piece& piece) {
    pieces_[count_] = piece;
    ends_m_[count_] = length_m() + piece.length_m();
    ++count_;
  }
  /// No piece: to be appended to.
  [[nodiscard]] static JoinedPath empty() {
    JoinedPath path;
    path.count_ = 0;
    return path;
  }

  [[nodiscard]] std::span<const Piece> pieces() const { return {pieces_.data(), count_}; }
  [[nodiscard]] double length_m() const { return count_ == 0 ? 0.0 : ends_m_[count_ - 1]; }

  /// By parameter q in [0, 1], as of the piece; speed is |dr/dq| (m).
  [[nodiscard]] auto position(double q) const {
    return at(q, [](const Piece& p, double t) { return p.position(t); });
  }
  [[nodiscard]] double curvature(double q) const {
    return at(q, [](const Piece& p, double t) { return p.curvature(t); });
  }
  [[nodiscard]] double torsion(double q) const {
    return at(q, [](const Piece& p, double t) { return p.torsion(t); });
  }
  [[nodiscard]] double heading(double q) const {
    return at(q, [](const Piece& p, double t) { return p.heading(t); });
  }
  [[nodiscard]] Vec3 direction(double q) const {
    return at(q, [](const Piece& p, double t) { return p.direction(t); });
  }
  [[nodiscard]] double speed(double q) const {
    return parts() * at(q, [](const Piece& p, double t) { return p.speed(t); });
  }
  [[nodiscard]] double arc_length(double q) const {
    const Place place = place_of(q);
    return start_of_m(place.piece) + pieces_[place.piece].arc_length(place.t);
  }

  /// Integral of squared curvature, in space of squared torsion too, over arc length (1/m).
  [[nodiscard]] double elastic_energy_per_m() const {
    double sum = pieces_[0].elastic_energy_per_m();
    for (std::size_t i = 1; i < count_; ++i) sum += pieces_[i].elastic_energy_per_m();
    return sum;
  }

  /// The parameter at arc length s (m), s clamped to [0, length]; `guess` is where the iteration starts.
  [[nodiscard]] double parameter_at(double s_m, double guess) const {
    const std::size_t i = piece_at(s_m);
    const double local = guess * parts() - static_cast<double>(i);
    return global(i, pieces_[i].parameter_at(s_m - start_of_m(i), local));
  }
  [[nodiscard]] double parameter_at(double s_m) const {
    const std::size_t i = piece_at(s_m);
    return global(i, pieces_[i].parameter_at(s_m - start_of_m(i)));
  }

  /// At arc length s (m), clamped to [0, length].
  [[nodiscard]] auto position_at(double s_m) const { return position(parameter_at(s_m)); }
  [[nodiscard]] double heading_at(double s_m) const { return heading(parameter_at(s_m)); }
  [[nodiscard]] double curvature_at(double s_m) const { return curvature(parameter_at(s_m)); }

  /// The piece in which arc length s (m) lies, and the arc length of its start.
  [[nodiscard]] std::size_t piece_at(double s_m) const {
    std::size_t i = 0;
    while (i + 1 < count_ && s_m > ends_m_[i]) ++i;
    return i;
  }
  [[nodiscard]] double start_of_m(std::size_t piece) const { return piece == 0 ? 0.0 : ends_m_[piece - 1]; }

 private:
  /// A parameter as piece and parameter within it.
  struct Place {
    std::size_t piece;
    double t;
  };

  [[nodiscard]] double parts() const { return static_cast<double>(count_); }
  [[nodiscard]] Place place_of(double q) const {
    if (count_ <= 1) return {0, q};
    const double whole = std::clamp(std::floor(q * parts()), 0.0, parts() - 1.0);
    return {static_cast<std::size_t>(whole), q * parts() - whole};
  }
  [[nodiscard]] double global(std::size_t piece, double t) const {
    return count_ <= 1 ? t : (static_cast<double>(piece) + t) / parts();
  }
  template <typename Function>
  [[nodiscard]] auto at(double q, const Function& function) const {
    const Place place = place_of(q);
    return function(pieces_[place.piece], place.t);
  }

  std::array<Piece, kMaxSegments> pieces_{};
  std::array<double, kMaxSegments> ends_m_{};  ///< arc lengths at the ends of the pieces
  std::size_t count_ = 1;
};

using JoinedPlanarPath = JoinedPath<PlanarPath>;
using JoinedSpatialPath = JoinedPath<SpatialPath>;

/// Points at arc lengths L k / (n - 1), k = 0 .. n - 1, n at least 2, both ends included.
void equidistant_points(const JoinedPlanarPath& path, std::span<Vec2> points_m);
void equidistant_points(const JoinedSpatialPath& path, std::span<Vec3> points_m);

/// As of one piece (curvature_bound.hpp, torsion_bound.hpp), the largest over all.
template <typename Piece>
[[nodiscard]] double max_curvature_per_m(const JoinedPath<Piece>& path, double tolerance = 1e-6) {
  double largest = 0.0;
  for (const Piece& piece : path.pieces()) largest = std::max(largest, max_curvature_per_m(piece, tolerance));
  return largest;
}
template <typename Piece>
[[nodiscard]] bool curvature_within(const JoinedPath<Piece>& path, double limit_per_m) {
  return std::ranges::all_of(path.pieces(), [&](const Piece& piece) { return curvature_within(piece, limit_per_m); });
}
template <typename Piece>
[[nodiscard]] double max_torsion_per_m(const JoinedPath<Piece>& path, double tolerance = 1e-6) {
  double largest = 0.0;
  for (const Piece& piece : path.pieces()) largest = std::max(largest, max_torsion_per_m(piece, tolerance));
  return largest;
}
template <typename Piece>
[[nodiscard]] bool torsion_within(const JoinedPath<Piece>& path, double limit_per_m) {
  return std::ranges::all_of(path.pieces(), [&](const Piece& piece) { return torsion_within(piece, limit_per_m); });
}

}  // namespace skein::rendezvous::ph
