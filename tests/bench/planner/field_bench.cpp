// One map change: the field repaired against an A* from nothing, on the changes of nine flights across the power
// station, each UAV by its own sensor.
//
// bin/planner_field_bench prints, per size of map, the median and mean of both over all changes, then the benchmarks.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "planner/gridnav/field/goal_field.hpp"
#include "tests/planner/gridnav/maps.hpp"

namespace {

using namespace skein;
using namespace skein::gridnav;

/// What one UAV met: where it was, and what became known there.
struct Change {
  CellIndex at;
  std::vector<CellIndex> occupied;
};

struct Case {
  CellGrid grid;
  Cell goal;
  Cell start;
  std::vector<Change> changes;
};

/// A UAV that walks from start `n` down the field over the station, every wall `levels` high, and sees 24 m around it.
Case walk(const Layout& layout, std::size_t n, double cell_m, std::int32_t levels) {
  Case c;
  c.grid = layout.grid;
  c.grid.nz = levels;
  c.grid.height_m = levels > 1 ? 4.0 : c.grid.height_m;
  c.goal = c.grid.cell_of(Vec3(465, 330, levels > 1 ? 14.0 : 5.0));
  const Vec3 start_m = layout.grid.centre_m(layout.starts[n]);
  c.start = c.grid.cell_of(Vec3(start_m.x(), start_m.y(), levels > 1 ? 14.0 : 5.0));
  GoalField field(c.grid, c.goal, c.start);
  std::vector<bool> known(c.grid.size(), false);
  std::vector<GoalField::Step> steps;
  const auto reach = static_cast<std::int32_t>(24.0 / cell_m);
  for (Cell at = c.start; !(at == c.goal);) {
    Change change{c.grid.index_of(at), {}};
    for (std::int32_t k = 0; k < levels; ++k)
      for (std::int32_t j = -reach; j <= reach; ++j)
        for (std::int32_t i = -reach; i <= reach; ++i) {
          const Cell near{at.i + i, at.j + j, k};
          if (!c.grid.contains(near) || i * i + j * j > reach * reach) continue;
          const CellIndex index = c.grid.index_of(near);
          if (known[index] || !layout.occupied[layout.grid.index_of({near.i, near.j, 0})]) continue;
          known[index] = true;
          change.occupied.push_back(index);
          field.set_blocked(index, true);
        }
    if (!change.occupied.empty()) c.changes.push_back(change);
    field.move_start(change.at);
    if (field.value(change.at) == kInfinite) break;
    field.steps_from(change.at, steps);
    const auto next = std::min_element(steps.begin(), steps.end(), [&](const auto& a, const auto& b) {
      return a.cost + field.settled(a.cell) < b.cost + field.settled(b.cell);
    });
    at = c.grid.cell_at(next->cell);
  }
  return c;
}

/// A* from nothing: a field whose blocked cells are known before it is first asked is just that, from goal to start.
class FromNothing {
 public:
  explicit FromNothing(const Case& c) : case_(c), empty_(c.grid, c.goal, c.start), known_(empty_) {}
  /// @return a field that knows all changes so far and has settled nothing
  GoalField at(const Change& change) {
    for (const CellIndex cell : change.occupied) known_.set_blocked(cell, true);
    GoalField field = known_;
    field.move_start(change.at);
    return field;
  }

 private:
  const Case& case_;
  GoalField empty_;
  GoalField known_;
};

double us_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

/// What the changes of one flight took both ways, and whether the values agree.
struct Times {
  std::vector<double> repair_us;
  std::vector<double> anew_us;
  bool equal = true;
};

void measure(const Case& c, Times& times) {
  GoalField field(c.grid, c.goal, c.start);
  benchmark::DoNotOptimize(field.value(c.grid.index_of(c.start)));
  FromNothing from_nothing(c);
  for (const Change& change : c.changes) {
    auto start = std::chrono::steady_clock::now();
    for (const CellIndex cell : change.occupied) field.set_blocked(cell, true);
    field.move_start(change.at);
    const Cost repaired = field.value(change.at);
    times.repair_us.push_back(us_since(start));
    GoalField anew = from_nothing.at(change);
    start = std::chrono::steady_clock::now();
    const Cost searched = anew.value(change.at);
    times.anew_us.push_back(us_since(start));
    times.equal = times.equal && repaired == searched;
  }
}

void report(const char* name, double cell_m, std::int32_t levels) {
  const Layout layout = power_station(cell_m, 9);
  Times times;
  for (std::size_t n = 0; n < layout.starts.size(); ++n) measure(walk(layout, n, cell_m, levels), times);
  const auto print = [&](const char* what, std::vector<double> us) {
    double sum = 0;
    for (const double u : us) sum += u;
    std::sort(us.begin(), us.end());
    std::printf("%-12s %-10s %zu changes, median %.1f us, mean %.1f us%s\n", name, what, us.size(), us[us.size() / 2],
                sum / static_cast<double>(us.size()), times.equal ? "" : ", VALUES DIFFER");
  };
  print("repair", times.repair_us);
  print("anew", times.anew_us);
}

void repair(benchmark::State& state) {
  const Case c = walk(power_station(4.0, 1), 0, 4.0, static_cast<std::int32_t>(state.range(0)));
  for (auto _ : state) {
    GoalField field(c.grid, c.goal, c.start);
    for (const Change& change : c.changes) {
      for (const CellIndex cell : change.occupied) field.set_blocked(cell, true);
      field.move_start(change.at);
      benchmark::DoNotOptimize(field.value(change.at));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(c.changes.size()));
}
BENCHMARK(repair)->Arg(1)->Arg(5);

}  // namespace

int main(int argc, char** argv) {
  report("250x250", 2.0, 1);
  report("125x125", 4.0, 1);
  report("83x83", 6.0, 1);
  report("125x125x5", 4.0, 5);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
