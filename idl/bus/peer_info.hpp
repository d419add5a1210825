// What a process says of itself in the USER_DATA of its DDS participant, as text that every version can read.
//
// "skein role=agent swarm=geese id=3 nonce=81985529216486895 wire=1 start=1700000000000000000": words in any order,
// unknown ones are skipped, so that a later version may add some.
// A process that holds several agents says " members=8" as well; `id` is its lowest agent, and its agents have the
// nonces `nonce`, `nonce` + 1 and so on, by ascending id. A world says " run=42" as well: one that goes on with a run
// whose world has died has the same. A process whose participant was made anew says " renewals=1", 2 and so on: its
// participants before that may linger until their lease ends.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "idl/bus/topics.hpp"
#include "idl/wire.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein::bus {

struct PeerInfo {
  Role role = Role::Observer;
  std::string swarm;
  AgentId id = kWorldId;
  std::uint64_t nonce = 0;
  std::uint32_t wire_version = wire::kWireVersion;
  std::int64_t start_stamp_ns = 0;
  std::uint32_t members = 1;   ///< agents in the process
  std::uint64_t run = 0;       ///< of a world; 0: it does not say
  std::uint32_t renewals = 0;  ///< how often the process made its participant anew

  bool operator==(const PeerInfo&) const = default;
};

[[nodiscard]] std::string to_text(const PeerInfo& info);

/// Nothing if the text is not a skein process's or lacks a word.
[[nodiscard]] std::optional<PeerInfo> peer_info_from(std::string_view text);

}  // namespace skein::bus
