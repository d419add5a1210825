#include "planner/rendezvous/ph/joined_path.hpp"

namespace skein::rendezvous::ph {
namespace {

/// Piece by piece; the first point of a piece starts its iteration anew, the others go on from the point before.
template <typename Path, typename Vec>
void fill(const Path& path, std::span<Vec> points_m) {
  const std::size_t last = points_m.size() - 1;
  const double gap_m = path.length_m() / static_cast<double>(last);
  std::size_t piece = 0;
  double q = 0.0;
  points_m[0] = path.position(0.0);
  for (std::size_t k = 1; k < last; ++k) {
    const double s_m = gap_m * static_cast<double>(k);
    const std::size_t here = path.piece_at(s_m);
    const SpeedProfile& profile = path.pieces()[here].profile();
    const double local_m = s_m - path.start_of_m(here);
    q = here == piece ? profile.parameter_beyond(q, gap_m, local_m) : profile.parameter_at(local_m);
    piece = here;
    points_m[k] = path.pieces()[here].position(q);
  }
  points_m[last] = path.position(1.0);
}

}  // namespace

void equidistant_points(const JoinedPlanarPath& path, std::span<Vec2> points_m) {
  if (path.pieces().size() == 1) return equidistant_points(path.pieces().front(), points_m);
  fill(path, points_m);
}

void equidistant_points(const JoinedSpatialPath& path, std::span<Vec3> points_m) {
  if (path.pieces().size() == 1) return equidistant_points(path.pieces().front(), points_m);
  fill(path, points_m);
}

}  // namespace skein::rendezvous::ph
