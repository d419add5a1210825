#include "tests/planner/gridnav/swarm_world.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <queue>
#include <stdexcept>

#include "planner/core/geometry/closest_approach.hpp"
#include "planner/core/random/random_stream.hpp"

namespace skein::gridnav {
namespace {

bool occupied(const Layout& layout, const Cell& c) {
  return !layout.grid.contains(c) || layout.occupied[layout.grid.index_of(c)];
}

/// Whether no occupied cell lies between p and the centre of a cell; a line through a corner passes it.
bool in_sight(const Layout& layout, const Vec3& p, const Cell& to) {
  const CellGrid& g = layout.grid;
  const Vec3 q = g.centre_m(to);
  const double edge[3] = {g.cell_m, g.cell_m, g.height_m};
  Cell c = g.cell_of(p);
  while (!(c == to)) {
    std::int32_t* at[3] = {&c.i, &c.j, &c.k};
    const std::int32_t goal[3] = {to.i, to.j, to.k};
    double cross[3];
    double first = 1e9;
    for (int a = 0; a < 3; ++a) {
      cross[a] = 1e9;
      if (*at[a] == goal[a]) continue;
      const double wall = g.origin_m[a] + (*at[a] + (goal[a] > *at[a] ? 1 : 0)) * edge[a];
      cross[a] = (wall - p[a]) / (q[a] - p[a]);
      first = std::min(first, cross[a]);
    }
    for (int a = 0; a < 3; ++a)
      if (cross[a] <= first + 1e-9) *at[a] += goal[a] > *at[a] ? 1 : -1;
    if (!(c == to) && occupied(layout, c)) return false;
  }
  return true;
}

/// Whether a body that flies from a to b enters an occupied cell; by samples of the exact distance to boxes.
bool hits(const Layout& layout, const Vec3& a, const Vec3& b, double radius_m) {
  const CellGrid& g = layout.grid;
  const Vec3 reach = Vec3(radius_m, radius_m, g.nz == 1 ? 0.0 : radius_m);
  const Cell low = g.cell_of(a.cwiseMin(b) - reach);
  const Cell high = g.cell_of(a.cwiseMax(b) + reach);
  for (std::int32_t k = low.k; k <= high.k; ++k)
    for (std::int32_t j = low.j; j <= high.j; ++j)
      for (std::int32_t i = low.i; i <= high.i; ++i) {
        if (!occupied(layout, {i, j, k})) continue;
        const Box box = g.box_of({i, j, k});
        for (int n = 0; n <= 200; ++n) {
          Vec3 d = a + (n / 200.0) * (b - a);
          d = d - d.cwiseMax(box.min_m).cwiseMin(box.max_m);
          if (g.nz == 1) d.z() = 0.0;
          if (d.norm() < radius_m - 1e-6) return true;
        }
      }
  return false;
}

struct Vehicle {
  AgentId id;
  std::unique_ptr<Navigator> navigator;
  Vec3 position_m;
  Vec3 target_m;
  std::vector<bool> known;
  std::vector<CellChange> news;
  Intent sent;
  bool has_sent = false;
  bool landed = false;
};

class World {
 public:
  World(const Layout& layout, const Conditions& conditions) : layout_(layout), conditions_(conditions) {
    const Mission mission = mission_of(layout, conditions);
    for (const VehicleSpec& spec : mission.vehicles) {
      Vehicle v;
      v.id = spec.id;
      v.navigator = std::make_unique<Navigator>(mission, spec.id);
      v.position_m = v.target_m = spec.start.position_m;
      v.known.assign(layout.grid.size(), false);
      vehicles_.push_back(std::move(v));
    }
    outcome_.flights.resize(vehicles_.size());
  }

  Outcome run() {
    StateHash hash;
    for (std::uint32_t k = 1; k <= conditions_.most_decisions && !ended(k); ++k) {
      for (const Told& told : conditions_.told)
        if (told.decision == k) tell(told);
      for (Vehicle& v : vehicles_)
        if (!v.landed) sense(v);
      decide(k);
      judge();
      for (Vehicle& v : vehicles_) v.navigator->add_to(hash);
      outcome_.decisions = k;
    }
    outcome_.hash = hash.value();
    return outcome_;
  }

 private:
  void tell(const Told& told) {
    Vehicle& v = vehicles_.at(told.id - 1);
    if (v.landed) return;
    if (told.what == Told::What::Hold) v.navigator->hold();
    if (told.what == Told::What::Resume) v.navigator->resume();
    if (told.what == Told::What::Goto) v.navigator->go_to(told.point_m, told.speed_mps);
  }

