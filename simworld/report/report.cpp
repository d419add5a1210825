#include "simworld/report/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "planner/core/lockstep/names.hpp"
#include "simworld/report/flight_report.hpp"
#include "simworld/report/steering_report.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json span_s(double from_s, double to_s) {
  return from_s < 0.0 || to_s < 0.0 ? Json(nullptr) : Json(to_s - from_s);
}

Json per_second(double count, const Json& seconds) {
  return seconds.is_null() || seconds.get<double>() <= 0.0 ? Json(nullptr) : Json(count / seconds.get<double>());
}

std::string vehicle_reason(const VehicleRecord& vehicle, const Run& run) {
  std::string lost;
  for (const RosterChange& change : run.changes()) {
    if (change.agent != vehicle.spec.id) continue;
    lost = change.reason == LossReason::Rejoined ? lost + ", rejoined"
                                                 : fmt::format("agent lost: {}", name_of(change.reason));
  }
  if (!lost.empty()) return lost;
  switch (vehicle.status) {
    case VehicleStatus::Missed:
      return "did not pass through its slot";
    case VehicleStatus::Unreachable:
      return "found no way to its goal";
    case VehicleStatus::Deadlock:
      return "found no way past the others";
    default:
      return "";
  }
}

Json vehicles_of(const Run& run) {
  Json list = Json::array();
  const std::vector<std::optional<double>> shortest_m = run.world().shortest_paths_m();
  for (const VehicleRecord& vehicle : run.world().vehicles()) {
    const auto plan = std::ranges::find(run.plan(), vehicle.spec.id, &PlanFigures::agent);
    const bool arrived = vehicle.arrival_step > 0;
    list.push_back({{"id", vehicle.spec.id},
                    {"pid", nullptr},
                    {"path_length_m", vehicle.flown_m},
                    {"planned_length_m", plan->length_m},
                    {"particle", plan->particle},
                    {"arrival_step", arrived ? Json(vehicle.arrival_step) : Json(nullptr)},
                    {"arrival_time_s", arrived ? Json(vehicle.arrival_time_s) : Json(nullptr)},
                    {"max_curvature_per_m", vehicle.max_curvature_per_m},
                    {"max_torsion_per_m", vehicle.max_torsion_per_m},
                    {"status", name_of(vehicle.status)},
                    {"reason", vehicle_reason(vehicle, run)}});
    if (!shortest_m.empty()) list.back()["shortest_path_m"] = or_null(shortest_m[list.size() - 1]);
  }
  return list;
}

Json separations_of(const World& world) {
  Json list = Json::array();
  for (const PairSeparation& pair : world.separations()) {
    list.push_back({{"a", pair.a}, {"b", pair.b}, {"flown_m", or_null(pair.least_m)}});
  }
  return list;
}

Json changes_of(const Run& run) {
  Json list = Json::array();
  for (const RosterChange& change : run.changes()) {
    list.push_back({{"step", change.step},
                    {"round", change.round},
                    {"agent", change.agent},
                    {"incarnation", change.incarnation},
                    {"reason", name_of(change.reason)}});
  }
  return list;
}

Json topics_of(const TopicCounts& counts) {
  const auto entry = [](const TopicCount& count) { return Json{{"samples", count.samples}, {"bytes", count.bytes}}; };
  return {{"mission", entry(counts.mission)},
          {"tick", entry(counts.tick)},
          {"sense", entry(counts.sense)},
          {"beacon", entry(counts.beacon)},
          {"representative", entry(counts.representative)},
          {"obstacle_map", entry(counts.obstacle_map)}};
}

