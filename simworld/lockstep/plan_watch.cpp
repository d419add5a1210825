#include "simworld/lockstep/plan_watch.hpp"

#include <algorithm>

#include "planner/core/lockstep/plan_view.hpp"
#include "simworld/lockstep/answers.hpp"

namespace skein {

void PlanWatch::add(const Opened& open, const Barrier& answers, std::span<const RosterEntry> roster) {
  if (open.phase == Phase::Flying) check(open.step, answers, roster);
  std::vector<const Representative*> published;
  Plan plan{open.round};
  for (const RosterEntry& entry : roster) {
    const Beacon* beacon = own_beacon(answers, entry);
    if (beacon == nullptr || !beacon->representative) continue;
    const auto& sample = answers.answer_of(entry.agent)->representative;
    if (!sample || sample->revision) continue;
    published.push_back(&*sample);
    plan.crew.push_back(entry);
  }
  if (!published.empty()) plans_.insert_or_assign(plan_view_of(std::move(published)), std::move(plan));
}

/// The plan that an agent says it flies, if it is one of the swarm's and its own.
const PlanWatch::Plan* PlanWatch::accepted_plan(const RosterEntry& entry, std::uint64_t view) const {
  const auto found = plans_.find(view);
  if (found == plans_.end()) return nullptr;
  const bool of_crew = std::ranges::any_of(found->second.crew, [&](const RosterEntry& member) {
    return member.agent == entry.agent && member.incarnation == entry.incarnation;
  });
  return of_crew ? &found->second : nullptr;
}

void PlanWatch::check(std::uint32_t step, const Barrier& answers, std::span<const RosterEntry> roster) {
  struct Flown {
    AgentId agent;
    bool on_the_way;
    const Plan* plan;
  };
  std::vector<Flown> all;
  std::uint32_t newest_round = 0;
  for (const RosterEntry& entry : roster) {
    const Beacon* beacon = own_beacon(answers, entry);
    if (beacon == nullptr || beacon->plan_view == 0) continue;
    all.push_back({entry.agent, beacon->mode != AgentMode::Arrived, accepted_plan(entry, beacon->plan_view)});
    const Flown& flown = all.back();
    if (flown.on_the_way && flown.plan != nullptr) newest_round = std::max(newest_round, flown.plan->round);
  }
  for (const Flown& flown : all) {
    const bool newest = flown.plan != nullptr && (!flown.on_the_way || flown.plan->round == newest_round);
    if (newest) continue;
    ++unaccepted_;
    if (!first_) first_ = UnacceptedPlan{flown.agent, step};
  }
}

}  // namespace skein