  [[nodiscard]] bool ended(std::uint32_t k) const {
    const auto to_come = [&](const Told& told) { return told.decision >= k; };
    if (std::any_of(conditions_.told.begin(), conditions_.told.end(), to_come)) return false;
    return std::all_of(outcome_.flights.begin(), outcome_.flights.end(),
                       [](const Flight& f) { return f.status != NavStatus::Flying; });
  }

  void tell(Vehicle& v, const CellChange& change) {
    if (v.known[change.cell] && change.state != CellState::Revisited) return;
    v.known[change.cell] = true;
    v.news.push_back(change);
  }

  void tell_all(Vehicle& v, const CellChange& change) {
    if (!conditions_.share) return tell(v, change);
    for (Vehicle& other : vehicles_) tell(other, change);
  }

  void sense(Vehicle& v) {
    const CellGrid& g = layout_.grid;
    const Vec3 reach = Vec3::Constant(conditions_.sensor_m);
    const Cell low = g.cell_of(v.position_m - reach);
    const Cell high = g.cell_of(v.position_m + reach);
    for (std::int32_t k = std::max(low.k, 0); k <= std::min(high.k, g.nz - 1); ++k)
      for (std::int32_t j = std::max(low.j, 0); j <= std::min(high.j, g.ny - 1); ++j)
        for (std::int32_t i = std::max(low.i, 0); i <= std::min(high.i, g.nx - 1); ++i) {
          const Cell c{i, j, k};
          const CellIndex index = g.index_of(c);
          if (v.known[index] || (g.centre_m(c) - v.position_m).norm() > conditions_.sensor_m) continue;
          if (!in_sight(layout_, v.position_m, c)) continue;
          tell_all(v, {index, layout_.occupied[index] ? CellState::Occupied : CellState::Free});
        }
  }

  [[nodiscard]] std::vector<Neighbour> heard_by(const Vehicle& v, std::uint32_t k) const {
    std::vector<Neighbour> neighbours;
    for (const Vehicle& other : vehicles_) {
      if (other.id == v.id || other.landed) continue;
      Neighbour n{other.id, other.position_m, conditions_.radius_m, std::nullopt};
      RandomStream stream(conditions_.seed, other.id * 1000 + v.id, Purpose::Test, k);
      if (other.has_sent && other.sent.decision == k && stream.uniform() >= conditions_.loss) n.intent = other.sent;
      neighbours.push_back(n);
    }
    return neighbours;
  }

  void decide(std::uint32_t k) {
    std::vector<NavDecision> decisions(vehicles_.size());
    for (std::size_t n = 0; n < vehicles_.size(); ++n) {
      Vehicle& v = vehicles_[n];
      if (v.landed) continue;
      const std::vector<Neighbour> neighbours = heard_by(v, k);
      decisions[n] = v.navigator->decide({k, v.position_m, v.news, neighbours});
      v.news.clear();
    }
    for (std::size_t n = 0; n < vehicles_.size(); ++n) {
      Vehicle& v = vehicles_[n];
      if (v.landed) continue;
      v.target_m = decisions[n].target_m;
      v.sent = decisions[n].next;
      v.has_sent = true;
      v.landed = decisions[n].status == NavStatus::Arrived;
      outcome_.flights[n].status = decisions[n].status;
      for (const CellIndex cell : decisions[n].revisited)
        if (!layout_.occupied[cell]) tell_all(v, {cell, CellState::Revisited});
    }
  }

  void judge() {
    for (std::size_t n = 0; n < vehicles_.size(); ++n) {
      Vehicle& v = vehicles_[n];
      if (v.landed) continue;
      for (std::size_t m = 0; m < n; ++m) {
        const Vehicle& o = vehicles_[m];
        if (o.landed) continue;
        // `o` has moved already: its start is the last place of its record.
        const Vec3 o_start = outcome_.flights[m].places_m.back();
        const double apart = closest_approach(v.position_m, v.target_m, o_start, o.target_m).distance_m;
        outcome_.closest_m = std::min(outcome_.closest_m, apart);
      }
      outcome_.flights[n].places_m.push_back(v.position_m);
      if (hits(layout_, v.position_m, v.target_m, conditions_.radius_m)) ++outcome_.hits;
      outcome_.flights[n].length_m += (v.target_m - v.position_m).norm();
      v.position_m = v.target_m;
    }
  }

