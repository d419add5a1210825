// What one controller step costs an agent: apf and orca, each with and without the safety filter, on the same scenes.
//
// Agents fly every which way, at one density, in a layer 12 m high, an eighth as many moving spheres among them; each
// gets what is within 24 m out of a spatial index, whose making counts as well. The scenes are what three seconds under
// apf and filter make of a lattice; of small crowds so many that 10000 agents take turns, or the processor would learn
// them by heart. usage: controller_bench [--benchmark_filter=apf_filter/100 ...]
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>

#include "planner/core/neighbours/uniform_grid.hpp"
#include "tests/agent/controller/closed_loop.hpp"

namespace skein {
namespace {

constexpr double kRange_m = 24.0;
constexpr std::size_t kTurns = 10000;
constexpr double kSpacing_m = 14.0;  ///< an agent in a square of this side: nine others are within range

struct Crowd {
  std::vector<Neighbour> agents;
  std::vector<Vec3> places_m;
  std::vector<Vec3> wishes_mps;
  std::vector<Track> tracks;
  std::vector<Vec3> track_places_m;
};

VelocityController controller_of(const char* name, double filter) {
  ControllerOptions options;
  options.name = name;
  options.filter = filter;
  options.sensor_range_m = kRange_m;
  options.obstacle_speed_mps = 5.0;
  return {options, test::multirotor_spec(1), 0.1, 2.0 * kRange_m};
}

/// What an agent sees, in memory that is used again and again.
struct View {
  std::vector<std::uint32_t> near;
  std::vector<Neighbour> neighbours;
  std::vector<Track> tracks;

  Scene of(const Crowd& crowd, std::size_t n, const UniformGrid& agents, const UniformGrid& things, bool movers) {
    const Neighbour& own = crowd.agents[n];
    neighbours.clear();
    tracks.clear();
    agents.within(own.position_m, kRange_m, near);
    for (const std::uint32_t k : near)
      if (k != n) neighbours.push_back(crowd.agents[k]);
    if (movers) {
      things.within(own.position_m, kRange_m, near);
      for (const std::uint32_t k : near) tracks.push_back(crowd.tracks[k]);
    }
    return {own.position_m, own.velocity_mps, neighbours, tracks, {}};
  }
};

/// Jittered lattice.
Crowd lattice(std::size_t n, std::uint64_t seed) {
  Crowd crowd;
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  RandomStream random(seed, 0, Purpose::Test, n);
  const auto any = [&](double most) {
    return Vec3(random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most));
  };
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 corner(static_cast<double>(k % side), static_cast<double>(k / side), 0.0);
    const Vec3 place_m = kSpacing_m * corner + any(5.0);
    crowd.agents.push_back({static_cast<AgentId>(k + 1), place_m, Vec3::Zero(), 0.5, 4.0});
    const Vec3 way = any(1.0);
    crowd.wishes_mps.push_back(10.0 * Vec3(way.x(), way.y(), 0.1 * way.z()).normalized());
    if (k % 8 != 0) continue;
    Track t;
    t.id = static_cast<std::uint32_t>(k + 1);
    t.radius_m = random.uniform(0.5, 2.0);
    t.position_m = kSpacing_m * (corner + Vec3(0.5, 0.5, 0.0)) + any(3.0);
    t.velocity_mps = any(2.8);
    crowd.tracks.push_back(t);
  }
  return crowd;
}

void locate(Crowd& crowd) {
  crowd.places_m.clear();
  crowd.track_places_m.clear();
  for (const Neighbour& agent : crowd.agents) crowd.places_m.push_back(agent.position_m);
  for (const Track& track : crowd.tracks) crowd.track_places_m.push_back(track.position_m);
}

Crowd crowd_of(std::size_t n, std::uint64_t seed) {
  Crowd crowd = lattice(n, seed);
  const VelocityController controller = controller_of("apf", 1.0);
  const VehicleSpec spec = test::multirotor_spec(1);
  View view;
  locate(crowd);
  for (int k = 0; k < 30; ++k) {
    const UniformGrid agents(crowd.places_m, kRange_m);
    const UniformGrid things(crowd.track_places_m, kRange_m);
    std::vector<Neighbour> next = crowd.agents;
    for (std::size_t i = 0; i < n; ++i) {
      const Scene scene = view.of(crowd, i, agents, things, true);
      const Vec3 command_mps = controller.command(scene, crowd.wishes_mps[i]).velocity_mps;
      const VehicleState after =
          advance_multirotor(spec, {scene.position_m, scene.velocity_mps}, command_mps, 0.1).after;
      next[i].position_m = after.position_m;
      next[i].velocity_mps = after.velocity_mps;
    }
    crowd.agents = next;
    for (Track& t : crowd.tracks) t.position_m += 0.1 * t.velocity_mps;
    locate(crowd);
  }
  return crowd;
}

const std::vector<Crowd>& crowds_of(std::size_t n) {
  static std::map<std::size_t, std::vector<Crowd>> made;
  std::vector<Crowd>& crowds = made[n];
  while (crowds.size() * n < kTurns) crowds.push_back(crowd_of(n, crowds.size()));
  return crowds;
}

void step(benchmark::State& state, const char* name, double filter, bool movers) {
  const std::vector<Crowd>& crowds = crowds_of(static_cast<std::size_t>(state.range(0)));
  const VelocityController controller = controller_of(name, filter);
  View view;
  std::size_t overruled = 0;
  std::size_t met = 0;
  std::size_t turn = 0;
  for (auto _ : state) {
    const Crowd& crowd = crowds[turn++ % crowds.size()];
    const UniformGrid agents(crowd.places_m, kRange_m);
    const UniformGrid things(crowd.track_places_m, kRange_m);
    for (std::size_t n = 0; n < crowd.agents.size(); ++n) {
      const Scene scene = view.of(crowd, n, agents, things, movers);
      overruled += controller.command(scene, crowd.wishes_mps[n]).overruled ? 1 : 0;
      met += scene.neighbours.size() + scene.tracks.size();
    }
  }
  const auto steps = static_cast<double>(state.iterations() * state.range(0));
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
