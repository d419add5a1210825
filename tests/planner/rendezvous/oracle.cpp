#include "tests/planner/rendezvous/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planner/core/geometry/distance.hpp"

namespace skein::test {
namespace {

using rendezvous::ParticipantIn;
using rendezvous::ProblemIn;
using rendezvous::ph::Controls;

constexpr int kNodes = 400;
constexpr int kSamples = 4000;
constexpr std::size_t kAlternatives = 40;

struct Option {
  double cost;
  Controls controls;
};

template <typename Space>
double cost_of(const ProblemIn<Space>& problem, const typename Space::Path& path) {
  const double w1 = problem.options.length_weight;
  return w1 * path.length_m() / problem.length_unit_m +
         (1.0 - w1) * path.elastic_energy_per_m() * problem.length_unit_m;
}

template <typename Space>
bool keeps_constraints(const ProblemIn<Space>& problem, const typename Space::Path& path) {
  for (int i = 0; i <= kSamples; ++i) {
    const double q = static_cast<double>(i) / kSamples;
    if (std::fabs(path.curvature(q)) > problem.max_curvature_per_m) return false;
    const typename Space::Vec here = path.position(q);
    if constexpr (Space::kSpatial) {
      if (std::fabs(path.torsion(q)) > problem.max_torsion_per_m) return false;
      if (problem.terrain && height_above_m(*problem.terrain, here) < problem.terrain_height_m) return false;
    }
    for (const auto& zone : problem.zones) {
      const double distance = std::visit([&](const auto& shape) { return signed_distance(here, shape); }, zone.shape);
      if (distance < problem.keep_out_m) return false;
    }
  }
  return true;
}

template <typename Space>
double node(const ParticipantIn<Space>& uav, int i) {
  return uav.range_m.min + uav.range_m.width() * i / (kNodes - 1);
}

/// Length of the cheapest node that keeps the constraints; 0 if none does.
template <typename Space>
double own_length(const ProblemIn<Space>& problem) {
  std::vector<Option> options;
  for (int i = 0; i < kNodes; ++i) {
    for (int j = 0; j < kNodes; ++j) {
      const Controls m{node(problem.own(), i), node(problem.own(), j)};
      options.push_back({cost_of(problem, problem.own().hermite.path(m)), m});
    }
  }
  std::ranges::sort(options, {}, &Option::cost);
  for (const Option& option : options) {
    const typename Space::Path path = problem.own().hermite.path(option.controls);
    if (keeps_constraints(problem, path)) return path.length_m();
  }
  return 0.0;
}

/// Crossing of an edge with the level curve, by bisection on the length.
template <typename Space>
Controls on_edge(const ParticipantIn<Space>& uav, const Controls& a, const Controls& b, double length_m) {
  double low = 0.0;
  double high = 1.0;
  const auto at = [&](double t) { return Controls{a.m0_m + t * (b.m0_m - a.m0_m), a.m1_m + t * (b.m1_m - a.m1_m)}; };
  const bool rising = uav.hermite.length_m(a) < length_m;
  for (int i = 0; i < 50; ++i) {
    const double t = 0.5 * (low + high);
    ((uav.hermite.length_m(at(t)) < length_m) == rising ? low : high) = t;
  }
  return at(low);
}

/// The cheapest feasible paths of a length, some of them, spread over the level curve.
template <typename Space>
std::vector<typename Space::Path> paths_of_length(const ProblemIn<Space>& problem, double length_m) {
  const ParticipantIn<Space>& uav = problem.own();
  std::vector<Option> options;
  for (int i = 0; i < kNodes; ++i) {
    for (int j = 1; j < kNodes; ++j) {
      for (const bool turned : {false, true}) {
        const Controls a = turned ? Controls{node(uav, j - 1), node(uav, i)} : Controls{node(uav, i), node(uav, j - 1)};
        const Controls b = turned ? Controls{node(uav, j), node(uav, i)} : Controls{node(uav, i), node(uav, j)};
        if ((uav.hermite.length_m(a) < length_m) == (uav.hermite.length_m(b) < length_m)) continue;
        const Controls m = on_edge(uav, a, b, length_m);
        if (std::fabs(uav.hermite.length_m(m) - length_m) > 1e-3) continue;
        options.push_back({cost_of(problem, uav.hermite.path(m)), m});
      }
    }
  }
  std::ranges::sort(options, {}, &Option::cost);
  std::vector<typename Space::Path> paths;
  for (const Option& option : options) {
    const typename Space::Path path = uav.hermite.path(option.controls);
    if (keeps_constraints(problem, path)) paths.push_back(path);
    if (paths.size() == kAlternatives) break;
  }
  return paths;
}

template <typename Path>
bool apart(const Path& a, const Path& b, double least_m) {
  for (int i = 0; i <= 1000; ++i) {
    const double part = i / 1000.0;
    if ((a.position_at(part * a.length_m()) - b.position_at(part * b.length_m())).norm() < least_m) return false;
  }
  return true;
}

/// Whether one path can be chosen for each UAV from `next` on, apart from those chosen before.
template <typename Space>
bool combine(const ProblemIn<Space>& problem, const std::vector<std::vector<typename Space::Path>>& paths,
             std::vector<typename Space::Path>& chosen) {
  const std::size_t next = chosen.size();
  if (next == paths.size()) return true;
  for (const auto& path : paths[next]) {
    bool clear = true;
    for (std::size_t i = 0; i < next && clear; ++i) {
      clear = apart(path, chosen[i], required_separation_m(problem.participants[i], problem.participants[next]));
    }
    if (!clear) continue;
    chosen.push_back(path);
    if (combine(problem, paths, chosen)) return true;
    chosen.pop_back();
  }
  return false;
}

template <typename Space>
OraclePlan best_plan_in(const Mission& mission) {
  OraclePlan plan;
  std::vector<ProblemIn<Space>> problems;
  for (const VehicleSpec& vehicle : mission.vehicles) {
    problems.push_back(rendezvous::make_problem<Space>(mission, vehicle.id));
    plan.own_lengths_m.push_back(own_length(problems.back()));
    if (plan.own_lengths_m.back() == 0.0) return plan;
  }
  plan.length_m = *std::ranges::max_element(plan.own_lengths_m);
  std::vector<std::vector<typename Space::Path>> paths;
  for (const ProblemIn<Space>& problem : problems) paths.push_back(paths_of_length(problem, plan.length_m));
  std::vector<typename Space::Path> chosen;
  plan.found = combine(problems[0], paths, chosen);
  return plan;
}

}  // namespace

OraclePlan best_plan(const Mission& mission) {
  return rendezvous::is_planar(mission) ? best_plan_in<rendezvous::Planar>(mission)
                                        : best_plan_in<rendezvous::Spatial>(mission);
}

}  // namespace skein::test
