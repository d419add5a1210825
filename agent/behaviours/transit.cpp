#include "agent/behaviours/transit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace skein {
namespace {

/// Within so many ways of a decision intents are told: each may come one nearer, and plans look two ahead.
constexpr double kCrowdedReaches = 2.1;

/// Over all versions of the lives before this round: one takes less than that many a round (a sample of each peer, a
/// look, marks, and logs of those who came back).
constexpr std::uint32_t kVersions = 1024;

const TransitMission& transit_of(const Mission& mission) {
  if (!mission.transit) throw std::invalid_argument("the mission is no transit");
  return *mission.transit;
}

std::size_t rank_of(const Mission& mission, AgentId id) {
  return static_cast<std::size_t>(&vehicle_of(mission, id) - mission.vehicles.data());
}

AgentMode mode_of(NavStatus status) {
  switch (status) {
    case NavStatus::Arrived:
      return AgentMode::Arrived;
    case NavStatus::Unreachable:
      return AgentMode::Unreachable;
    case NavStatus::Deadlock:
      return AgentMode::Deadlock;
    case NavStatus::Flying:
    case NavStatus::Held:
      break;
  }
  return AgentMode::Flying;
}

const HeardPeer* find_heard(const Sense& sense, AgentId id) {
  const auto found = std::ranges::find(sense.heard, id, &HeardPeer::agent);
  return found == sense.heard.end() ? nullptr : &*found;
}

}  // namespace

TransitBehaviour::TransitBehaviour(const Mission& mission, AgentId self, bool rejoined)
    : mission_(mission),
      self_(self),
      rejoined_(rejoined),
      steps_per_decision_(steps_per_decision(mission)),
      navigator_(mission, self),
      map_(grid_of(transit_of(mission)), self, ids_of(mission)),
      budget_(transit_of(mission).radio, share_of(mission, rank_of(mission, self))) {
  last_.planned_length_m =
      (mission.transit->goals_m.at(rank_of(mission, self)) - vehicle_of(mission, self).start.position_m).norm();
}

bool TransitBehaviour::obey(const Order& order) {
  if (!rejoined_ && doing_ != Doing::Landed) order_ = order;
  return true;
}

void TransitBehaviour::begin(const Order& order, const Sense& sense) {
  const TransitMission& transit = *mission_.transit;
  const Vec3 to_go_m = transit.goals_m[rank_of(mission_, self_)] - sense.pose.position_m;
  if (doing_ == Doing::Mission && to_go_m.norm() <= transit.goal_radius_m) return;  // it has arrived
  switch (order.kind) {
    case OrderKind::Goto: {
      const double most_mps = vehicle_of(mission_, self_).speed_mps;
      navigator_.go_to(order.to_m, order.speed_mps > 0.0 ? std::min(order.speed_mps, most_mps) : most_mps);
      doing_ = Doing::Goto;
      break;
    }
    case OrderKind::Resume:
      if (std::exchange(doing_, Doing::Mission) == Doing::Mission) return;
      navigator_.resume();
      last_.mode = AgentMode::Flying;
      last_.safety_mode = SafetyMode::Autonomous;
      last_.safety_reason = SafetyReason::None;
      break;
    case OrderKind::Hold:
    case OrderKind::Land:
      navigator_.hold();
      doing_ = order.kind == OrderKind::Hold ? Doing::Hold : Doing::Land;
      break;
    default:
      break;
  }
}

/// Whom it obeys, and what became of that.
void TransitBehaviour::report_command() {
  const gridnav::ErrandState state = navigator_.errand().value_or(gridnav::ErrandState::Stays);
  last_.mode = doing_ == Doing::Landed                   ? AgentMode::Landed
               : doing_ == Doing::Land                   ? AgentMode::Landing
               : state == gridnav::ErrandState::UnderWay ? AgentMode::GoingTo
                                                         : AgentMode::Holding;
  last_.safety_mode = SafetyMode::Hold;
  last_.safety_reason = state == gridnav::ErrandState::Short    ? SafetyReason::Blocked
                        : state == gridnav::ErrandState::GaveUp ? SafetyReason::Peer
                                                                : SafetyReason::None;
}

