#include "simworld/process/progress.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "planner/core/lockstep/names.hpp"

namespace skein {
namespace {

std::string mark_of(const WorldSession& session) {
  const Run& run = session.run();
  return progress_mark(run.phase(), session.introduced(), run.rounds(), run.step());
}

}  // namespace

std::string progress_mark(Phase phase, std::size_t introduced, std::uint32_t round, std::uint32_t step) {
  switch (phase) {
    case Phase::Waiting:
      return fmt::format("waiting {}", introduced);
    case Phase::Planning:
      return fmt::format("planning {}", round / 10);
    case Phase::Flying:
      return fmt::format("flying {}", step / 200);
    case Phase::Finished:
      break;
  }
  return "finished";
}

nlohmann::json progress_of(const WorldSession& session) {
  const Run& run = session.run();
  std::uint32_t generation = 0;
  double longest_m = 0.0;
  for (const PlanFigures& plan : run.plan()) {
    generation = std::max(generation, plan.generation);
    longest_m = std::max(longest_m, plan.length_m);
  }
  const auto arrived = std::ranges::count(run.world().vehicles(), VehicleStatus::Arrived, &VehicleRecord::status);
  return {{"phase", name_of(run.phase())},
          {"introduced", session.introduced()},
          {"matched", session.matched()},
          {"agents", run.mission().vehicles.size()},
          {"round", run.rounds()},
          {"generation", generation},
          {"longest_m", longest_m},
          {"step", run.step()},
          {"time_s", run.step() * run.mission().step_s},
          {"arrived", arrived},
          {"live", run.roster().size()},
          {"mark", mark_of(session)}};
}

void ProgressFeed::show(const WorldSession& session, double now_s) {
  const std::string mark = mark_of(session);
  const bool changed = mark != last_mark_;
  if (!changed && now_s - last_s_ < 0.1) return;
  last_mark_ = mark;
  last_s_ = now_s;
  sink_(progress_of(session), changed);
}

}  // namespace skein
