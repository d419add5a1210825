#include "groundstation/verify/recorded_run.hpp"

#include <algorithm>

#include "groundstation/record/sample_head.hpp"
#include "groundstation/schema/topics.hpp"
#include "idl/convert/convert.hpp"

namespace skein {
namespace {

using bus::TopicId;

const wire::LiveAgent* entry_of(const wire::Tick& tick, AgentId agent, std::uint32_t incarnation) {
  const auto found = std::ranges::find_if(tick.roster(), [&](const wire::LiveAgent& entry) {
    return entry.agent() == agent && entry.incarnation() == incarnation;
  });
  return found == tick.roster().end() ? nullptr : &*found;
}

template <typename Wire>
SampleName name_of(TopicId topic, const Wire& sample) {
  return {sample.round(), topic, sample.agent(), sample.head().incarnation()};
}

}  // namespace

void RecordedRun::add(TopicId topic, std::span<const std::uint8_t> payload) {
  switch (topic) {
    case TopicId::Mission:
      return take<wire::Mission>(topic, payload);
    case TopicId::Tick:
      return take<wire::Tick>(topic, payload);
    case TopicId::Sense:
      return take<wire::Sense>(topic, payload);
    case TopicId::Beacon:
      return take<wire::Beacon>(topic, payload);
    case TopicId::Representative:
      return take<wire::Representative>(topic, payload);
    case TopicId::ObstacleMap:
      return take<wire::ObstacleMap>(topic, payload);
    case TopicId::Inject:
      if (const auto inject = from_cdr<wire::Inject>(payload)) injects_.try_emplace(inject->id(), *inject);
      return;
    case TopicId::Command:
      return;  // what came of it the ticks say
  }
}

template <typename Wire>
void RecordedRun::take(TopicId topic, std::span<const std::uint8_t> payload) {
  const std::optional<Wire> sample = from_cdr<Wire>(payload);
  if (!sample) {
    note_broken(topic, payload);
  } else {
    add_typed(*sample);
  }
}

/// Their heads may be whole.
void RecordedRun::note_broken(TopicId topic, std::span<const std::uint8_t> payload) {
  ++unreadable_;
  const auto head = head_of(topic, payload);
  if (!head || is_other(head->run)) return;
  const SampleName name{head->round, topic, head->agent, topic == TopicId::Tick ? 0 : head->incarnation};
  broken_.try_emplace(topic == TopicId::Mission ? SampleName() : name, payload.begin(), payload.end());
}

bool RecordedRun::is_other(std::uint64_t run) {
  return run_ && run != *run_;
}

template <typename Wire>
void RecordedRun::keep(const SampleName& name, Wire sample) {
  if (is_other(sample.head().run())) return;
  sample.head().run(0);
  sample.head().stamp_ns(0);
  samples_.try_emplace(name, to_cdr(sample));
}

void RecordedRun::add_typed(const wire::Mission& sample) {
  keep({}, sample);
}

void RecordedRun::add_typed(const wire::Tick& sample) {
  if (sample.round() == 0 || is_other(sample.head().run())) return;
  run_ = sample.head().run();
  wire::Tick tick = sample;
  tick.refused().clear();
  tick.given().clear();
  tick.answers().clear();
  for (wire::Ordered& order : tick.commands()) order.id(0);
  for (wire::LiveAgent& entry : tick.roster()) entry.nonce(0);
  if (ticks_.try_emplace(tick.round(), tick).second) add_orders(sample);
  tick.exit_code(0);
  tick.reason("");
  keep({tick.round(), TopicId::Tick, kWorldId, 0}, tick);
}

void RecordedRun::add_orders(const wire::Tick& sample) {
  const Checked<Tick> checked = from_wire(sample, {});
  if (!checked.ok()) return;
  for (const Order& order : checked.value().orders) orders_.push_back({sample.round(), order});
  for (const OrderAnswer& answer : checked.value().answers) {
    const bool is_known = std::ranges::any_of(accepted_, [&](const auto& item) { return item.first == answer.id; });
    if (answer.result == OrderResult::Accepted && !is_known) accepted_.emplace_back(answer.id, answer.round);
  }
}

std::vector<InjectedAt> RecordedRun::injections() const {
  std::vector<InjectedAt> injections;
  for (const auto& [id, round] : accepted_) {
    const auto sample = injects_.find(id);
    if (sample == injects_.end()) continue;
    const Checked<Inject> checked = from_wire(sample->second, {.run = run_, .known = {}, .roster = std::nullopt});
    if (!checked.ok() || checked.value().injection.kind != InjectionKind::Obstacle) continue;
    injections.push_back({round, checked.value().injection});
  }
  return injections;
}

void RecordedRun::add_typed(const wire::Beacon& sample) {
  if (sample.head().incarnation() == 0 || !sample.closes_round()) return;
  wire::Beacon beacon = sample;
  beacon.nonce(0);
  beacon.matched().clear();
  beacon.needs().clear();
  for (std::uint64_t& id : beacon.acknowledged()) id = 0;
  keep(name_of(TopicId::Beacon, beacon), beacon);
}

void RecordedRun::add_typed(const wire::Sense& sample) {
  keep(name_of(TopicId::Sense, sample), sample);
}

void RecordedRun::add_typed(const wire::Representative& sample) {
  keep(name_of(TopicId::Representative, sample), sample);
}

void RecordedRun::add_typed(const wire::ObstacleMap& sample) {
  keep(name_of(TopicId::ObstacleMap, sample), sample);
}

bool RecordedRun::counts(const SampleName& name) const {
  if (name.topic == TopicId::Mission || name.topic == TopicId::Tick) return true;
  const auto own = ticks_.find(name.round);
  if (name.topic == TopicId::Sense) {
    const auto* entry = own == ticks_.end() ? nullptr : entry_of(own->second, name.agent, name.incarnation);
    return entry != nullptr && entry->gets_sense();
  }
  const auto next = ticks_.find(name.round + 1);
  if (next == ticks_.end()) {
    return own != ticks_.end() && own->second.phase() != static_cast<std::uint8_t>(Phase::Finished);
  }
  const auto* entry = entry_of(next->second, name.agent, name.incarnation);
  if (entry == nullptr) return false;
  if (name.topic == TopicId::Representative) return entry->counts_representative();
  return name.topic == TopicId::Beacon || entry->counts_obstacle_map();
}

std::vector<RosterChange> RecordedRun::roster_changes() const {
  std::vector<RosterChange> changes;
  const wire::Tick* before = nullptr;
  for (const auto& [round, tick] : ticks_) {
    if (before != nullptr) {
      for (const wire::LiveAgent& entry : before->roster()) {
        if (entry_of(tick, entry.agent(), entry.incarnation()) != nullptr) continue;
        changes.push_back({tick.step(), round, entry.agent(), entry.incarnation(), LossReason::ProcessEnded});
      }
      for (const wire::LiveAgent& entry : tick.roster()) {
        if (entry_of(*before, entry.agent(), entry.incarnation()) != nullptr) continue;
        changes.push_back({tick.step(), round, entry.agent(), entry.incarnation(), LossReason::Rejoined});
      }
    }
    before = &tick;
  }
  return changes;
}

std::optional<Outcome> RecordedRun::outcome() const {
  if (ticks_.empty()) return std::nullopt;
  const wire::Tick& last = ticks_.rbegin()->second;
  if (last.phase() != static_cast<std::uint8_t>(Phase::Finished)) return std::nullopt;
  return Outcome{last.exit_code(), last.reason().to_string()};
}

RecordedRun run_of(const mcap::Reader& file) {
  RecordedRun run;
  std::map<std::uint16_t, const bus::TopicSpec*> topics;
  for (const auto& [id, channel] : file.contents().channels) topics[id] = schema::topic_named(channel.topic);
  // ticks first: they say which run it is
  for (const bool ticks : {true, false}) {
    file.for_each([&](const mcap::Message& message) {
      const bus::TopicSpec* spec = topics[message.channel_id];
      if (spec != nullptr && (spec->id == TopicId::Tick) == ticks) run.add(spec->id, message.data);
    });
  }
  return run;
}

}  // namespace skein
