// Watching a swarm that somebody else started, until its run ends.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "idl/process/common_flags.hpp"

namespace skein {

/// How watching ended: with the run's own result, or without one.
struct Attached {
  int exit_code = 0;              ///< the run's; 2 no swarm to choose, 3 no world in time, 4 it ended without a result
  nlohmann::ordered_json result;  ///< null without one
  std::string reason;             ///< in one line, without a result
};

/// Watches swarm `flags.swarm`, or the domain's only one, until its run ends; leaves without a trace. A world must be
/// heard within the start-up timeout; later, one that is gone or silent for 30 s ends it.
/// @param show gets the run's progress as it changes
/// @throws std::runtime_error if DDS cannot be had
[[nodiscard]] Attached attach(const CommonFlags& flags, const std::function<void(const nlohmann::json&)>& show);

}  // namespace skein