/// Of each link what was heard and lost; how full the fullest slot was; groups out of each other's reach; the maps.
void add_radio(Json& report, const RadioLog& log) {
  Json links = Json::array();
  for (const auto& [ends, count] : log.counts().links()) {
    links.push_back({{"from", ends.first},
                     {"to", ends.second},
                     {"samples", count.samples},
                     {"bytes", count.bytes},
                     {"lost", count.lost},
                     {"age_p50", count.age_quantile(0.5)},
                     {"age_p95", count.age_quantile(0.95)}});
  }
  report["radio"] = {{"sent_samples", log.sent_samples()}, {"sent_bytes", log.sent_bytes()},
                     {"slot_bits", log.slot_bits()},       {"peak_slot_bits", log.peak_bits()},
                     {"over_budget", log.over_budget()},   {"links", links}};
  Json changes = Json::array();
  for (const PartitionChange& change : log.partitions()) {
    changes.push_back({{"step", change.step}, {"groups", change.groups}});
  }
  report["partitions"] = changes;
  report["map_equal"] = log.equal_since().has_value();
  report["map_equal_since_step"] = or_null(log.equal_since());
}

void add_unaccepted(Json& report, const PlanWatch& watch) {
  report["unaccepted_plans"] = watch.unaccepted();
  report["first_unaccepted_plan"] = nullptr;
  if (watch.first()) report["first_unaccepted_plan"] = {{"agent", watch.first()->agent}, {"step", watch.first()->step}};
}

void add_maps(Json& report, const MapWatch& watch) {
  report["map_settling_steps"] = or_null(watch.settling_steps());
  report["maps_due"] = watch.due();
  report["maps_differ"] = watch.differing();
}

/// A whole number of `least` or more. @throws std::runtime_error
std::uint32_t whole(const nlohmann::json& item, const char* key, std::uint64_t least) {
  const nlohmann::json& value = item.at(key);
  const bool fits = value.is_number_unsigned() && value.get<std::uint64_t>() >= least &&
                    value.get<std::uint64_t>() <= std::numeric_limits<std::uint32_t>::max();
  if (!fits) throw std::runtime_error(fmt::format("{} is no whole number from {}", key, least));
  return value.get<std::uint32_t>();
}

/// Outcome: success, reason, who is missing.
Json outcome_of(const WorldSession& session) {
  const Outcome outcome = session.outcome();
  return {{"success", outcome.exit_code == 0},
          {"exit_code", outcome.exit_code},
          {"reason", outcome.reason},
          {"completed_without",
           session.interrupted() ? std::vector<AgentId>{} : session.run().verdict().completed_without}};
}

/// What was planned on the ground; of a transit, which plans on the way, null. Its own figures instead.
void add_plan(Json& report, const Run& run) {
  const Mission& mission = run.mission();
  if (!mission.transit) {
    const std::optional<double> spread_m = run.plan_spread_m();
    report["planner"] = mission.planner.name;
    report["plan_feasible"] = spread_m.has_value();
    report["plan_success"] = spread_m && *spread_m <= mission.planner.length_tolerance_m;
    report["plan_spread_m"] = or_null(spread_m);
    return;
  }
  const auto& vehicles = run.world().vehicles();
  report["planner"] = mission.transit->planner.name;
  for (const char* key : {"plan_feasible", "plan_success", "plan_spread_m"}) report[key] = nullptr;
  report["arrived"] = std::ranges::count(vehicles, VehicleStatus::Arrived, &VehicleRecord::status);
  report["total_path_m"] = std::accumulate(vehicles.begin(), vehicles.end(), 0.0,
                                           [](double sum, const VehicleRecord& v) { return sum + v.flown_m; });
}

}  // namespace

std::string_view version() {
  return SKEIN_VERSION;
}

