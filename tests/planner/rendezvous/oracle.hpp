// What the best possible plan is, found without any swarm: the yardstick of the optimum tests.
//
// For each UAV the nodes of a 400 x 400 grid of (m0, m1) are taken in the order of their own cost (Eq. 11) until one
// keeps all constraints at 4000 points (in space torsion and terrain among them): its length is the UAV's own. The
// common length is the longest of these; every other UAV is put on its level curve by bisection along the edges of the
// grid, and the cheapest combination in which all keep apart is taken. Written apart from the planner on purpose: of it
// only paths and the mission are used.
#pragma once

#include <vector>

#include "planner/rendezvous/cost/problem.hpp"

namespace skein::test {

struct OraclePlan {
  bool found = false;
  double length_m = 0.0;
  std::vector<double> own_lengths_m;
};

[[nodiscard]] OraclePlan best_plan(const Mission& mission);

}  // namespace skein::test
