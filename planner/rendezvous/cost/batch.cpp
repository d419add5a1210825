#include "planner/rendezvous/cost/batch.hpp"

#include <algorithm>
#include <numeric>

#include "planner/rendezvous/cost/coordinates.hpp"

namespace skein::rendezvous {
namespace {

using kernel::Verdicts;

/// The separation of a lane without a peer: no point is nearer than this.
constexpr double kNoPeer_m = -1e300;

template <typename Space>
std::size_t points_of(const ProblemIn<Space>& problem) {
  return static_cast<std::size_t>(problem.options.check_points);
}

/// From start to end of each path.
template <typename Space>
void walk_whole(const kernel::Kernel& kernel, const kernel::LaneTable& paths, std::size_t lanes,
                PointTableIn<Space>& into, std::size_t first = 0) {
  Space::steps(kernel).walk(paths.view(), {into.points() - 1, into.points()}, lanes, into.table(first));
}

template <typename Space>
void put_path(const typename Space::Piece& path, kernel::LaneTable& paths) {
  using Rows = typename Space::PathRows;
  paths.row(Rows::Length)[0] = path.length_m();
  for (std::size_t axis = 0; axis < Rows::kDimensions; ++axis) {
    paths.row(Rows::Start + axis)[0] = path.start_m()[static_cast<Eigen::Index>(axis)];
    for (std::size_t k = 0; k < 5; ++k) paths.row(Rows::Place + 5 * axis + k)[0] = path.place_powers(axis)[k];
  }
  for (std::size_t k = 0; k < 5; ++k) {
    paths.row(Rows::S + k)[0] = path.profile().arc_powers()[k];
    paths.row(Rows::Speed + k)[0] = path.speed_powers()[k];
  }
}

}  // namespace

template <typename Space>
void PointTableIn<Space>::resize(std::size_t points, std::size_t lanes) {
  points_ = points;
  rows_.resize(Space::PathRows::kDimensions * points, lanes);
}

template <typename Space>
typename Space::Vec PointTableIn<Space>::at(std::size_t lane, std::size_t k) const {
  Vec point_m;
  for (std::size_t axis = 0; axis < Space::PathRows::kDimensions; ++axis) {
    point_m[static_cast<Eigen::Index>(axis)] = rows_.row(axis * points_ + k)[lane];
  }
  return point_m;
}

template <typename Space>
void PointTableIn<Space>::set(std::size_t lane, std::size_t k, const Vec& point_m) {
  for (std::size_t axis = 0; axis < Space::PathRows::kDimensions; ++axis) {
    rows_.row(axis * points_ + k)[lane] = point_m[static_cast<Eigen::Index>(axis)];
  }
}

template <typename Space>
void PointTableIn<Space>::copy_to(std::size_t lane, std::span<Vec> points_m) const {
  for (std::size_t k = 0; k < points_m.size(); ++k) points_m[k] = at(lane, k);
}

template <typename Space>
void PointTableIn<Space>::copy_from(std::size_t lane, std::span<const Vec> points_m) {
  for (std::size_t k = 0; k < points_m.size(); ++k) set(lane, k, points_m[k]);
}

template <typename Space>
void PeerTableIn<Space>::resize(std::size_t points, std::size_t peers) {
  count_ = peers;
  points_.resize(points, peers);
  separation_m_.assign(kernel::padded(peers), kNoPeer_m);
  ids_.clear();
}

template <typename Space>
void PeerTableIn<Space>::assign(View<PeerPathIn<Space>> peers, std::size_t points) {
  resize(points, peers.size());
  for (std::size_t lane = 0; lane < count_; ++lane) {
    separation_m_[lane] = peers[lane].separation_m;
    points_.copy_from(lane, peers[lane].points_m);
  }
}

template <typename Space>
void PeerTableIn<Space>::follow(const ProblemIn<Space>& problem, std::span<const Representative> peers) {
  if (!std::ranges::equal(ids_, peers, {}, {}, &Representative::agent) || points_.points() != points_of(problem)) {
    resize(points_of(problem), peers.size());
    controls_.assign(count_, {});  // no path's
    for (std::size_t lane = 0; lane < count_; ++lane) {
      ids_.push_back(peers[lane].agent);
      separation_m_[lane] = required_separation_m(problem.own(), participant_of(problem, ids_[lane]));
    }
  }
  changed_.clear();
  for (std::size_t lane = 0; lane < count_; ++lane) {
    const ph::Controls controls = *controls_of<Space>(peers[lane].particle);
    if (controls == controls_[lane]) continue;
    controls_[lane] = controls;
    if (controls.is_joined()) {
      walk_joined(problem, lane);
    } else {
      changed_.push_back(lane);
    }
  }
  if (changed_.empty()) return;
  if (2 * changed_.size() > count_ && std::ranges::none_of(controls_, &ph::Controls::is_joined)) {
    // walking all in place takes less than copying
    changed_.resize(count_);
    std::iota(changed_.begin(), changed_.end(), std::size_t{0});
  }
  walk(problem, changed_);
}

template <typename Space>
void PeerTableIn<Space>::walk(const ProblemIn<Space>& problem, std::span<const std::size_t> lanes) {
  const std::size_t count = lanes.size();
  ends_.resize(Space::EndRows::Count, count);
  m_.resize(2, count);
  paths_.resize(Space::PathRows::Count, count);
  for (std::size_t i = 0; i < count; ++i) {
    put_ends(participant_of(problem, ids_[lanes[i]]).hermite, i, ends_);
    m_.row(0)[i] = controls_[lanes[i]].m0_m;
    m_.row(1)[i] = controls_[lanes[i]].m1_m;
  }
  ends_.pad(count);
  m_.pad(count);
  const kernel::Steps& steps = Space::steps(*problem.kernel);
  steps.interpolate(ends_.view(), m_.row(0), m_.row(1), count, paths_.table());
  if (count == count_) {
    walk_whole(*problem.kernel, paths_, count, points_);
    return;
  }
  walked_.resize(points_of(problem), count);
  walk_whole(*problem.kernel, paths_, count, walked_);
  for (std::size_t i = 0; i < count; ++i) points_.copy_lane(walked_, i, lanes[i]);
}

template <typename Space>
void PeerTableIn<Space>::walk_joined(const ProblemIn<Space>& problem, std::size_t lane) {
  std::vector<typename Space::Vec> points_m(points_.points());
  equidistant_points(participant_of(problem, ids_[lane]).hermite.path(controls_[lane]), points_m);
  points_.copy_from(lane, points_m);
}

template <typename Space>
std::vector<PeerPathIn<Space>> PeerTableIn<Space>::paths() const {
  std::vector<PeerPathIn<Space>> paths;
  for (std::size_t lane = 0; lane < count_; ++lane) {
    PeerPathIn<Space>& path = paths.emplace_back();
    path.id = ids_[lane];
    path.separation_m = separation_m_[lane];
    path.points_m.resize(points_.points());
    points_.copy_to(lane, path.points_m);
  }
  return paths;
}

template <typename Space>
BatchIn<Space>::BatchIn(const ProblemIn<Space>& problem, std::size_t capacity)
    : rules_(problem),
      ends_(Space::EndRows::Count, capacity),
      controls_(2, capacity),
      paths_(Space::PathRows::Count, capacity),
      chosen_paths_(Space::PathRows::Count, capacity),
      verdicts_(Verdicts::Count, capacity) {
  put_ends(problem.own().hermite, 0, ends_);
  ends_.pad(1);
  for (std::size_t lane = 1; lane < capacity; ++lane) ends_.copy_lane(ends_, 0, lane);
  ends_.pad(capacity);
}

template <typename Space>
void BatchIn<Space>::evaluate(const ProblemIn<Space>& problem, std::span<EvaluationIn<Space>> candidates) {
  const std::size_t lanes = candidates.size();
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    controls_.row(0)[lane] = candidates[lane].controls.m0_m;
    controls_.row(1)[lane] = candidates[lane].controls.m1_m;
  }
  controls_.pad(lanes);
  const kernel::Steps& steps = Space::steps(*problem.kernel);
  steps.interpolate(ends_.view(), controls_.row(0), controls_.row(1), lanes, paths_.table());
  steps.judge(paths_.view(), rules_.rules(problem), lanes, verdicts_.table());
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    EvaluationIn<Space>& e = candidates[lane];
    const auto penalty = [&](Verdicts::Row r) { return verdicts_.row(r)[lane] > 0.0 ? problem.options.penalty : 0.0; };
    e.length_m = paths_.row(Space::PathRows::Length)[lane];
    e.terms = {};
    e.terms.length = e.length_m / problem.length_unit_m;
    e.terms.curve_energy = verdicts_.row(Verdicts::Energy)[lane] * problem.length_unit_m;
    e.terms.unflyable = penalty(Verdicts::Unflyable);
    e.terms.obstacle = penalty(Verdicts::Obstacle);
    e.terms.no_fly = penalty(Verdicts::NoFly);
    if constexpr (Space::kSpatial) {
      e.terms.twisted = penalty(Verdicts::Twisted);
      e.terms.terrain = penalty(Verdicts::Terrain);
    }
    e.own = own_cost(e.terms, problem.options.length_weight);
    e.modified = e.own;
  }
}

