#include "groundstation/figure/run_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "idl/convert/cdr.hpp"
#include "idl/convert/convert.hpp"

namespace skein::figure {
namespace {

constexpr std::size_t kPoints = 201;
constexpr double kFlat_m = 1e-6;

bool is_grounded(AgentMode mode) {
  return mode == AgentMode::Arrived || mode == AgentMode::Rejoined || mode == AgentMode::Landed;
}

}  // namespace

template <typename Wire, typename Use>
void RunCollector::take(std::span<const std::uint8_t> payload, const Use& use) {
  const std::optional<Wire> sample = from_cdr<Wire>(payload);
  if (!sample) {
    ++unreadable_;
    return;
  }
  WireContext context;
  if constexpr (!std::is_same_v<Wire, wire::Mission>) {
    if (!run_ || sample->head().run() != *run_) return;
    context.known = ids_;
  }
  auto checked = from_wire(*sample, context);
  if (checked.ok()) {
    use(std::move(checked).value());
  } else {
    ++unreadable_;
  }
}

void RunCollector::add(bus::TopicId topic, std::span<const std::uint8_t> payload) {
  switch (topic) {
    case bus::TopicId::Mission:
      if (run_) return;
      take<wire::Mission>(payload, [&](Mission mission) {
        run_ = from_cdr<wire::Mission>(payload)->head().run();
        mission_ = std::move(mission);
        ids_ = ids_of(mission_);
      });
      return;
    case bus::TopicId::Tick:
      take<wire::Tick>(payload, [&](const Tick& tick) {
        if (tick.phase == Phase::Flying) steps_.try_emplace(tick.round, tick.step);
      });
      return;
    case bus::TopicId::Sense:
      take<wire::Sense>(payload, [&](const Sense& sense) { add_sense(sense); });
      return;
    case bus::TopicId::Beacon:
      take<wire::Beacon>(payload, [&](const Beacon& beacon) { add_beacon(beacon); });
      return;
    case bus::TopicId::Representative:
      take<wire::Representative>(payload, [&](const Representative& sample) {
        if (!sample.particle.empty()) particles_.try_emplace({sample.agent, sample.round}, sample.particle);
      });
      return;
    default:
      return;
  }
}

void RunCollector::add_beacon(const Beacon& beacon) {
  if (beacon.incarnation > 0 && beacon.closes_round) beacons_.try_emplace({beacon.agent, beacon.round}, beacon);
}

void RunCollector::add_sense(const Sense& sense) {
  sensed_.try_emplace({sense.agent, sense.round}, sense.pose.position_m);
  for (const Track& track : sense.tracks) {
    SeenObstacle& seen =
        seen_.try_emplace(track.id, SeenObstacle{track.id, track.radius_m, track.fixed, {}}).first->second;
    std::uint32_t& last = seen_in_[track.id];
    if (last >= sense.round || (seen.fixed && last > 0)) continue;
    last = sense.round;
    seen.places_m.push_back(track.position_m);
  }
}

std::vector<TracePoint> RunCollector::flown_by(AgentId agent) const {
  std::vector<TracePoint> flown;
  for (const auto& [round, step] : steps_) {
    if (!flown.empty() && flown.back().step == step) continue;  // a step of several rounds
    const auto sensed = sensed_.find({agent, round});
    const auto beacon = beacons_.find({agent, round});
    const bool tells = beacon != beacons_.end();
    const bool in_the_air = !tells || !is_grounded(beacon->second.mode);
    if (sensed != sensed_.end()) {
      flown.push_back({step, sensed->second, in_the_air});
    } else if (tells && beacon->second.mode != AgentMode::Rejoined) {
      flown.push_back({step, beacon->second.pose.position_m, in_the_air});
    }
  }
  return flown;
}

std::vector<rendezvous::ProfilePoint> RunCollector::planned_by(AgentId agent) const {
  const std::uint32_t flight = steps_.empty() ? std::numeric_limits<std::uint32_t>::max() : steps_.begin()->first;
  auto last = particles_.lower_bound({agent, flight});
  if (mission_.kind != MissionKind::Rendezvous || last == particles_.begin()) return {};
  --last;
  if (last->first.agent != agent) return {};
  try {
    return rendezvous::path_profile(mission_, {agent, last->second}, kPoints);
  } catch (const std::invalid_argument&) {
    return {};  // it passed the checks of the wire, and is the path of nothing
  }
}

RunData RunCollector::data() const {
  RunData run{mission_, {}, {}};
  for (const auto& [id, seen] : seen_) run.seen.push_back(seen);
  for (const VehicleSpec& spec : mission_.vehicles) {
    VehicleTrace trace{spec, flown_by(spec.id), planned_by(spec.id), {}, 0.0};
    if (!trace.planned.empty()) trace.planned_length_m = trace.planned.back().arc_m;
    const auto end = beacons_.lower_bound({spec.id + 1, 0});
    for (auto entry = beacons_.lower_bound({spec.id, 0}); entry != end; ++entry) {
      const Beacon& beacon = entry->second;
      const bool plans = beacon.mode == AgentMode::Planning && beacon.step == 0;
      const bool is_new = trace.costs.empty() || trace.costs.back().generation < beacon.generation;
      if (plans && is_new) trace.costs.push_back({beacon.generation, beacon.cost});
    }
    run.vehicles.push_back(std::move(trace));
  }
  return run;
}

std::vector<SeparationPoint> separation(const RunData& run) {
  std::map<std::uint32_t, std::vector<std::pair<const VehicleSpec*, Vec3>>> by_step;
  for (const VehicleTrace& vehicle : run.vehicles) {
    for (const TracePoint& point : vehicle.flown) {
      if (point.in_the_air) by_step[point.step].emplace_back(&vehicle.spec, point.position_m);
    }
  }
  std::vector<SeparationPoint> points;
  for (const auto& [step, there] : by_step) {
    SeparationPoint least;
    least.least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < there.size(); ++i) {
      for (std::size_t j = i + 1; j < there.size(); ++j) {
        const double distance_m = (there[i].second - there[j].second).norm();
        if (distance_m >= least.least_m) continue;
        const VehicleSpec& a = *there[i].first;
        const VehicleSpec& b = *there[j].first;
        least = {run.mission.step_s * (step - 1.0),
                 distance_m,
                 a.id,
                 b.id,
                 a.safety_radius_m + b.safety_radius_m,
                 a.radius_m + b.radius_m};
      }
    }
    if (there.size() > 1) points.push_back(least);
  }
  return points;
}

Vec3 end_m(const Mission& mission, std::size_t vehicle) {
  const bool has_goal = mission.transit && vehicle < mission.transit->goals_m.size();
  return has_goal ? mission.transit->goals_m[vehicle] : slot_pose(mission, mission.vehicles[vehicle]).position_m;
}

bool is_planar(const RunData& run) {
  double least_m = std::numeric_limits<double>::infinity();
  double most_m = -least_m;
  const auto take = [&](const Vec3& place_m) {
    least_m = std::min(least_m, place_m.z());
    most_m = std::max(most_m, place_m.z());
  };
  for (std::size_t i = 0; i < run.vehicles.size(); ++i) {
    take(run.vehicles[i].spec.start.position_m);
    take(end_m(run.mission, i));
    for (const TracePoint& point : run.vehicles[i].flown) take(point.position_m);
  }
  return most_m - least_m < kFlat_m;
}

}  // namespace skein::figure
