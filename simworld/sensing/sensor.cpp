#include "simworld/sensing/sensor.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/math/det_math.hpp"
#include "planner/core/random/random_stream.hpp"
#include "simworld/sensing/line_of_sight.hpp"

namespace skein {
namespace {

/// A cell whose nearest point is closer than this (m) touches the vehicle: no direction leads to it.
constexpr double kTouch_m = 1e-6;

/// Part of a period by which rounding may make a look late.
constexpr double kOnTime = 1e-9;

struct View {
  double cos_half_horizontal;
  double sin_half_vertical;
  Vec2 heading;
  bool all_around;
};

View view_of(const SensorOptions& options, double heading_rad) {
  const bool around = options.horizontal_fov_rad >= math::kTwoPi && options.vertical_fov_rad >= math::kPi;
  const math::SinCos heading = math::sincos(heading_rad);
  return {math::cos(0.5 * options.horizontal_fov_rad), math::sin(0.5 * options.vertical_fov_rad),
          Vec2(heading.cos, heading.sin), around};
}

bool in_view(const View& view, const Vec3& way_m) {
  if (view.all_around) return true;
  if (std::fabs(way_m.z()) > view.sin_half_vertical * way_m.norm() + kTouch_m) return false;
  const Vec2 level = way_m.head<2>();
  return level.dot(view.heading) >= view.cos_half_horizontal * level.norm() - kTouch_m;
}

double distance_to(const Box& box, const Vec3& p) {
  return (p - p.cwiseMax(box.min_m).cwiseMin(box.max_m)).norm();
}

/// The window of cells that the range can reach.
CellWindow window_around(const CellGrid& grid, const Vec3& at_m, double range_m) {
  const Vec3 reach = Vec3::Constant(range_m);
  const Cell low = grid.cell_of(at_m - reach);
  const Cell high = grid.cell_of(at_m + reach);
  const Cell first{std::max(low.i, 0), std::max(low.j, 0), std::max(low.k, 0)};
  const Cell last{std::min(high.i, grid.nx - 1), std::min(high.j, grid.ny - 1), std::min(high.k, grid.nz - 1)};
  if (last.i < first.i || last.j < first.j || last.k < first.k) return {};
  return CellWindow::of(first, last.i - first.i + 1, last.j - first.j + 1, last.k - first.k + 1);
}

/// What a look makes of a cell that it sees.
CellState reported(bool occupied, bool own, const SensorOptions& options, RandomStream stream) {
  const bool missed = stream.uniform() < options.miss;
  const bool mistaken = stream.uniform() < options.false_alarm;
  if (own) return occupied ? CellState::Occupied : CellState::Free;
  if (missed) return CellState::Unknown;
  return occupied || mistaken ? CellState::Occupied : CellState::Free;
}

/// One look, cell by cell.
class Observer {
 public:
  Observer(const TruthGrid& truth, const SensorOptions& options, std::uint64_t seed, const Look& from)
      : truth_(truth),
        options_(options),
        seed_(seed),
        from_(from),
        own_(truth.grid().cell_of(from.position_m)),
        at_m_(from.position_m),
        view_(view_of(options, from.heading_rad)) {
    const CellGrid& grid = truth.grid();
    if (grid.nz == 1) at_m_.z() = grid.centre_m({0, 0, 0}).z();  // a plane has no height
  }

  [[nodiscard]] bool sees(const Cell& cell) const {
    const Box box = truth_.grid().box_of(cell);
    const double away_m = distance_to(box, at_m_);
    if (away_m > options_.range_m) return false;
    const bool touches = away_m < kTouch_m;
    if (!touches && !in_view(view_, 0.5 * (box.min_m + box.max_m) - at_m_)) return false;
    return cell == own_ || in_sight(truth_, at_m_, cell);
  }

  [[nodiscard]] CellState report(const Cell& cell) const {
    const CellIndex index = truth_.grid().index_of(cell);
    const bool occupied = truth_.occupied(index);
    if (options_.miss <= 0.0 && options_.false_alarm <= 0.0) return occupied ? CellState::Occupied : CellState::Free;
    const std::uint64_t draw = (static_cast<std::uint64_t>(from_.step) << 32) | index;
    return reported(occupied, cell == own_, options_, RandomStream(seed_, from_.agent, Purpose::Sensor, draw));
  }

 private:
  const TruthGrid& truth_;
  const SensorOptions& options_;
  std::uint64_t seed_;
  const Look& from_;
  Cell own_;
  Vec3 at_m_;
  View view_;
};

}  // namespace

bool looks_at(std::uint32_t step, double step_s, double period_s) {
  if (step <= 1 || period_s <= step_s) return true;
  const double now = static_cast<double>(step - 1) * step_s / period_s;
  const double before = static_cast<double>(step - 2) * step_s / period_s;
  return std::floor(now + kOnTime) > std::floor(before + kOnTime);
}

CellWindow look(const TruthGrid& truth, const SensorOptions& options, std::uint64_t seed, const Look& from) {
  CellWindow window = window_around(truth.grid(), from.position_m, options.range_m);
  const Observer observer(truth, options, seed, from);
  for (std::size_t n = 0; n < window.size(); ++n) {
    const Cell cell = window.cell(n);
    if (observer.sees(cell)) window.set(n, observer.report(cell));
  }
  return window;
}

}  // namespace skein
