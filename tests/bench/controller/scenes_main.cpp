// Flies many scenes under the controller and prints what became of them.
//
// usage: controller_scenes random FIRST COUNT [apf|orca] [fastest obstacle, m/s] [sensor range, m] [known u, m/s]
//        controller_scenes swap   FIRST COUNT [apf|orca] UAVS
// Exit code 1 if a UAV touched anything while it moved, 2 if the words make no sense.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/agent/controller/scenes.hpp"

namespace {

using namespace skein;
using namespace skein::test;

struct Sums {
  int collided = 0;  ///< scenes
  int with_peers = 0;
  int rammed = 0;
  int incomplete = 0;
  double way_m = 0.0;  ///< of all UAVs that arrived
  double line_m = 0.0;
  double time_s = 0.0;
  double line_s = 0.0;
  double latest_s = 0.0;
  long arrivals = 0;
  long overruled = 0;
  long steps = 0;
  double least_peer_m = 1e9;
  std::vector<double> least_m;  ///< by scene, to an obstacle
};

double word(int argc, char** argv, int n, double otherwise) {
  return n < argc ? std::atof(argv[n]) : otherwise;
}

void add(Sums& sums, std::uint64_t seed, Loop& loop) {
  std::vector<Vec3> starts_m;
  for (const Flyer& f : loop.flyers) starts_m.push_back(f.state.position_m);
  const Tally t = loop.run(180.0);
  sums.collided += t.collisions > 0 ? 1 : 0;
  sums.with_peers += t.peer_collisions > 0 ? 1 : 0;
  sums.rammed += t.rammed_at_rest > 0 ? 1 : 0;
  const bool all = t.arrived == static_cast<int>(loop.flyers.size());
  sums.incomplete += all ? 0 : 1;
  sums.overruled += t.overruled;
  sums.steps += t.steps;
  sums.least_m.push_back(t.least_m);
  sums.least_peer_m = std::min(sums.least_peer_m, t.least_peer_m);
  if (t.collisions + t.peer_collisions + t.rammed_at_rest > 0 || !all) {
    std::printf("seed %llu: %d collisions, %d with peers, %d rammed at rest, %d of %zu arrived\n",
                static_cast<unsigned long long>(seed), t.collisions, t.peer_collisions, t.rammed_at_rest, t.arrived,
                loop.flyers.size());
  }
  for (std::size_t n = 0; n < loop.flyers.size(); ++n) {
    const Flyer& f = loop.flyers[n];
    if (f.arrival_s < 0.0) continue;
    const double line_m = (f.goal_m - starts_m[n]).norm();
    sums.way_m += f.way_m;
    sums.line_m += line_m;
    sums.time_s += f.arrival_s;
    sums.line_s += line_m / f.spec.speed_mps + f.spec.speed_mps / f.spec.max_acceleration_mps2;
    sums.latest_s = std::max(sums.latest_s, f.arrival_s);
    ++sums.arrivals;
  }
}

void print(Sums& sums) {
  const auto arrivals = static_cast<double>(sums.arrivals);
  std::printf("%zu scenes: collided moving %d, with peers %d, rammed at rest %d, not all arrived %d\n",
              sums.least_m.size(), sums.collided, sums.with_peers, sums.rammed, sums.incomplete);
  std::printf("  mean way %.1f m (straight %.1f m), mean arrival %.1f s (straight %.1f s), latest %.1f s\n",
              sums.way_m / arrivals, sums.line_m / arrivals, sums.time_s / arrivals, sums.line_s / arrivals,
              sums.latest_s);
  std::sort(sums.least_m.begin(), sums.least_m.end());
  const auto part = [&](double p) {
    return sums.least_m[static_cast<std::size_t>(p * static_cast<double>(sums.least_m.size() - 1))];
  };
  std::printf("  least gap to an obstacle, by scene: p1 %.2f p5 %.2f p25 %.2f p50 %.2f m; least between UAVs %.2f m\n",
              part(0.01), part(0.05), part(0.25), part(0.5), sums.least_peer_m);
  std::printf("  the filter had the say in %.1f %% of steps\n",
              100.0 * static_cast<double>(sums.overruled) / static_cast<double>(sums.steps));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string kind = argc > 3 ? argv[1] : "";
  if (kind != "random" && kind != "swap") return 2;
  const auto first = static_cast<std::uint64_t>(std::atoll(argv[2]));
  const auto count = static_cast<std::uint64_t>(std::atoll(argv[3]));
  Sums sums;
  for (std::uint64_t seed = first; seed < first + std::max<std::uint64_t>(1, count); ++seed) {
    Loop loop = kind == "random" ? random_scene(seed, word(argc, argv, 5, 5.0), word(argc, argv, 6, 24.0))
                                 : sphere_swap(seed, static_cast<std::size_t>(word(argc, argv, 5, 16.0)));
    if (argc > 4) loop.options.name = argv[4];
    if (argc > 7) loop.options.obstacle_speed_mps = word(argc, argv, 7, 5.0);
    add(sums, seed, loop);
  }
  print(sums);
  return sums.collided + sums.with_peers > 0 ? 1 : 0;
}
