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
// A spatial path is another set of rows with its own `interpolate` and `judge`; the rest is written over the number of
// coordinates.
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

/// The same in space, as SpatialHermite keeps them: vectors of three rows, the axes in world coordinates.
struct SpatialEnds {
  enum Row : std::size_t {
    Start,
    Along = Start + 3,
    Left = Along + 3,
    Up = Left + 3,
    HalfStart = Up + 3,
    HalfEnd = HalfStart + 3,
    Chord = HalfEnd + 3,
    Forward,
    Count
  };
};

// NOLINTBEGIN(readability-identifier-naming): rows are named as those of the enumerations above

/// Rows that the paths of both spaces have: coefficients by powers of q of arc length (from q^1) and speed (from q^0),
/// then the start and, axis by axis, the coefficients of position (from q^1).
template <std::size_t Dimensions>
struct PathRows {
  static constexpr std::size_t kDimensions = Dimensions;
  static constexpr std::size_t S = 0;
  static constexpr std::size_t Speed = S + 5;
  static constexpr std::size_t Length = Speed + 5;
  static constexpr std::size_t First = Length + 1;  ///< number of the first point to be walked to: 0 after interpolate
  static constexpr std::size_t Start = First + 1;
  static constexpr std::size_t Place = Start + Dimensions;
  static constexpr std::size_t kRest = Place + 5 * Dimensions;
};

/// Rows of a path, as PlanarPath keeps them: with the coefficients of the curvature's numerator (from q^0).
struct Paths : PathRows<2> {
  static constexpr std::size_t Bend = kRest;
  static constexpr std::size_t Count = Bend + 3;
};

/// Rows of a path, as SpatialPath keeps them: b (its two components one after the other), |b|^2 and N by powers of q.
struct SpatialPaths : PathRows<3> {
  static constexpr std::size_t Bend = kRest;
  static constexpr std::size_t BendSquared = Bend + 6;
  static constexpr std::size_t Twist = BendSquared + 5;
  static constexpr std::size_t Count = Twist + 7;
};

// NOLINTEND(readability-identifier-naming)

/// Rows of a judgement: 1 if the constraint is violated, else 0; elastic energy (1/m). In the plane those that only
/// space has are left as they are.
struct Verdicts {
  enum Row : std::size_t { Unflyable, Obstacle, NoFly, Twisted, Terrain, Energy, Count };
  static constexpr std::size_t kConstraints = 5;
  static constexpr std::size_t kPlanarConstraints = 3;
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

/// A zone in space: the box about it and the distance to be kept, beyond which no chord can come too near.
struct Volume {
  double x_m;  ///< centre
  double y_m;
  double half_x_m;
  double half_y_m;
  double z_min_m;
  double z_max_m;
  Verdicts::Row kind;
};

/// What only space has. The two functions are told of single chords and points that may violate something, so that the
/// geometry and the terrain stay where they are; they depend on nothing but their arguments.
struct SpatialRules {
  double max_torsion_per_m;
  const Volume* volumes;
  std::size_t volume_count;
  double terrain_roof_m;  ///< height from which on there is no terrain
  const void* context;
  bool (*enters)(const void* context, std::size_t volume, const double* a_m, const double* b_m);
  bool (*is_low)(const void* context, const double* point_m);
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
  SpatialRules spatial;
};

/// Representatives of peers, one a lane, their points as `walk` lays them out; separations (m) by lane, in the lanes
/// after the last peer far below 0.
struct Peers {
  ConstTable points_m;
  const double* separation_m;
  std::size_t count;
};

/// Points at arc lengths L k / gaps: of each lane, `points` of them from its row First on. Beyond the end: the end.
struct Stretch {
  std::size_t gaps;    ///< at least 1
  std::size_t points;  ///< at least 1
};

/// The steps in one space.
struct Steps {
  /// Paths of controls m0, m1 (m, positive) between ends.
  void (*interpolate)(ConstTable ends, const double* m0_m, const double* m1_m, std::size_t lanes, Table paths);
  /// Their lengths (m) alone, in the chord frame: Hermite::length_m.
  void (*measure)(ConstTable ends, const double* m0_m, const double* m1_m, std::size_t lanes, double* length_m);
  /// Verdicts (rows Verdicts) of paths.
  void (*judge)(ConstTable paths, const Rules& rules, std::size_t lanes, Table verdicts);
  /// Equidistant points of paths: row axis * stretch.points + k is that coordinate (m) of the lane's point First + k.
  void (*walk)(ConstTable paths, const Stretch& stretch, std::size_t lanes, Table points_m);
  /// collided[l] = 1 if lane l comes closer to some peer, at the same number, than its separation, else 0.
  void (*meet)(ConstTable points_m, std::size_t points, std::size_t lanes, const Peers& peers, double* collided);
};

struct Kernel {
  std::size_t width;  ///< lanes of a pack
  Steps planar;       ///< rows Ends and Paths
  Steps spatial;      ///< rows SpatialEnds and SpatialPaths
};

/// The number of lanes that a table for n candidates needs.
[[nodiscard]] constexpr std::size_t padded(std::size_t n) {
  return (n + kLaneMultiple - 1) / kLaneMultiple * kLaneMultiple;
}

}  // namespace skein::rendezvous::kernel
