#include "tests/planner/rendezvous/swarm_run.hpp"

#include <algorithm>

namespace skein::test {

using rendezvous::PlanRound;
using rendezvous::PlanStatus;

bool SwarmRun::all(PlanStatus status) const {
  return std::ranges::all_of(last, [&](const PlanRound& round) { return round.status == status; });
}

double SwarmRun::longest_m() const {
  double longest = 0.0;
  for (const auto& planner : planners) longest = std::max(longest, planner.path_length_m());
  return longest;
}

SwarmRun run_swarm(const Mission& mission, int max_rounds, const Interfere& interfere,
                   const rendezvous::kernel::Kernel& kernel) {
  SwarmRun run;
  run.planners.reserve(mission.vehicles.size());
  for (const VehicleSpec& vehicle : mission.vehicles) run.planners.emplace_back(mission, vehicle.id, kernel);
  for (; run.rounds < max_rounds; ++run.rounds) {
    if (interfere) interfere(run.rounds, run);
    std::vector<PlanRound> next;
    for (std::size_t i = 0; i < run.planners.size(); ++i) {
      std::vector<Representative> peers;
      for (std::size_t j = 0; j < run.last.size(); ++j) {
        if (j != i) peers.push_back(run.last[j].representative);
      }
      next.push_back(run.planners[i].advance(peers));
    }
    run.last = std::move(next);
    if (std::ranges::none_of(run.last, [](const PlanRound& r) { return r.status == PlanStatus::Planning; })) break;
  }
  return run;
}

}  // namespace skein::test
