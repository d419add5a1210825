// What one controller step costs an agent: apf and orca, each with and without the safety filter, on the same scenes.
//
// Agents fly every which way through space at one density, an eighth of them as many moving spheres among them; each
// gets what is within 24 m out of a spatial index, whose making counts as well. usage: controller_bench
// [--benchmark_...]
#include <benchmark/benchmark.h>

#include <cmath>

#include "planner/core/neighbours/uniform_grid.hpp"
#include "tests/agent/controller/closed_loop.hpp"

namespace skein {
namespace {

constexpr double kRange_m = 24.0;
constexpr double kSpacing_m = 18.0;  ///< an agent in a cube of this side: ten others are within range

struct Crowd {
  std::vector<Neighbour> agents;
  std::vector<Vec3> places_m;
  std::vector<Vec3> wishes_mps;
  std::vector<Track> tracks;
  std::vector<Vec3> track_places_m;
};

/// Jittered lattice: nobody nearer than it takes to brake.
Crowd crowd_of(std::size_t n) {
  Crowd crowd;
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(n))));
  RandomStream random(11, 0, Purpose::Test, n);
  const auto any = [&](double most) {
    return Vec3(random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most));
  };
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 corner(static_cast<double>(k % side), static_cast<double>(k / side % side),
                      static_cast<double>(k / side / side));
    const Vec3 place_m = kSpacing_m * corner + any(6.0);
    crowd.agents.push_back({static_cast<AgentId>(k + 1), place_m, any(3.0), 0.5, 4.0});
    crowd.places_m.push_back(place_m);
    crowd.wishes_mps.push_back(any(5.7));
    if (k % 8 != 0) continue;
    Track t;
    t.id = static_cast<std::uint32_t>(k + 1);
    t.radius_m = random.uniform(0.5, 2.0);
    t.position_m = kSpacing_m * (corner + Vec3::Constant(0.5)) + any(3.0);
    t.velocity_mps = any(2.8);
    crowd.tracks.push_back(t);
    crowd.track_places_m.push_back(t.position_m);
  }
  return crowd;
}

void step(benchmark::State& state, const char* name, double filter, bool movers) {
  const Crowd crowd = crowd_of(static_cast<std::size_t>(state.range(0)));
  ControllerOptions options;
  options.name = name;
  options.filter = filter;
  options.sensor_range_m = kRange_m;
  options.obstacle_speed_mps = 5.0;
  const VelocityController controller(options, test::multirotor_spec(1), 0.1, 2.0 * kRange_m);
  std::vector<std::uint32_t> near;
  std::vector<Neighbour> neighbours;
  std::vector<Track> tracks;
  std::size_t overruled = 0;
  std::size_t met = 0;
  for (auto _ : state) {
    const UniformGrid agents(crowd.places_m, kRange_m);
    const UniformGrid things(crowd.track_places_m, kRange_m);
    for (std::size_t n = 0; n < crowd.agents.size(); ++n) {
      const Neighbour& own = crowd.agents[n];
      neighbours.clear();
      tracks.clear();
      agents.within(own.position_m, kRange_m, near);
      for (const std::uint32_t k : near)
        if (k != n) neighbours.push_back(crowd.agents[k]);
      if (movers) things.within(own.position_m, kRange_m, near);
      if (movers)
        for (const std::uint32_t k : near) tracks.push_back(crowd.tracks[k]);
      const Steering s =
          controller.command({own.position_m, own.velocity_mps, neighbours, tracks, {}}, crowd.wishes_mps[n]);
      overruled += s.overruled ? 1 : 0;
      met += neighbours.size() + tracks.size();
    }
  }
  const auto steps = static_cast<double>(state.iterations()) * static_cast<double>(crowd.agents.size());
  state.counters["s_per_agent"] = benchmark::Counter(steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["near"] = static_cast<double>(met) / steps;
  state.counters["overruled"] = static_cast<double>(overruled) / steps;
}

BENCHMARK_CAPTURE(step, apf_filter, "apf", 1.0, true)->Arg(25)->Arg(100)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(step, orca, "orca", 0.0, true)->Arg(25)->Arg(100)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(step, orca_filter, "orca", 1.0, true)->Arg(25)->Arg(100)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(step, apf_filter_without_movers, "apf", 1.0, false)->Arg(25)->Arg(100)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(step, orca_without_movers, "orca", 0.0, false)->Arg(25)->Arg(100)->Arg(1000)->Arg(10000);

}  // namespace
}  // namespace skein

BENCHMARK_MAIN();