template <typename Space>
void BatchIn<Space>::walk(const ProblemIn<Space>& problem, std::span<const std::size_t> chosen,
                          PointTableIn<Space>& into, std::size_t first) {
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen_paths_.copy_lane(paths_, chosen[i], i);
  chosen_paths_.pad(chosen.size());
  walk_whole(*problem.kernel, chosen_paths_, chosen.size(), into, first);
}

template <typename Space>
void walk_in_parts(const kernel::Kernel& kernel, const typename Space::Path& path,
                   std::span<typename Space::Vec> points_m) {
  if (path.pieces().size() > 1) return equidistant_points(path, points_m);
  constexpr std::size_t kParts = kernel::kLaneMultiple;
  const std::size_t part = (points_m.size() + kParts - 1) / kParts;
  kernel::LaneTable paths(Space::PathRows::Count, kParts);
  PointTableIn<Space> points(part, kParts);
  put_path<Space>(path.pieces()[0], paths);
  paths.pad(1);
  double* first = paths.row(Space::PathRows::First);
  for (std::size_t lane = 0; lane < kParts; ++lane) first[lane] = static_cast<double>(part * lane);
  Space::steps(kernel).walk(paths.view(), {points_m.size() - 1, part}, kParts, points.table());
  for (std::size_t i = 0; i < points_m.size(); ++i) points_m[i] = points.at(i / part, i % part);
}

template class PointTableIn<Planar>;
template class PeerTableIn<Planar>;
template class BatchIn<Planar>;
template void walk_in_parts<Planar>(const kernel::Kernel&, const Planar::Path&, std::span<Vec2>);
template class PointTableIn<Spatial>;
template class PeerTableIn<Spatial>;
template class BatchIn<Spatial>;
template void walk_in_parts<Spatial>(const kernel::Kernel&, const Spatial::Path&, std::span<Vec3>);

}  // namespace skein::rendezvous
