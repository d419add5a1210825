// The hot kernel of the rendezvous search: many candidate paths in structure-of-arrays lanes, one candidate a lane.
//
// Four steps, each over all lanes: `interpolate` (controls to PH path and length), `judge` (energy, curvature and zones
// at Np points), `walk` (Nph equidistant points), `meet` (separation from peers, Eq. 17). Each is written once, as a
// template over the pack of lanes that one instruction works on, and compiled for each instruction set; every lane sees
// the same + - * / sqrt in the same order whatever its pack, so all sets give the same bits. Branches on data are
// selects; a branch that a whole pack takes skips work whose outcome is known.
//
// Tables are rows of lanes: row r of lane l at data[r * stride + l]. The stride is a multiple of kLaneMultiple, and all
// lanes up to the next multiple of it hold numbers (a copy of another lane, say). A kernel writes those lanes too.
// A spatial path is another set of rows and its own `interpolate` and `judge`; the rest stays.
//
// Source: papers/001, Eq. 2-7, 11-17; Farouki and Neff, Math. Comput. 64 (1995). Departs from source: the equidistant
// points take a fixed number of steps (walk.hpp), so that lanes stay together. Complexity: O(lanes Np (zones +
// Newton)).
#pragma once

#include <cstddef>

namespace skein::rendezvous::kernel {

inline constexpr std::size_t kLaneMultiple = 8;

struct Table {
  double* data;
  std::size_t stride;
};

struct ConstTable {
  const double* data;
  std::size_t stride;
};

/// Rows of the two poses of a path, as Hermite keeps them; `Forward` is 1 or 0.
struct Ends {
  enum Row : std::size_t {
    StartX,
    StartY,
    Chord,
    HalfStartRe,
    HalfStartIm,
    HalfEndRe,
    HalfEndIm,
    HalfChordRe,
    HalfChordIm,
    Forward,
    Count
  };
};

/// Rows of a path, as PlanarPath keeps them: coefficients by powers of q of position and arc length (from q^1), of
/// speed and of the curvature's numerator (from q^0).
struct Paths {
  enum Row : std::size_t {
    StartX,
    StartY,
    X,
    Y = X + 5,
    S = Y + 5,
    Speed = S + 5,
    Bend = Speed + 5,
    Length = Bend + 3,
    First,  ///< number of the first point to be walked to: 0 after interpolate
    Count
  };
};

/// Rows of a judgement: 1 if the constraint is violated, else 0; elastic energy (1/m).
struct Verdicts {
  enum Row : std::size_t { Unflyable, Obstacle, NoFly, Energy, Count };
  static constexpr std::size_t kConstraints = 3;
};

struct Circle {
  double x_m;
  double y_m;
  double reach_m;  ///< radius and the distance to be kept
  Verdicts::Row kind;
};

struct Rectangle {
  double x_m;  ///< centre
  double y_m;
  double half_x_m;
  double half_y_m;
  Verdicts::Row kind;
};

struct Rules {
  double max_curvature_per_m;
  double keep_out_m;
  const double* places;  ///< Np parameters, ascending, from 0 to 1
  std::size_t place_count;
  const Circle* circles;
  std::size_t circle_count;
  const Rectangle* rectangles;
  std::size_t rectangle_count;
};

/// Representatives of peers, one a lane: row k of x and y is point number k (m); separations (m) by lane, in the
/// lanes after the last peer far below 0.
struct Peers {
  ConstTable x_m;
  ConstTable y_m;
  const double* separation_m;
  std::size_t count;
};

/// Points at arc lengths L k / gaps: of each lane, `points` of them from its row First on. Beyond the end: the end.
struct Stretch {
  std::size_t gaps;    ///< at least 1
  std::size_t points;  ///< at least 1
};

struct Kernel {
  std::size_t width;  ///< lanes of a pack

  /// Paths (rows Paths) of controls m0, m1 (m, positive) between ends (rows Ends).
  void (*interpolate)(ConstTable ends, const double* m0_m, const double* m1_m, std::size_t lanes, Table paths);
  /// Their lengths (m) alone, in the chord frame: Hermite::length_m.
  void (*measure)(ConstTable ends, const double* m0_m, const double* m1_m, std::size_t lanes, double* length_m);
  /// Verdicts (rows Verdicts) of paths.
  void (*judge)(ConstTable paths, const Rules& rules, std::size_t lanes, Table verdicts);
  /// Equidistant points of paths: row k of x and y (m) is the lane's point First + k.
  void (*walk)(ConstTable paths, const Stretch& stretch, std::size_t lanes, Table x_m, Table y_m);
  /// collided[l] = 1 if lane l comes closer to some peer, at the same number, than its separation, else 0.
  void (*meet)(ConstTable x_m, ConstTable y_m, std::size_t points, std::size_t lanes, const Peers& peers,
               double* collided);
};

/// The number of lanes that a table for n candidates needs.
[[nodiscard]] constexpr std::size_t padded(std::size_t n) {
  return (n + kLaneMultiple - 1) / kLaneMultiple * kLaneMultiple;
}

}  // namespace skein::rendezvous::kernel
