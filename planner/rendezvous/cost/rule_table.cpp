#include <limits>

#include "planner/rendezvous/cost/batch.hpp"

namespace skein::rendezvous {
namespace {

using kernel::Ends;
using kernel::SpatialEnds;
using kernel::Verdicts;

Verdicts::Row kind_of(const PlanarZone& zone) {
  return zone.no_fly ? Verdicts::NoFly : Verdicts::Obstacle;
}

Vec2 half_size_of(const PlanarZone& zone) {
  if (const auto* cylinder = std::get_if<Cylinder>(&zone.shape)) return {cylinder->radius_m, cylinder->radius_m};
  const Box& box = std::get<Box>(zone.shape);
  return 0.5 * (box.max_m - box.min_m).head<2>();
}

bool enters(const void* context, std::size_t volume, const double* a_m, const double* b_m) {
  const auto& problem = *static_cast<const ProblemIn<Spatial>*>(context);
  const Vec3 a(a_m[0], a_m[1], a_m[2]);
  const Vec3 b(b_m[0], b_m[1], b_m[2]);
  return distance_m(problem.zones[volume], a, b) < problem.keep_out_m;
}

bool is_low(const void* context, const double* point_m) {
  const auto& problem = *static_cast<const ProblemIn<Spatial>*>(context);
  return height_above_m(*problem.terrain, Vec3(point_m[0], point_m[1], point_m[2])) < problem.terrain_height_m;
}

void put(const Vec3& v, std::size_t row, std::size_t lane, kernel::LaneTable& table) {
  for (std::size_t i = 0; i < 3; ++i) table.row(row + i)[lane] = v[static_cast<Eigen::Index>(i)];
}

}  // namespace

template <typename Space>
RuleTableIn<Space>::RuleTableIn(const ProblemIn<Space>& problem) {
  const auto last = static_cast<std::size_t>(problem.options.check_points) - 1;
  for (std::size_t k = 0; k <= last; ++k) places_.push_back(static_cast<double>(k) / static_cast<double>(last));
  const double keep_m = problem.keep_out_m;
  for (const PlanarZone& zone : problem.zones) {
    const Vec2& at = zone.centre_m;
    const Vec2 half = half_size_of(zone);
    if constexpr (Space::kSpatial) {
      volumes_.push_back({at.x(), at.y(), half.x() + keep_m, half.y() + keep_m, zone.heights_m.min - keep_m,
                          zone.heights_m.max + keep_m, kind_of(zone)});
    } else if (std::holds_alternative<Cylinder>(zone.shape)) {
      circles_.push_back({at.x(), at.y(), half.x() + keep_m, kind_of(zone)});
    } else {
      rectangles_.push_back({at.x(), at.y(), half.x(), half.y(), kind_of(zone)});
    }
  }
}

template <typename Space>
kernel::Rules RuleTableIn<Space>::rules(const ProblemIn<Space>& problem) const {
  kernel::Rules rules{problem.max_curvature_per_m,
                      problem.keep_out_m,
                      places_.data(),
                      places_.size(),
                      circles_.data(),
                      circles_.size(),
                      rectangles_.data(),
                      rectangles_.size(),
                      {}};
  if constexpr (Space::kSpatial) {
    const double roof_m = problem.terrain ? problem.terrain_roof_m : -std::numeric_limits<double>::infinity();
    rules.spatial = {problem.max_torsion_per_m, volumes_.data(), volumes_.size(), roof_m, &problem, enters, is_low};
  }
  return rules;
}

void put_ends(const ph::Hermite& hermite, std::size_t lane, kernel::LaneTable& ends) {
  ends.row(Ends::StartX)[lane] = hermite.start_m().x();
  ends.row(Ends::StartY)[lane] = hermite.start_m().y();
  ends.row(Ends::Chord)[lane] = hermite.chord_m();
  ends.row(Ends::HalfStartRe)[lane] = hermite.half_start().re;
  ends.row(Ends::HalfStartIm)[lane] = hermite.half_start().im;
  ends.row(Ends::HalfEndRe)[lane] = hermite.half_end().re;
  ends.row(Ends::HalfEndIm)[lane] = hermite.half_end().im;
  ends.row(Ends::HalfChordRe)[lane] = hermite.half_chord().re;
  ends.row(Ends::HalfChordIm)[lane] = hermite.half_chord().im;
  ends.row(Ends::Forward)[lane] = hermite.forward() ? 1.0 : 0.0;
}

void put_ends(const ph::SpatialHermite& hermite, std::size_t lane, kernel::LaneTable& ends) {
  put(hermite.start_m(), SpatialEnds::Start, lane, ends);
  put(hermite.axes().along, SpatialEnds::Along, lane, ends);
  put(hermite.axes().left, SpatialEnds::Left, lane, ends);
  put(hermite.axes().up, SpatialEnds::Up, lane, ends);
  put(hermite.half_start(), SpatialEnds::HalfStart, lane, ends);
  put(hermite.half_end(), SpatialEnds::HalfEnd, lane, ends);
  ends.row(SpatialEnds::Chord)[lane] = hermite.chord_m();
  ends.row(SpatialEnds::Forward)[lane] = hermite.forward() ? 1.0 : 0.0;
}

template class RuleTableIn<Planar>;
template class RuleTableIn<Spatial>;

}  // namespace skein::rendezvous
