#include "groundstation/watch/swarm_watch.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "groundstation/watch/events.hpp"
#include "idl/convert/convert.hpp"

namespace skein::watch {
namespace {

constexpr std::size_t kEvents = 500;
constexpr std::size_t kEncapsulation = 4;  ///< bytes of CDR before the sample itself

std::size_t place_of(bus::TopicId topic) {
  return static_cast<std::size_t>(topic);
}

template <typename Wire>
Arrival arrival_of(const Wire& sample, double now_s) {
  return {now_s, sample.head().stamp_ns(), Wire::getCdrSerializedSize(sample) + kEncapsulation};
}

}  // namespace

void SwarmWatch::take(const bus::ObserverInbound& sample, double now_s) {
  std::visit([&](const auto& typed) { on_sample(typed, now_s); }, sample);
}

template <typename Plain, typename Wire>
std::optional<Plain> SwarmWatch::read(const Wire& sample, const Arrival& arrival, bus::TopicId topic) {
  topics_[place_of(topic)].add(arrival.now_s, arrival.bytes);
  Checked<Plain> checked = from_wire(sample, {});
  if (checked.ok()) return std::move(checked).value();
  ++refused_;
  return std::nullopt;
}

void SwarmWatch::on_sample(const wire::Mission& sample, double now_s) {
  std::optional<Mission> mission = read<Mission>(sample, arrival_of(sample, now_s), bus::TopicId::Mission);
  if (!mission) return;
  mission_ = std::move(mission);
  if (mission_->transit && grid_of(*mission_->transit).size() > 0) {
    const CellGrid grid = grid_of(*mission_->transit);
    if (!map_ || !(map_->grid() == grid)) map_.emplace(grid);
  }
}

void SwarmWatch::on_sample(const wire::Tick& sample, double now_s) {
  const Arrival arrival = arrival_of(sample, now_s);
  std::optional<Tick> tick = read<Tick>(sample, arrival, bus::TopicId::Tick);
  if (!tick) return;
  if (tick_ && tick->run != tick_->run) start_anew();
  tick_s_ = now_s;
  const bool older = tick_ && tick->round < tick_->round;
  const bool again = tick_ && tick->round == tick_->round && tick->round > 0 && tick->phase == tick_->phase;
  if (older || again) return;
  log(changes(tick_ ? &*tick_ : nullptr, *tick));
  clock_.take(*tick, arrival.stamp_ns);
  tick_ = std::move(tick);
}

void SwarmWatch::on_sample(const wire::Beacon& sample, double now_s) {
  const Arrival arrival = arrival_of(sample, now_s);
  const std::optional<Beacon> beacon = read<Beacon>(sample, arrival, bus::TopicId::Beacon);
  if (!beacon || beacon->agent == kWorldId || !is_of_run(beacon->run)) return;  // who asks for an id is nobody yet
  AgentWatch& sender = agent(beacon->agent);
  const std::optional<Beacon> before = sender.beacon();
  if (!sender.take(*beacon, arrival, clock_, mission())) return;
  log(changes(before ? &*before : nullptr, *beacon, tick_ ? tick_->time_s : 0.0));
  judge_separations(*beacon);
}

void SwarmWatch::on_sample(const wire::Representative& sample, double now_s) {
  const Arrival arrival = arrival_of(sample, now_s);
  const auto plain = read<Representative>(sample, arrival, bus::TopicId::Representative);
  if (plain && is_of_run(plain->run)) agent(plain->agent).take(*plain, arrival);
}

void SwarmWatch::on_sample(const wire::ObstacleMap& sample, double now_s) {
  const Arrival arrival = arrival_of(sample, now_s);
  const auto plain = read<ObstacleMapSample>(sample, arrival, bus::TopicId::ObstacleMap);
  if (!plain || !is_of_run(plain->run)) return;
  agent(plain->agent).take(*plain, arrival);
  if (map_) map_->merge(plain->tiles);
}

void SwarmWatch::start_anew() {
  SwarmWatch fresh;
  fresh.topics_ = topics_;
  fresh.refused_ = refused_;
  fresh.mission_ = std::move(mission_);  // its world sends it before its first tick
  if (map_) fresh.map_.emplace(map_->grid());
  *this = std::move(fresh);
}

bool SwarmWatch::is_landed(const Beacon& beacon) const {
  return mission_ && mission_->transit && beacon.mode == AgentMode::Arrived;
}

void SwarmWatch::judge_separations(const Beacon& beacon) {
  AgentWatch& own = agent(beacon.agent);
  const std::optional<Vec3> at_m = own.flying_at();
  if (!at_m || is_landed(beacon)) return;
  for (auto& [id, other] : agents_) {
    if (id == beacon.agent || !other.beacon() || other.beacon()->round != beacon.round) continue;
    const std::optional<Vec3> other_at_m = other.flying_at();
    if (!other_at_m || is_landed(*other.beacon())) continue;
    const double distance_m = (*other_at_m - *at_m).norm();
    own.note_separation(distance_m, beacon.round);
    other.note_separation(distance_m, beacon.round);
    note_nearness(beacon, id, distance_m);
  }
}

void SwarmWatch::note_nearness(const Beacon& beacon, AgentId other, double distance_m) {
  if (!mission_) return;
  const auto own_spec = std::ranges::find(mission_->vehicles, beacon.agent, &VehicleSpec::id);
  const auto other_spec = std::ranges::find(mission_->vehicles, other, &VehicleSpec::id);
  if (own_spec == mission_->vehicles.end() || other_spec == mission_->vehicles.end()) return;
  const std::pair<AgentId, AgentId> pair = std::minmax(beacon.agent, other);
  const auto note = [&](auto& known, double limit_m, EventKind kind) {
    if (distance_m >= limit_m) {
      known.erase(pair);
    } else if (known.insert(pair).second) {
      log({{tick_ ? tick_->time_s : 0.0, beacon.step, beacon.round, pair.first, kind,
            fmt::format("agent {}", pair.second), fmt::format("{:.2f} m", distance_m)}});
    }
  };
  note(near_, own_spec->safety_radius_m + other_spec->safety_radius_m, EventKind::NearMiss);
  note(touching_, own_spec->radius_m + other_spec->radius_m, EventKind::Collision);
}

void SwarmWatch::log(std::vector<Event> events) {
  std::ranges::move(events, std::back_inserter(events_));
  while (events_.size() > kEvents) events_.pop_front();
}

bool SwarmWatch::is_live(AgentId id) const {
  return tick_ && std::ranges::find(tick_->roster, id, &RosterEntry::agent) != tick_->roster.end();
}

bool SwarmWatch::complete() const {
  if (!tick_ || !mission_) return false;
  return std::ranges::all_of(tick_->roster, [&](const RosterEntry& entry) {
    const auto known = agents_.find(entry.agent);
    return known != agents_.end() && known->second.beacon().has_value();
  });
}

}  // namespace skein::watch
