#include "planner/rendezvous/cost/batch.hpp"

#include <algorithm>
#include <numeric>

namespace skein::rendezvous {
namespace {

using kernel::Ends;
using kernel::Paths;
using kernel::Verdicts;

/// The separation of a lane without a peer: no point is nearer than this.
constexpr double kNoPeer_m = -1e300;

std::size_t points_of(const Problem& problem) {
  return static_cast<std::size_t>(problem.options.check_points);
}

/// From start to end of each path.
void walk_whole(const Problem& problem, const kernel::LaneTable& paths, std::size_t lanes, PointTable& into) {
  const std::size_t points = into.x_m.rows();
  problem.kernel->walk(paths.view(), {points - 1, points}, lanes, into.x_m.table(), into.y_m.table());
}

}  // namespace

RuleTable::RuleTable(const Problem& problem)
    : max_curvature_per_m_(problem.max_curvature_per_m), keep_out_m_(problem.keep_out_m) {
  const std::size_t last = points_of(problem) - 1;
  for (std::size_t k = 0; k <= last; ++k) places_.push_back(static_cast<double>(k) / static_cast<double>(last));
  for (const PlanarZone& zone : problem.zones) {
    const Verdicts::Row kind = zone.no_fly ? Verdicts::NoFly : Verdicts::Obstacle;
    if (const auto* cylinder = std::get_if<Cylinder>(&zone.shape)) {
      circles_.push_back({zone.centre_m.x(), zone.centre_m.y(), cylinder->radius_m + keep_out_m_, kind});
    } else {
      const Box& box = std::get<Box>(zone.shape);
      const Vec2 half = 0.5 * (box.max_m - box.min_m).head<2>();
      rectangles_.push_back({zone.centre_m.x(), zone.centre_m.y(), half.x(), half.y(), kind});
    }
  }
}

kernel::Rules RuleTable::rules() const {
  return {max_curvature_per_m_, keep_out_m_,     places_.data(),     places_.size(),
          circles_.data(),      circles_.size(), rectangles_.data(), rectangles_.size()};
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

void PointTable::copy_lane(const PointTable& from, std::size_t from_lane, std::size_t to_lane) {
  x_m.copy_lane(from.x_m, from_lane, to_lane);
  y_m.copy_lane(from.y_m, from_lane, to_lane);
}

void PointTable::copy_to(std::size_t lane, std::span<Vec2> points_m) const {
  const kernel::ConstTable x = x_m.view();
  const kernel::ConstTable y = y_m.view();
  for (std::size_t k = 0; k < points_m.size(); ++k) {
    points_m[k] = {x.data[k * x.stride + lane], y.data[k * y.stride + lane]};
  }
}

void PointTable::copy_from(std::size_t lane, std::span<const Vec2> points_m) {
  const kernel::Table x = x_m.table();
  const kernel::Table y = y_m.table();
  for (std::size_t k = 0; k < points_m.size(); ++k) {
    x.data[k * x.stride + lane] = points_m[k].x();
    y.data[k * y.stride + lane] = points_m[k].y();
  }
}

void PointTable::pad(std::size_t used) {
  x_m.pad(used);
  y_m.pad(used);
}

void PeerTable::resize(std::size_t points, std::size_t peers) {
  count_ = peers;
  points_.x_m.resize(points, peers);
  points_.y_m.resize(points, peers);
  separation_m_.assign(kernel::padded(peers), kNoPeer_m);
  ids_.clear();
}

void PeerTable::assign(std::span<const PeerPath> peers, std::size_t points) {
  resize(points, peers.size());
  for (std::size_t lane = 0; lane < count_; ++lane) {
    separation_m_[lane] = peers[lane].separation_m;
    points_.copy_from(lane, peers[lane].points_m);
  }
}

void PeerTable::follow(const Problem& problem, std::span<const Representative> peers) {
  if (!std::ranges::equal(ids_, peers, {}, {}, &Representative::agent)) {
    resize(points_of(problem), peers.size());
    controls_.assign(count_, {});  // no path's
    for (std::size_t lane = 0; lane < count_; ++lane) {
      ids_.push_back(peers[lane].agent);
      separation_m_[lane] = required_separation_m(problem.own(), participant_of(problem, ids_[lane]));
    }
  }
  std::vector<std::size_t> changed;
  for (std::size_t lane = 0; lane < count_; ++lane) {
    const ph::Controls controls{peers[lane].particle[0], peers[lane].particle[1]};
    if (controls == controls_[lane]) continue;
    controls_[lane] = controls;
    changed.push_back(lane);
  }
  if (changed.empty()) return;
  if (2 * changed.size() > count_) {  // walking all in place takes less than copying
    changed.resize(count_);
    std::iota(changed.begin(), changed.end(), std::size_t{0});
  }
  walk(problem, changed);
}

void PeerTable::walk(const Problem& problem, std::span<const std::size_t> lanes) {
  const std::size_t count = lanes.size();
  kernel::LaneTable ends(Ends::Count, count);
  kernel::LaneTable controls(2, count);
  kernel::LaneTable paths(Paths::Count, count);
  for (std::size_t i = 0; i < count; ++i) {
    put_ends(participant_of(problem, ids_[lanes[i]]).hermite, i, ends);
    controls.row(0)[i] = controls_[lanes[i]].m0_m;
    controls.row(1)[i] = controls_[lanes[i]].m1_m;
  }
  ends.pad(count);
  controls.pad(count);
  problem.kernel->interpolate(ends.view(), controls.row(0), controls.row(1), count, paths.table());
  if (count == count_) {
    walk_whole(problem, paths, count, points_);
    return;
  }
  PointTable walked(points_of(problem), count);
  walk_whole(problem, paths, count, walked);
  for (std::size_t i = 0; i < count; ++i) points_.copy_lane(walked, i, lanes[i]);
}

kernel::Peers PeerTable::peers() const {
  return {points_.x_m.view(), points_.y_m.view(), separation_m_.data(), count_};
}

Batch::Batch(const Problem& problem, std::size_t capacity)
    : rules_(problem),
      ends_(Ends::Count, capacity),
      controls_(2, capacity),
      paths_(Paths::Count, capacity),
      chosen_paths_(Paths::Count, capacity),
      verdicts_(Verdicts::Count, capacity) {
  put_ends(problem.own().hermite, 0, ends_);
  ends_.pad(1);
  for (std::size_t lane = 1; lane < capacity; ++lane) ends_.copy_lane(ends_, 0, lane);
  ends_.pad(capacity);
}

void Batch::evaluate(const Problem& problem, std::span<Evaluation> candidates) {
  const std::size_t lanes = candidates.size();
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    controls_.row(0)[lane] = candidates[lane].controls.m0_m;
    controls_.row(1)[lane] = candidates[lane].controls.m1_m;
  }
  controls_.pad(lanes);
  problem.kernel->interpolate(ends_.view(), controls_.row(0), controls_.row(1), lanes, paths_.table());
  problem.kernel->judge(paths_.view(), rules_.rules(), lanes, verdicts_.table());
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    Evaluation& e = candidates[lane];
    const auto penalty = [&](Verdicts::Row r) { return verdicts_.row(r)[lane] > 0.0 ? problem.options.penalty : 0.0; };
    e.length_m = paths_.row(Paths::Length)[lane];
    e.terms = {};
    e.terms.length = e.length_m / problem.length_unit_m;
    e.terms.curve_energy = verdicts_.row(Verdicts::Energy)[lane] * problem.length_unit_m;
    e.terms.unflyable = penalty(Verdicts::Unflyable);
    e.terms.obstacle = penalty(Verdicts::Obstacle);
    e.terms.no_fly = penalty(Verdicts::NoFly);
    e.own = own_cost(e.terms, problem.options.length_weight);
    e.modified = e.own;
  }
}

