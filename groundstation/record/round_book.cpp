#include "groundstation/record/round_book.hpp"

#include "groundstation/record/sample_head.hpp"
#include "idl/convert/cdr.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein {
namespace {

using bus::TopicId;

constexpr std::uint32_t kRounds = 3;  ///< kept, the newest included

}  // namespace

void RoundBook::note(TopicId topic, std::span<const std::uint8_t> payload) {
  if (topic == TopicId::Mission || topic == TopicId::Command || topic == TopicId::Inject) return;
  if (topic == TopicId::Tick) return note_tick(payload);
  const auto head = head_of(topic, payload);
  if (!head || head->incarnation == 0 || head->round + kRounds <= round_) return;
  Part& part = parts_[head->round][{head->agent, head->incarnation}];
  if (topic == TopicId::Sense) part.sense = true;
  if (topic == TopicId::Representative) part.representative = true;
  if (topic == TopicId::ObstacleMap) part.obstacle_map = true;
  if (topic != TopicId::Beacon) return;
  const auto beacon = from_cdr<wire::Beacon>(payload);
  if (!beacon || !beacon->closes_round()) return;
  part.beacon = true;
  part.needs_representative = beacon->sent_representative();
  part.needs_obstacle_map = beacon->sent_obstacle_map();
}

void RoundBook::note_tick(std::span<const std::uint8_t> payload) {
  const auto tick = from_cdr<wire::Tick>(payload);
  if (!tick || tick->round() == 0) return;
  if (tick->head().run() != run_) {
    *this = RoundBook();
    run_ = tick->head().run();
  }
  if (tick->round() <= round_) return;
  round_ = tick->round();
  finished_ = tick->phase() == static_cast<std::uint8_t>(Phase::Finished);
  roster_.clear();
  for (const wire::LiveAgent& entry : tick->roster()) {
    roster_.push_back({entry.agent(), entry.incarnation(), entry.gets_sense()});
  }
  std::erase_if(parts_, [this](const auto& entry) { return entry.first + kRounds <= round_; });
}

std::vector<AgentId> RoundBook::lacking() const {
  std::vector<AgentId> agents;
  const auto parts = parts_.find(round_);
  for (const Expected& expected : roster_) {
    Part part;
    if (parts != parts_.end()) {
      const auto found = parts->second.find({expected.agent, expected.incarnation});
      if (found != parts->second.end()) part = found->second;
    }
    const bool whole = part.beacon && (part.sense || !expected.sense) &&
                       (part.representative || !part.needs_representative) &&
                       (part.obstacle_map || !part.needs_obstacle_map);
    if (!whole) agents.push_back(expected.agent);
  }
  return agents;
}

}  // namespace skein
