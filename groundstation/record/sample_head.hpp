// What a sample's bytes say of it at their beginning, without decoding the rest.
//
// Every sample opens with its Header; those of keyed topics go on with agent, and all but mission and beacon with what
// names the round (docs/wire.md). Bytes of either byte order. Source: idl/msg. Departs from source: none.
// Complexity: O(1).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "idl/bus/topics.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

struct SampleHead {
  std::uint64_t run = 0;
  std::int64_t stamp_ns = 0;
  std::uint32_t sender = 0;
  std::uint32_t incarnation = 0;
  AgentId agent = kWorldId;  ///< of a keyed topic
  std::uint32_t round = 0;   ///< 0 of a mission, and of what a ground station says
};

/// Who writes a sample of the topic: "world", "agent 3", "ground station".
[[nodiscard]] std::string writer_of(bus::TopicId topic, bool from_world, AgentId agent);

/// Nothing if the bytes are too short for it.
[[nodiscard]] std::optional<SampleHead> head_of(bus::TopicId topic, std::span<const std::uint8_t> payload);

}  // namespace skein
