#include "groundstation/record/sample_head.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace skein {
namespace {

constexpr std::size_t kEncapsulation = 4;
constexpr std::size_t kSender = 16;  // after run and stamp, 8 bytes each; all from the end of the encapsulation
constexpr std::size_t kIncarnation = 20;
constexpr std::size_t kAgent = 24;

/// Where the round stands: after agent; of a tick after step; of a beacon after agent, nonce (aligned to 8) and step.
std::size_t round_at(bus::TopicId topic) {
  return topic == bus::TopicId::Beacon ? 44 : 28;
}

template <typename Number>
Number number_at(std::span<const std::uint8_t> payload, std::size_t at) {
  const bool little = payload[1] == 1;
  Number number = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    const std::size_t byte = little ? sizeof(Number) - 1 - i : i;
    number = static_cast<Number>(number << 8U | payload[kEncapsulation + at + byte]);
  }
  return number;
}

}  // namespace

std::string writer_of(bus::TopicId topic, bool from_world, AgentId agent) {
  if (bus::topic(topic).writers == bus::kObserverRole) return "ground station";
  return from_world ? "world" : fmt::format("agent {}", agent);
}

std::optional<SampleHead> head_of(bus::TopicId topic, std::span<const std::uint8_t> payload) {
  const bool is_mission =  // or of no round either
      topic == bus::TopicId::Mission || topic == bus::TopicId::Command || topic == bus::TopicId::Inject;
  const std::size_t end = is_mission ? kAgent : round_at(topic) + sizeof(std::uint32_t);
  if (payload.size() < kEncapsulation + end) return std::nullopt;
  SampleHead head;
  head.run = number_at<std::uint64_t>(payload, 0);
  head.stamp_ns = static_cast<std::int64_t>(number_at<std::uint64_t>(payload, 8));
  head.sender = number_at<std::uint32_t>(payload, kSender);
  head.incarnation = number_at<std::uint32_t>(payload, kIncarnation);
  if (bus::topic(topic).keyed) head.agent = number_at<std::uint32_t>(payload, kAgent);
  if (!is_mission) head.round = number_at<std::uint32_t>(payload, round_at(topic));
  return head;
}

}  // namespace skein
