// Flies many scenes under the controller and prints what became of them.
//
// usage: controller_scenes random FIRST COUNT [apf|orca] [obstacle speed] [sensor range]
//        controller_scenes swap   FIRST COUNT [apf|orca] UAVS
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/agent/controller/scenes.hpp"

namespace {

using namespace skein;
using namespace skein::test;

double number(int argc, char** argv, int n, double otherwise) {
  return n < argc ? std::atof(argv[n]) : otherwise;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const bool random = std::string(argv[1]) == "random";
  const auto first = static_cast<std::uint64_t>(std::atoll(argv[2]));
  const auto count = static_cast<std::uint64_t>(std::atoll(argv[3]));
  int collided = 0;
  int rammed = 0;
  int incomplete = 0;
  int peers = 0;
  double stretch = 0.0;
  double time = 0.0;
  double latest = 0.0;
  long arrivals = 0;
  long overruled = 0, braking = 0, steps = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    Loop loop = random ? random_scene(seed, number(argc, argv, 5, 5.0), number(argc, argv, 6, 24.0))
                       : sphere_swap(seed, static_cast<std::size_t>(number(argc, argv, 5, 16)));
    if (argc > 4) loop.options.name = argv[4];
    const Tally t = loop.run(180.0);
    collided += t.collisions > 0 ? 1 : 0;
    peers += t.peer_collisions > 0 ? 1 : 0;
    rammed += t.rammed_at_rest > 0 ? 1 : 0;
    const bool all = t.arrived == static_cast<int>(loop.flyers.size());
    incomplete += all ? 0 : 1;
    overruled += t.overruled, braking += t.braking, steps += t.steps;
    if (t.collisions || t.rammed_at_rest || t.peer_collisions || !all)
      std::printf("seed %llu: %d collisions, %d with peers, %d rammed at rest, %d of %zu arrived\n",
                  static_cast<unsigned long long>(seed), t.collisions, t.peer_collisions, t.rammed_at_rest, t.arrived,
                  loop.flyers.size());
    for (const Flyer& f : loop.flyers) {
      if (f.arrival_s < 0.0) continue;
      const double line = (f.goal_m - (random ? f.goal_m : f.goal_m)).norm();
      (void)line;
      stretch += f.way_m;
      time += f.arrival_s;
      latest = std::max(latest, f.arrival_s);
      ++arrivals;
    }
  }
  std::printf(
      "%llu scenes: collided %d, peers %d, rammed at rest %d, incomplete %d; mean way %.1f m, arrival %.1f s, "
      "latest %.1f s; overruled %.3f braking %.3f\n",
      static_cast<unsigned long long>(count), collided, peers, rammed, incomplete,
      stretch / static_cast<double>(arrivals), time / static_cast<double>(arrivals), latest,
      static_cast<double>(overruled) / static_cast<double>(steps),
      static_cast<double>(braking) / static_cast<double>(steps));
  return 0;
}