Json make_report(const WorldSession& session, const Scenario& scenario, const ReportContext& context) {
  const Run& run = session.run();
  const World& world = run.world();
  const PhaseTimes times = context.wall.value_or(session.times());
  const double planned_s = times.flying_s >= 0.0 ? times.flying_s : times.finished_s;
  const Json plan_s = span_s(times.started_s, planned_s);
  const Json flight_s = span_s(times.flying_s, times.finished_s);

  Json report = outcome_of(session);
  report["state_hash"] = fmt::format("{:016x}", run.state_hash());
  report["seed"] = scenario.mission.seed;
  report["scenario"] = scenario.mission.name;
  report["scenario_hash"] = fmt::format("{:016x}", scenario.scenario_hash);
  report["scenario_path"] = scenario.path;
  report["overrides"] = Json::array();
  for (const Override& item : scenario.overrides) {
    report["overrides"].push_back({{"key", item.key}, {"value", item.value}});
  }
  report["version"] = version();
  report["carrier"] = context.carrier;
  report["fail_fast"] = session.fail_fast();
  add_plan(report, run);
  report["steps"] = run.steps_flown();
  report["rounds"] = run.planning_rounds();
  report["collisions"] = world.count(ContactKind::Vehicles) + world.count(ContactKind::VehicleObstacle) +
                         world.count(ContactKind::NoFly) + world.count(ContactKind::Terrain) +
                         world.count(ContactKind::Hidden) + world.count(ContactKind::Mover);
  report["near_misses"] = world.count(ContactKind::NearMiss);
  add_unaccepted(report, run.plan_watch());
  report["min_separation_m"] = or_null(world.min_separation_m());
  report["min_clearance_m"] = or_null(world.min_clearance_m());
  report["separations"] = separations_of(world);
  report["vehicles"] = vehicles_of(run);
  if (run.radio() != nullptr) add_radio(report, *run.radio());
  if (run.map_watch() != nullptr) add_maps(report, *run.map_watch());
  add_surprises(report, run);
  report["roster_changes"] = changes_of(run);
  add_steering(report, run);
  report["discovery_s"] = span_s(times.created_s, times.started_s);
  report["plan_s"] = plan_s;
  report["rounds_per_s"] = per_second(run.planning_rounds(), plan_s);
  report["steps_per_s"] = per_second(run.steps_flown(), flight_s);
  report["realtime_factor"] = per_second(run.steps_flown() * scenario.mission.step_s, flight_s);
  report["pss_mb_per_agent"] = nullptr;
  report["topics"] = topics_of(session.topics());
  report["late_steps"] = session.late_steps();
  report["world_restarts"] = session.world_restarts();
  report["refused_samples"] = session.refused_samples().total();
  report["lost_samples"] = context.lost_samples;
  return report;
}

std::string replay_obstacle(const nlohmann::json& report, const Scenario& scenario, bool fail_fast) {
  const std::string hash = fmt::format("{:016x}", scenario.scenario_hash);
  if (report.value("scenario_hash", "") != hash) return "it is of another scenario, or of other --set values";
  if (report.value("seed", nlohmann::json()) != nlohmann::json(scenario.mission.seed)) return "it has another seed";
  if (report.value("fail_fast", false) != fail_fast) return "it differs in --fail-fast";
  return "";
}

void write_json(const std::string& path, const nlohmann::ordered_json& json) {
  std::ofstream file(path);
  file << json.dump(2) << "\n";
  file.close();
  if (!file) throw std::runtime_error(fmt::format("cannot write {}", path));
}

std::vector<RosterChange> roster_changes_of(const nlohmann::json& report) {
  const auto list = report.find("roster_changes");
  if (list == report.end() || !list->is_array()) throw std::runtime_error("the report has no list roster_changes");
  std::vector<RosterChange> changes;
  for (const auto& item : *list) {
    try {
      const auto reason = loss_reason_from(item.at("reason").get<std::string>());
      if (!reason) throw std::runtime_error("unknown reason");
      changes.push_back({whole(item, "step", 0), whole(item, "round", 1), whole(item, "agent", 1),
                         whole(item, "incarnation", 1), *reason});
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("roster_changes[{}]: {}", changes.size(), error.what()));
    }
  }
  return changes;
}

}  // namespace skein