void Batch::walk(const Problem& problem, std::span<const std::size_t> chosen, PointTable& into) {
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen_paths_.copy_lane(paths_, chosen[i], i);
  chosen_paths_.pad(chosen.size());
  walk_whole(problem, chosen_paths_, chosen.size(), into);
}

void walk_in_parts(const kernel::Kernel& kernel, const ph::PlanarPath& path, std::span<Vec2> points_m) {
  constexpr std::size_t kParts = kernel::kLaneMultiple;
  const std::size_t part = (points_m.size() + kParts - 1) / kParts;
  kernel::LaneTable paths(Paths::Count, kParts);
  PointTable points(part, kParts);
  paths.row(Paths::StartX)[0] = path.start_m().x();
  paths.row(Paths::StartY)[0] = path.start_m().y();
  paths.row(Paths::Length)[0] = path.length_m();
  for (std::size_t k = 0; k < 5; ++k) {
    paths.row(Paths::X + k)[0] = path.x_powers()[k];
    paths.row(Paths::Y + k)[0] = path.y_powers()[k];
    paths.row(Paths::S + k)[0] = path.arc_powers()[k];
    paths.row(Paths::Speed + k)[0] = path.speed_powers()[k];
  }
  paths.pad(1);
  for (std::size_t lane = 0; lane < kParts; ++lane) paths.row(Paths::First)[lane] = static_cast<double>(part * lane);
  kernel.walk(paths.view(), {points_m.size() - 1, part}, kParts, points.x_m.table(), points.y_m.table());
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    points_m[i] = {points.x_m.row(i % part)[i / part], points.y_m.row(i % part)[i / part]};
  }
}

}  // namespace skein::rendezvous
