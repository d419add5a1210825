// Prints what became of N surprises: replan_figures FIRST N [LATE].
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "tests/agent/behaviours/surprise_run.hpp"

int main(int argc, char** argv) {
  const int first = argc > 1 ? std::atoi(argv[1]) : 0;
  const int n = argc > 2 ? std::atoi(argv[2]) : 100;
  const double late = argc > 3 ? std::atof(argv[3]) : 0.8;
  int planned = 0;
  int together = 0;
  int disagreed = 0;
  int again = 0;
  int close = 0;
  double clearance_m = 1e9;
  double separation_m = 1e9;
  for (int seed = first; seed < first + n; ++seed) {
    const skein::test::SurpriseRun run = skein::test::run_surprise(static_cast<std::uint64_t>(seed), late);
    if (!run.planned || !run.surprised) continue;
    ++planned;
    if (run.together) ++together;
    if (!run.agreed) ++disagreed;
    if (run.failures > 0) ++again;
    clearance_m = std::min(clearance_m, run.least_clearance_m);
    separation_m = std::min(separation_m, run.least_separation_m);
    if (run.least_separation_m < 4.0) ++close;
    if (!run.together || run.least_clearance_m < 0.0 || run.least_separation_m < 4.0) {
      fmt::print("seed {}: arrivals {} switches {} failures {} clearance {:.2f} separation {:.2f}\n", seed,
                 run.arrivals, run.switches, run.failures, run.least_clearance_m, run.least_separation_m);
    }
  }
  fmt::print(
      "planned {} together {} disagreed {} with failed attempts {} clearance {:.2f} m separation {:.2f} m, below 4 m "
      "{}\n",
      planned, together, disagreed, again, clearance_m, separation_m, close);
  return 0;
}
