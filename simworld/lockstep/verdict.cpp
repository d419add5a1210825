#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "planner/core/lockstep/names.hpp"
#include "simworld/lockstep/run.hpp"

namespace skein {
namespace {

/// A zone in the words of the scenario: its place among the obstacles or among the no-fly zones, from 1.
std::string zone_name(const Mission& mission, std::size_t index) {
  const bool no_fly = mission.zones[index].no_fly;
  const auto place =
      std::count_if(mission.zones.begin(), mission.zones.begin() + static_cast<std::ptrdiff_t>(index) + 1,
                    [&](const Zone& zone) { return zone.no_fly == no_fly; });
  return fmt::format("{}.{}", no_fly ? "no_fly" : "obstacles", place);
}

std::string describe(const Contact& contact, const Mission& mission, const World& world) {
  switch (contact.kind) {
    case ContactKind::Vehicles:
      return fmt::format("vehicles {} and {} collided at step {}", contact.vehicle, contact.other, contact.step);
    case ContactKind::NearMiss:
      return fmt::format("vehicles {} and {} came within their safety radii at step {} ({:.1f} m apart)",
                         contact.vehicle, contact.other, contact.step, contact.distance_m);
    case ContactKind::Terrain:
      return fmt::format("vehicle {} touched the terrain at step {}", contact.vehicle, contact.step);
    case ContactKind::Hidden:
      return fmt::format("vehicle {} touched {} at step {}", contact.vehicle, world.hidden()[contact.other].name,
                         contact.step);
    case ContactKind::Mover:
      return fmt::format("vehicle {} collided with {} at step {}", contact.vehicle,
                         world.movers()[contact.other].spec.name, contact.step);
    case ContactKind::Rammed:
      return fmt::format("vehicle {} was rammed at rest by {} at step {}", contact.vehicle,
                         world.movers()[contact.other].spec.name, contact.step);
    case ContactKind::ZoneEntry:
      return fmt::format("vehicle {} was in announced.{}, which was not clear, at step {}", contact.vehicle,
                         contact.other + 1, contact.step);
    default:
      return fmt::format("vehicle {} touched {} at step {}", contact.vehicle, zone_name(mission, contact.other),
                         contact.step);
  }
}

/// The first contact that makes a run unsafe; being rammed at rest only if there is no other.
const Contact* first_unsafe(const World& world) {
  const auto& contacts = world.contacts();
  const auto first = [&](bool rammed) {
    const auto found = std::ranges::find_if(contacts, [&](const Contact& contact) {
      return rammed ? contact.kind == ContactKind::Rammed
                    : contact.kind != ContactKind::NearMiss && contact.kind != ContactKind::Rammed;
    });
    return found == contacts.end() ? nullptr : &*found;
  };
  const Contact* unsafe = first(false);
  return unsafe != nullptr ? unsafe : first(true);
}

/// Of a transit everybody must arrive, in any order; vehicles of lost agents are told of as losses.
std::string transit_failure(const World& world) {
  std::string missing;
  bool any = false;
  for (const VehicleRecord& vehicle : world.vehicles()) {
    any = any || vehicle.status == VehicleStatus::Arrived;
    if (vehicle.status != VehicleStatus::Unreachable && vehicle.status != VehicleStatus::Deadlock &&
        vehicle.status != VehicleStatus::Landed) {
      continue;
    }
    missing += fmt::format("{}vehicle {}: {}", missing.empty() ? "" : ", ", vehicle.spec.id, name_of(vehicle.status));
  }
  return missing.empty() && !any ? "no vehicle arrived" : missing;
}

}  // namespace

std::string Run::mission_failure() const {
  if (!failure_.empty()) return failure_;
  if (mission_.transit) return transit_failure(world_);
  double first_s = 0.0;
  double last_s = 0.0;
  bool any = false;
  for (const VehicleRecord& vehicle : world_.vehicles()) {
    if (vehicle.status == VehicleStatus::Landed) return fmt::format("vehicle {} landed by command", vehicle.spec.id);
    if (vehicle.status == VehicleStatus::Missed) return fmt::format("vehicle {} missed its slot", vehicle.spec.id);
    if (vehicle.status != VehicleStatus::Arrived) continue;
    first_s = any ? std::min(first_s, vehicle.arrival_time_s) : vehicle.arrival_time_s;
    last_s = any ? std::max(last_s, vehicle.arrival_time_s) : vehicle.arrival_time_s;
    any = true;
  }
  if (!any) return "no vehicle arrived";
  if (last_s - first_s > mission_.step_s) return fmt::format("arrivals are {:.2f} s apart", last_s - first_s);
  const auto near = std::ranges::find(world_.contacts(), ContactKind::NearMiss, &Contact::kind);
  return near == world_.contacts().end() ? "" : describe(*near, mission_, world_);
}

Verdict Run::verdict() const {
  if (!finished()) throw std::logic_error("the run is not over");
  Verdict verdict;
  const std::string failure = mission_failure();
  std::string losses;
  for (const RosterChange& change : changes_) {
    const std::string when = fmt::format("at step {}, round {}", change.step, change.round);
    losses += losses.empty() ? "" : "; ";
    if (change.reason == LossReason::Rejoined) {
      losses += fmt::format("agent {} rejoined {}", change.agent, when);
      continue;
    }
    losses += fmt::format("agent {} was lost {}: {}", change.agent, when, name_of(change.reason));
    const bool there = world_.vehicle(change.agent).status == VehicleStatus::Arrived;
    if (failure.empty() && !there) verdict.completed_without.push_back(change.agent);
  }
  std::ranges::sort(verdict.completed_without);
  const auto twice = std::unique(verdict.completed_without.begin(), verdict.completed_without.end());
  verdict.completed_without.erase(twice, verdict.completed_without.end());
  const Contact* hit = first_unsafe(world_);
  if (hit != nullptr) {
    verdict.code = ExitCode::Failed;
    verdict.reason = describe(*hit, mission_, world_);
  } else if (!losses.empty()) {
    verdict.code = ExitCode::AgentLost;
    verdict.reason = losses + "; " +
                     (!failure.empty()                    ? failure
                      : verdict.completed_without.empty() ? "all vehicles arrived"
                                                          : "the others arrived");
  } else if (!failure.empty()) {
    verdict.code = ExitCode::Failed;
    verdict.reason = failure;
  } else {
    verdict.reason = mission_.transit ? "all vehicles arrived" : "all vehicles arrived in formation";
  }
  return verdict;
}

}  // namespace skein
