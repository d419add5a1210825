#include "groundstation/chaos/injection.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace skein::chaos {
namespace {

constexpr std::uint32_t kLeastAway = 5;  ///< steps from a stop to its continuation
constexpr std::uint32_t kMostAway = 20;
constexpr double kSlow_s = 1.5;

/// Any round of planning or step of the flight, the two phases equally often if there is planning to speak of.
Fault at_any_tick(FaultKind what, AgentId agent, const Undisturbed& run, RandomStream& random) {
  const bool planning = run.rounds > 1 && random.uniform() < 0.5;
  return {what, agent, planning ? Phase::Planning : Phase::Flying,
          static_cast<std::uint32_t>(1 + random.below(planning ? run.rounds : run.steps))};
}

/// A stop, and the continuation some steps later; both within the flight if the run is long enough.
std::vector<Fault> stop_and_go(AgentId agent, const Undisturbed& run, RandomStream& random) {
  Fault stop = at_any_tick(FaultKind::Stop, agent, run, random);
  const auto away = static_cast<std::uint32_t>(kLeastAway + random.below(kMostAway - kLeastAway + 1));
  const std::uint32_t latest = run.steps > 2 * away ? run.steps - 2 * away : 1;
  if (stop.phase == Phase::Flying) stop.at = std::min(stop.at, latest);
  const std::uint32_t go = (stop.phase == Phase::Flying ? stop.at : 0U) + away;
  return {stop, {FaultKind::Cont, agent, Phase::Flying, std::min(go, run.steps)}};
}

/// One agent, or half of them (rounded down, one at least), by ascending id.
std::vector<AgentId> one_or_half(const std::vector<AgentId>& agents, RandomStream& random) {
  std::vector<AgentId> left = agents;
  const std::size_t count = random.uniform() < 0.5 ? 1 : std::max<std::size_t>(1, agents.size() / 2);
  std::vector<AgentId> drawn;
  while (drawn.size() < count) {
    const auto place = left.begin() + static_cast<std::ptrdiff_t>(random.below(left.size()));
    drawn.push_back(*place);
    left.erase(place);
  }
  std::ranges::sort(drawn);
  return drawn;
}

/// Shorter or longer than the deadline, equally often; of a longer one the flight lasts beyond the healing.
void draw_partition(const Undisturbed& run, double deadline_s, RandomStream& random, Injection& injection) {
  injection.cut = one_or_half(run.agents, random);
  const bool brief = random.uniform() < 0.5;
  injection.for_s = deadline_s * (brief ? random.uniform(0.05, 0.5) : random.uniform(1.25, 2.5));
  injection.after_s = random.uniform(0.0, 0.8 * kPacedFlight_s);
  const double paced_s = kPacedFlight_s + std::max(0.0, injection.for_s - deadline_s);
  injection.realtime = std::clamp(run.steps * run.step_s / paced_s, 0.1, 1000.0);
}

}  // namespace

Injection draw(const Disturbance& kind, const Undisturbed& run, double deadline_s, RandomStream& random) {
  Injection injection{.kind = kind, .cut = {}, .script = {}};
  const AgentId agent = run.agents[random.below(run.agents.size())];
  const double flight_s = run.steps * run.step_s;
  switch (kind.kind) {
    case Kind::Kill:
      injection.script = {at_any_tick(FaultKind::Kill, agent, run, random)};
      break;
    case Kind::Restart:
      injection.script = {at_any_tick(FaultKind::Restart, agent, run, random)};
      break;
    case Kind::World:
      injection.script = {at_any_tick(FaultKind::Kill, kWorldId, run, random)};
      break;
    case Kind::Stop:
      injection.script = stop_and_go(agent, run, random);
      break;
    case Kind::Pause:
      injection.for_s = deadline_s * random.uniform(0.05, 0.5);
      injection.after_s = random.uniform(0.0, 0.8 * kPacedFlight_s);
      injection.realtime = std::clamp(flight_s / kPacedFlight_s, 0.1, 1000.0);
      break;
    case Kind::Slow:
      injection.for_s = kSlow_s;
      break;
    case Kind::Partition:
      draw_partition(run, deadline_s, random, injection);
      break;
    case Kind::Drop:
    case Kind::Delay:
      break;
  }
  const bool of_agent = kind.kind != Kind::World && !needs_network(kind.kind);
  injection.agent = of_agent ? agent : kWorldId;
  return injection;
}

std::string text_of(const Injection& injection) {
  std::string text;
  for (const Fault& fault : injection.script) {
    if (!text.empty()) text += ' ';
    text += skein::text_of(fault);
  }
  if (!text.empty()) return text;
  if (injection.kind.kind == Kind::Partition) {
    return fmt::format("partition:{} {:.2f} s", fmt::join(injection.cut, ","), injection.for_s);
  }
  if (needs_network(injection.kind.kind)) {
    return fmt::format("{} {}", name_of(injection.kind.kind), injection.kind.amount);
  }
  return fmt::format("{}:{} {:.2f} s", name_of(injection.kind.kind), injection.agent, injection.for_s);
}

}  // namespace skein::chaos
