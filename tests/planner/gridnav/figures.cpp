// Prints arrivals and median distances of the twelve swarms of papers/004, Fig. 5, for the planners named.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/planner/gridnav/maps.hpp"

int main(int argc, char** argv) {
  using namespace skein;
  using namespace skein::gridnav;
  for (int a = 1; a < argc; ++a)
    for (const double cell_m : {2.0, 4.0, 6.0}) {
      std::vector<double> lengths_m;
      for (const std::size_t uavs : {3u, 5u, 7u, 9u}) {
        Conditions conditions;
        conditions.planner = argv[a];
        conditions.share = std::getenv("SKEIN_ALONE") == nullptr;
        const Layout layout = power_station(cell_m, uavs);
        const Outcome o = fly(layout, conditions);
        std::vector<double> of_swarm;
        for (const Flight& f : o.flights)
          if (f.status == NavStatus::Arrived) of_swarm.push_back(f.length_m);
        std::sort(of_swarm.begin(), of_swarm.end());
        lengths_m.insert(lengths_m.end(), of_swarm.begin(), of_swarm.end());
        std::printf(
            "%-14s %g m %zu UAVs: %d arrived, %d deadlock, median %.0f m, %u decisions, closest %.2f m, hits %u\n",
            argv[a], cell_m, uavs, o.count(NavStatus::Arrived), o.count(NavStatus::Deadlock),
            of_swarm.empty() ? 0.0 : of_swarm[of_swarm.size() / 2], o.decisions, o.closest_m, o.hits);
      }
      std::sort(lengths_m.begin(), lengths_m.end());
      std::printf("%-14s %g m: %zu of 24, median %.0f m\n", argv[a], cell_m, lengths_m.size(),
                  lengths_m.empty() ? 0.0 : lengths_m[lengths_m.size() / 2]);
    }
  return 0;
}
