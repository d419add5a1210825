#include "groundstation/record/heard_ends.hpp"

#include <algorithm>

#include "groundstation/record/sample_head.hpp"
#include "idl/convert/cdr.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein {
namespace {

using bus::TopicId;

/// Whether ticks tell of it.
bool is_told(TopicId topic, bool from_world) {
  switch (topic) {
    case TopicId::Mission:
    case TopicId::Tick:
    case TopicId::Sense:
      return true;
    case TopicId::Beacon:
    case TopicId::Representative:
    case TopicId::ObstacleMap:
      return !from_world;
    case TopicId::Command:
    case TopicId::Inject:
      return false;
  }
  return false;
}

}  // namespace

void HeardEnds::note(const bus::RawSample& sample, bool from_world) {
  std::set<Voice>& voices = writers_[sample.writer];
  const auto head = head_of(sample.topic, sample.payload);
  if (!head || !is_told(sample.topic, from_world)) return;
  if (sample.topic == TopicId::Tick) note_tick(sample);
  const bool of_world = sample.topic == TopicId::Mission || sample.topic == TopicId::Tick;
  if (!of_world && head->incarnation == 0) return;  // an introduction
  const Voice voice{sample.topic, of_world ? kWorldId : head->agent, of_world ? 0 : head->incarnation};
  voices.insert(voice);
  Heard& heard = voices_[voice];
  heard.newest = std::max(heard.newest, head->round);
  heard.announced.erase(heard.announced.begin(), heard.announced.upper_bound(heard.newest));
}

void HeardEnds::note_tick(const bus::RawSample& sample) {
  const auto tick = from_cdr<wire::Tick>(sample.payload);
  if (!tick || tick->round() <= round_) return;  // one that waits, or is repeated
  std::set<Listed> roster;
  for (const wire::LiveAgent& entry : tick->roster()) {
    const Listed agent{entry.agent(), entry.incarnation()};
    if (entry.gets_sense()) announce(TopicId::Sense, agent, tick->round(), tick->round());
    if (roster_.contains(agent)) announce(TopicId::Beacon, agent, round_, tick->round() - 1);
    const std::uint32_t before = tick->round() - 1;
    if (entry.counts_representative()) announce(TopicId::Representative, agent, before, before);
    if (entry.counts_obstacle_map()) announce(TopicId::ObstacleMap, agent, before, before);
    roster.insert(agent);
  }
  if (tick->round() != round_ + 1) whole_from_ = tick->round();
  round_ = tick->round();
  finished_ = tick->phase() == static_cast<std::uint8_t>(Phase::Finished);
  roster_ = std::move(roster);
}

void HeardEnds::announce(TopicId topic, const Listed& agent, std::uint32_t first, std::uint32_t last) {
  Heard& heard = voices_[{topic, agent.agent, agent.incarnation}];
  for (std::uint32_t round = std::max(first, heard.newest + 1); round <= last; ++round) heard.announced.insert(round);
}

Tail HeardEnds::of(const bus::WriterKey& writer) const {
  Tail tail;
  const auto known = writers_.find(writer);
  if (known == writers_.end() || known->second.empty()) return tail;
  tail.heard = finished_;
  for (const Voice& voice : known->second) {
    const Heard& heard = voices_.at(voice);
    tail.lost += heard.announced.size();
    // the mission is latched, and read reliably
    const bool ticks_whole = std::get<TopicId>(voice) == TopicId::Mission || whole_from_ <= heard.newest + 1;
    tail.heard = *tail.heard && heard.announced.empty() && ticks_whole;
  }
  return tail;
}

}  // namespace skein