RoundOutput TransitBehaviour::on_round(const RoundInput& input) {
  last_.obstacle_map.reset();
  note_lives(input.tick);
  if (input.tick.phase == Phase::Planning) {
    last_.mode = rejoined_ ? AgentMode::Rejoined : AgentMode::Ready;
  } else if (input.tick.phase == Phase::Flying) {
    if (input.sense == nullptr) throw std::invalid_argument("a flight step needs the agent's own sense sample");
    const Sense& sense = *input.sense;
    listen(input);
    look(sense.sight);
    const std::uint32_t into_decision = (input.tick.step - 1) % steps_per_decision_;
    if (rejoined_) {
      if (into_decision == 0) share(input.tick, sense);
      last_.mode = AgentMode::Rejoined;
      last_.commanded_velocity_mps = sense.velocity_mps;
      return last_;
    }
    if (order_) begin(*std::exchange(order_, std::nullopt), sense);
    if (into_decision == 0) decide(input.tick, sense);
    if (doing_ != Doing::Mission) report_command();
    const double left_s = static_cast<double>(steps_per_decision_ - into_decision) * mission_.step_s;
    last_.commanded_velocity_mps = (decision_.target_m - sense.pose.position_m) / left_s;
  }
  return last_;
}

/// Who came back writes a new log, all in the same round; one of its own life knows of no former one.
void TransitBehaviour::note_lives(const Tick& tick) {
  const bool first = lives_.empty();
  for (const RosterEntry& entry : tick.roster) {
    std::uint32_t& life = lives_.try_emplace(entry.agent, 1U).first->second;
    if (entry.incarnation == std::exchange(life, entry.incarnation)) continue;
    if (entry.agent == self_) {
      map_ = ObstacleMap(grid_of(*mission_.transit), self_, ids_of(mission_), kVersions * tick.round);
      const std::uint32_t decision = tick.step == 0 ? 1 : (tick.step - 1) / steps_per_decision_ + 1;
      silent_until_ = decision + budget_.decisions_per_frame();
    } else if (!first) {
      map_.begin_life(entry.agent, kVersions * tick.round);
    }
  }
}

/// Takes in what the radio carries of the round before, from the last flight step.
void TransitBehaviour::listen(const RoundInput& input) {
  const RadioOptions& radio = mission_.transit->radio;
  for (const ObstacleMapSample& sample : input.maps) {
    const HeardPeer* peer = find_heard(*input.sense, sample.agent);
    if (peer == nullptr || !in_range(radio, peer->position_m, input.sense->pose.position_m)) continue;
    if (is_lost(radio, mission_.seed, sample.agent, self_, input.tick.step - 1, sample.round)) continue;
    receiver_.receive(sample, latency_of(radio));
  }
}

void TransitBehaviour::look(const CellWindow& sight) {
  std::vector<CellChange> seen;
  const CellGrid& grid = map_.grid();
  for (std::size_t n = 0; n < sight.size(); ++n) {
    const CellState state = sight.at(n);
    const Cell cell = sight.cell(n);
    if (state == CellState::Unknown || !grid.contains(cell)) continue;
    const CellIndex index = grid.index_of(cell);
    if (map_.at(index) != state) seen.push_back({index, state});
  }
  if (!seen.empty()) map_.observe(seen);
}

void TransitBehaviour::hear(const Tick& tick) {
  for (const ObstacleMapSample& sample : receiver_.hear(tick.round)) {
    if (mission_.transit->planner.share_maps != 0.0) map_.merge(sample);
  }
}

/// Of one that came back: what it hears and sees, without a decision to fly.
void TransitBehaviour::share(const Tick& tick, const Sense& sense) {
  hear(tick);
  const std::uint32_t decision = (tick.step - 1) / steps_per_decision_ + 1;
  last_.map_hash = map_.map_hash();
  decision_.next.on_behalf_of = self_;
  decision_.next.to_m = sense.pose.position_m;
  if (decision >= silent_until_) last_.obstacle_map = compose(tick, sense, decision);
}

