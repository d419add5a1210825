// Agent ids as a command line writes them: "3", "1-8", "1,3,5-7".
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "planner/core/mission/mission.hpp"

namespace skein {

/// The ids, ascending; nothing unless the text is a list of ids (1 to kMaxAgents) and ranges, each id once.
[[nodiscard]] std::optional<std::vector<AgentId>> id_list_from(std::string_view text);

/// The shortest text of ascending ids: runs of three and more as ranges.
[[nodiscard]] std::string text_of(std::span<const AgentId> ids);

}  // namespace skein