  const Layout& layout_;
  const Conditions& conditions_;
  std::vector<Vehicle> vehicles_;
  Outcome outcome_;
};

}  // namespace

int Outcome::count(NavStatus status) const {
  return static_cast<int>(
      std::count_if(flights.begin(), flights.end(), [status](const Flight& f) { return f.status == status; }));
}

Layout drawn(const std::vector<std::string>& rows, double cell_m) {
  Layout layout;
  const auto ny = static_cast<std::int32_t>(rows.size());
  const auto nx = static_cast<std::int32_t>(rows.front().size());
  layout.grid = {Vec3::Zero(), cell_m, cell_m, nx, ny, 1};
  layout.occupied.assign(layout.grid.size(), false);
  for (std::int32_t j = 0; j < ny; ++j)
    for (std::int32_t i = 0; i < nx; ++i) {
      const char mark = rows[static_cast<std::size_t>(ny - 1 - j)][static_cast<std::size_t>(i)];
      const Cell c{i, j, 0};
      if (mark == '#') layout.occupied[layout.grid.index_of(c)] = true;
      if (mark >= 'a' && mark <= 'z') {
        layout.starts.resize(std::max(layout.starts.size(), static_cast<std::size_t>(mark - 'a' + 1)));
        layout.starts[static_cast<std::size_t>(mark - 'a')] = c;
      }
      if (mark >= 'A' && mark <= 'Z') {
        layout.goals_m.resize(std::max(layout.goals_m.size(), static_cast<std::size_t>(mark - 'A' + 1)));
        layout.goals_m[static_cast<std::size_t>(mark - 'A')] = layout.grid.centre_m(c);
      }
    }
  return layout;
}

Mission mission_of(const Layout& layout, const Conditions& conditions) {
  const CellGrid& g = layout.grid;
  Mission mission;
  mission.kind = MissionKind::Transit;
  TransitMission transit;
  transit.area = {g.origin_m, g.origin_m + Vec3(g.nx * g.cell_m, g.ny * g.cell_m, g.nz * g.height_m)};
  transit.goals_m = layout.goals_m;
  transit.goal_radius_m = conditions.goal_radius_m;
  transit.planner.name = conditions.planner;
  transit.planner.cell_m = g.cell_m;
  transit.planner.cell_height_m = g.height_m;
  transit.planner.patience = conditions.patience;
  transit.sensor.range_m = conditions.sensor_m;
  mission.transit = transit;
  for (std::size_t n = 0; n < layout.starts.size(); ++n) {
    VehicleSpec spec;
    spec.id = static_cast<AgentId>(n + 1);
    spec.start.position_m = g.centre_m(layout.starts[n]);
    spec.speed_mps = conditions.speed_mps;
    spec.radius_m = conditions.radius_m;
    mission.vehicles.push_back(spec);
  }
  return mission;
}

Outcome fly(const Layout& layout, const Conditions& conditions) {
  return World(layout, conditions).run();
}

double shortest_m(const Layout& layout, const Cell& from, const Cell& to) {
  const CellGrid& g = layout.grid;
  if (occupied(layout, from) || occupied(layout, to)) return -1.0;
  std::vector<double> best(g.size(), 1e18);
  using Item = std::pair<double, CellIndex>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  best[g.index_of(from)] = 0.0;
  queue.push({0.0, g.index_of(from)});
  while (!queue.empty()) {
    const auto [length, index] = queue.top();
    queue.pop();
    const Cell c = g.cell_at(index);
    if (c == to) return length;
    if (length > best[index]) continue;
    for (std::int32_t n = 0; n < 27; ++n) {
      const Cell d{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
      bool open = true;
      for (int part = 0; part < 8; ++part)
        open = open && !occupied(layout, {c.i + ((part & 1) != 0 ? d.i : 0), c.j + ((part & 2) != 0 ? d.j : 0),
                                          c.k + ((part & 4) != 0 ? d.k : 0)});
      if (!open) continue;
      const CellIndex next = g.index_of({c.i + d.i, c.j + d.j, c.k + d.k});
      const double total = length + Vec3(d.i * g.cell_m, d.j * g.cell_m, d.k * g.height_m).norm();
      if (total >= best[next]) continue;
      best[next] = total;
      queue.push({total, next});
    }
  }
  return -1.0;
}

}  // namespace skein::gridnav
