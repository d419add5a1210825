#include "groundstation/watch/agent_watch.hpp"

#include <algorithm>
#include <utility>

#include "groundstation/watch/planned_path.hpp"

namespace skein::watch {
namespace {

/// An agent that has sensed nothing yet says zeros.
bool says_where(const Beacon& beacon) {
  return beacon.step > 0 && beacon.incarnation > 0 && !(beacon.pose == Pose{});
}

/// Whether it flies by command, not for its mission.
bool obeys(AgentMode mode) {
  return mode == AgentMode::Holding || mode == AgentMode::GoingTo || mode == AgentMode::Landing ||
         mode == AgentMode::Landed;
}

std::optional<std::size_t> rank_of(const Mission* mission, AgentId id) {
  if (mission == nullptr) return std::nullopt;
  const auto vehicle = std::ranges::find(mission->vehicles, id, &VehicleSpec::id);
  if (vehicle == mission->vehicles.end()) return std::nullopt;
  return static_cast<std::size_t>(vehicle - mission->vehicles.begin());
}

std::optional<Vec3> goal_of(const Mission& mission, std::size_t rank) {
  if (!mission.transit) return slot_pose(mission, mission.vehicles[rank]).position_m;
  if (rank >= mission.transit->goals_m.size()) return std::nullopt;
  return mission.transit->goals_m[rank];
}

}  // namespace

void AgentWatch::arrived(const Arrival& arrival) {
  rate_.add(arrival.now_s, arrival.bytes);
  last_s_ = arrival.now_s;
}

bool AgentWatch::take(const Beacon& beacon, const Arrival& arrival, const StepClock& clock, const Mission* mission) {
  arrived(arrival);
  if (beacon_) {
    const bool newcomer = beacon.incarnation == 0 && beacon_->incarnation > 0;  // it waits until the holder is lost
    const bool old = beacon.incarnation < beacon_->incarnation ||
                     (beacon.incarnation == beacon_->incarnation && beacon.round < beacon_->round);
    const bool again = beacon.incarnation > 0 && beacon.incarnation == beacon_->incarnation &&
                       beacon.round == beacon_->round && beacon_->closes_round && beacon.mode == beacon_->mode;
    if (newcomer || old || again) return false;
    if (beacon.incarnation != beacon_->incarnation) {
      least_delay_ns_.reset();
      speed_mps_.reset();
      if (beacon_->incarnation > 0) beacon_.reset();
    }
  }
  if (beacon.closes_round) count_late(beacon, arrival.stamp_ns, clock);
  note_motion(beacon, mission);
  if (!obeys(beacon.mode)) note_cost(beacon, mission);
  beacon_ = beacon;
  return true;
}

/// Of a rendezvous what the search found: paths that are fitted to each other once it is over keep their generation,
/// and are charged for margins that are not the flight's. By cells each step is a generation.
void AgentWatch::note_cost(const Beacon& beacon, const Mission* mission) {
  if (beacon.cost <= 0.0) return;
  const bool by_search = mission != nullptr && mission->kind == MissionKind::Rendezvous;
  const bool searches = beacon.mode == AgentMode::Planning || beacon.mode == AgentMode::Replanning;
  const CostPoint point{beacon.generation, beacon.cost};
  if (!costs_.empty() && beacon.generation < costs_.last().generation) costs_.clear();  // another search
  if (costs_.empty() || beacon.generation != costs_.last().generation) {
    if (searches || !by_search) costs_.add(point);
  } else if (!by_search) {
    costs_.replace_last(point);
  }
}

void AgentWatch::note_separation(double distance_m, std::uint32_t round) {
  min_separation_m_ = std::min(distance_m, min_separation_m_.value_or(distance_m));
  if (round > nearest_.round) before_ = std::exchange(nearest_, Nearest{round, 0, distance_m});
  if (round != nearest_.round) return;
  ++nearest_.peers;
  nearest_.distance_m = std::min(nearest_.distance_m, distance_m);
}

/// Of the newest round in which as many peers were heard as in the one before.
std::optional<double> AgentWatch::separation_m() const {
  const Nearest& whole = nearest_.peers < before_.peers ? before_ : nearest_;
  const bool over = beacon_ && beacon_->round > nearest_.round + 1;  // nobody else flies any more
  return whole.peers == 0 || over ? std::nullopt : std::optional(whole.distance_m);
}

void AgentWatch::count_late(const Beacon& beacon, std::int64_t stamp_ns, const StepClock& clock) {
  const std::optional<std::int64_t> opened_ns = clock.opened_ns(beacon.round);
  if (!opened_ns) return;
  const std::int64_t delay_ns = stamp_ns - *opened_ns;
  least_delay_ns_ = std::min(delay_ns, least_delay_ns_.value_or(delay_ns));
  const std::optional<double> period_s = clock.period_s();
  if (period_s && static_cast<double>(delay_ns - *least_delay_ns_) * 1e-9 > *period_s) ++late_;
}

void AgentWatch::note_motion(const Beacon& beacon, const Mission* mission) {
  if (!says_where(beacon)) return;
  const Vec3& now_m = beacon.pose.position_m;
  const bool moved_on = beacon_ && says_where(*beacon_) && beacon.step > beacon_->step;
  if (moved_on && mission != nullptr) {
    speed_mps_ = (now_m - beacon_->pose.position_m).norm() / ((beacon.step - beacon_->step) * mission->step_s);
  }
  if (flown_.empty() || !(flown_.last() == now_m)) flown_.add(now_m);
}

void AgentWatch::take(const Representative& representative, const Arrival& arrival) {
  arrived(arrival);
  if (representative.revision) {
    replanned_from_ = representative.revision->pose;
    return;
  }
  if (plan_ && plan_->incarnation == representative.incarnation && representative.round <= plan_->round) return;
  plan_changed_ = plan_changed_ || !plan_ || plan_->particle != representative.particle;
  plan_ = representative;
}

void AgentWatch::take(const ObstacleMapSample& sample, const Arrival& arrival) {
  arrived(arrival);
  intent_ = sample.intent;
}

std::optional<Vec3> AgentWatch::flying_at() const {
  if (!beacon_ || !says_where(*beacon_)) return std::nullopt;
  return beacon_->pose.position_m;
}

AgentView AgentWatch::view(const Mission* mission, double now_s) {
  AgentView view;
  view.id = id_;
  view.heard = beacon_.has_value();
  if (beacon_) {
    view.incarnation = beacon_->incarnation;
    view.mode = beacon_->mode;
    view.constraint = beacon_->constraint;
    view.safety_mode = beacon_->safety_mode;
    view.safety_reason = beacon_->safety_reason;
    view.step = beacon_->step;
    view.round = beacon_->round;
    view.speed_mps = speed_mps_.value_or(beacon_->commanded_velocity_mps.norm());
    view.planned_length_m = beacon_->planned_length_m;
    view.generation = beacon_->generation;
  }
  if (!costs_.empty()) {
    view.cost = costs_.last().cost;
    view.generation = costs_.last().generation;
  }
  view.min_separation_m = min_separation_m_;
  view.rate = rate_.at(now_s);
  if (last_s_) view.age_s = now_s - *last_s_;
  view.late_steps = late_;
  view.flown_m = flown_.entries();
  view.costs = costs_.entries();
  view.position_m = flying_at();
  set_way(view, mission);
  return view;
}

void AgentWatch::set_way(AgentView& view, const Mission* mission) {
  const std::optional<std::size_t> rank = rank_of(mission, id_);
  if (!rank) return;
  if (!view.position_m) view.position_m = mission->vehicles[*rank].start.position_m;
  view.goal_m = goal_of(*mission, *rank);
  if (plan_ && plan_changed_) {
    line_m_ = planned_line(*mission, id_, plan_->particle, replanned_from_);
    plan_changed_ = false;
  }
  const bool elsewhere = beacon_ && obeys(beacon_->mode) && beacon_->mode != AgentMode::Holding;
  if (view.goal_m && !elsewhere) view.to_go_m = (*view.goal_m - *view.position_m).norm();
  if (line_m_.size() >= 2) {
    view.planned_m = line_m_;
    if (elsewhere) return;
    view.to_go_m = left_m(line_m_, *view.position_m);
    view.to_go_by = ToGoBy::Plan;
  } else if (intent_ && mission->transit) {
    view.planned_m = intended_line(*mission, *intent_, *view.position_m);
    if (intent_->to_go_m >= 0.0 && !elsewhere) {
      view.to_go_m = intent_->to_go_m;
      view.to_go_by = ToGoBy::Plan;
    }
  }
}

}  // namespace skein::watch
