#include "groundstation/record/tap.hpp"

#include <utility>

namespace skein {
namespace {

using bus::TopicId;

TopicId topic_of_typed(const wire::Mission&) {
  return TopicId::Mission;
}
TopicId topic_of_typed(const wire::Tick&) {
  return TopicId::Tick;
}
TopicId topic_of_typed(const wire::Sense&) {
  return TopicId::Sense;
}
TopicId topic_of_typed(const wire::Beacon&) {
  return TopicId::Beacon;
}
TopicId topic_of_typed(const wire::Representative&) {
  return TopicId::Representative;
}
TopicId topic_of_typed(const wire::ObstacleMap&) {
  return TopicId::ObstacleMap;
}

TopicId topic_of_typed(const wire::Command&) {
  return TopicId::Command;
}
TopicId topic_of_typed(const wire::Inject&) {
  return TopicId::Inject;
}

}  // namespace

bus::TopicId topic_of(const wire::Sample& sample) {
  return std::visit([](const auto& typed) { return topic_of_typed(typed); }, sample);
}

Bytes payload_of(const wire::Sample& sample) {
  return std::visit([](const auto& typed) { return to_cdr(typed); }, sample);
}

bus::Tap tap_into(TakeSample take) {
  return [take = std::move(take)](AgentId from, const wire::Sample& sample) {
    const Bytes payload = payload_of(sample);
    take({topic_of(sample), from == kWorldId, 0, payload});
  };
}

}  // namespace skein