void TransitBehaviour::decide(const Tick& tick, const Sense& sense) {
  const std::uint32_t decision = (tick.step - 1) / steps_per_decision_ + 1;
  hear(tick);
  const std::vector<CellChange> changed = map_.take_changes();
  const std::vector<gridnav::Neighbour> around = neighbours(sense, decision);
  for (const HeardPeer& peer : sense.heard) {
    if (peer.landed) navigator_.forget_held(peer.agent);
  }
  if (doing_ == Doing::Land) doing_ = Doing::Landed;  // at rest from here on
  decision_ = navigator_.decide({decision, sense.pose.position_m, changed, around});
  std::vector<CellChange> marks;
  for (const CellIndex cell : decision_.revisited) marks.push_back({cell, CellState::Revisited});
  if (!marks.empty()) map_.observe(marks);
  last_.mode = mode_of(decision_.status);
  last_.generation = decision;
  last_.cost = std::max(0.0, navigator_.to_go_m());
  last_.map_hash = map_.map_hash();
  last_.obstacle_map = compose(tick, sense, decision);
}

std::vector<gridnav::Neighbour> TransitBehaviour::neighbours(const Sense& sense, std::uint32_t decision) const {
  std::vector<gridnav::Neighbour> around;
  for (const HeardPeer& peer : sense.heard) {
    if (peer.landed) continue;
    gridnav::Neighbour neighbour{peer.agent, peer.position_m, vehicle_of(mission_, peer.agent).radius_m, std::nullopt};
    const ObstacleMapSample* last = receiver_.last_of(peer.agent);
    if (last != nullptr && last->intent.decision == decision) {
      neighbour.intent = last->intent;
      neighbour.intent->from_m = peer.position_m;
    }
    around.push_back(std::move(neighbour));
  }
  return around;
}

/// Whether a UAV is so near that its right of way may hang on the intent; one unheard is kept clear of in any case.
bool TransitBehaviour::is_crowded(const Sense& sense) const {
  if (rejoined_ || doing_ == Doing::Landed || decision_.status == NavStatus::Arrived) return false;
  const double reach_m = vehicle_of(mission_, self_).speed_mps * mission_.transit->planner.decision_s;
  return std::ranges::any_of(sense.heard, [&](const HeardPeer& peer) {
    return !peer.landed && (peer.position_m - sense.pose.position_m).norm() <= kCrowdedReaches * reach_m;
  });
}

std::vector<MapPeer> TransitBehaviour::peers_in_reach(const Sense& sense) const {
  std::vector<MapPeer> peers;
  for (const HeardPeer& peer : sense.heard) {
    if (!in_range(mission_.transit->radio, peer.position_m, sense.pose.position_m)) continue;
    peers.push_back({peer.agent, peer.position_m, mission_.transit->goals_m[rank_of(mission_, peer.agent)]});
  }
  return peers;
}

std::optional<ObstacleMapSample> TransitBehaviour::compose(const Tick& tick, const Sense& sense,
                                                           std::uint32_t decision) {
  const TransitMission& transit = *mission_.transit;
  const Allowance allowance = budget_.at(decision);
  ObstacleMapSample sample;
  sample.intent = decision_.next;
  bool worth_it = is_crowded(sense);
  const std::vector<MapPeer> peers = peers_in_reach(sense);
  if (transit.planner.share_maps != 0.0 && allowance.map_slot && !peers.empty()) {
    MapRequest request;
    request.budget_bytes = allowance.payload_bytes;
    request.round = tick.round;
    request.peers = peers;
    request.range_m = transit.radio.range_m;
    request.latency_rounds = latency_of(transit.radio);
    request.patience_rounds = std::max(4U, 4 * budget_.decisions_per_frame() * steps_per_decision_);
    if (std::optional<MapPart> part = map_.compose(request)) {
      worth_it = worth_it || !part->idle;
      sample.seen = std::move(part->seen);
      sample.tiles = std::move(part->tiles);
    }
  }
  if (!worth_it) return std::nullopt;
  if (allowance.payload_bytes < payload_bytes(0, 0)) {
    budget_.silent();
    return std::nullopt;
  }
  budget_.sent(decision, payload_bytes(sample.tiles.size(), sample.seen.size()));
  return sample;
}

void TransitBehaviour::add_to(StateHash& hash) const {
  navigator_.add_to(hash);
  map_.add_to(hash);
  receiver_.add_to(hash);
  budget_.add_to(hash);
  hash.add(last_.mode).add(last_.commanded_velocity_mps).add(decision_.target_m);
  if (doing_ != Doing::Mission) hash.add(doing_).add(last_.safety_reason);
}

}  // namespace skein
