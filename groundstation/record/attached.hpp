// Recording a swarm that somebody else started, until its run ends: best effort, so that it slows nobody.
#pragma once

#include <optional>

#include "groundstation/record/gaps.hpp"
#include "idl/process/common_flags.hpp"
#include "simworld/scenario/scenario.hpp"

namespace skein {

struct RecordPlan {
  CommonFlags common;
  std::string file;
  const Scenario* scenario = nullptr;        ///< to be attached; nullptr: not known
  std::size_t inbox = std::size_t{1} << 16;  ///< samples that may wait to be written
};

struct Recorded {
  int exit_code = 0;   ///< 0 the run ended; 2, 3 no swarm, or none any more after this process stood
                       ///< still; 4 its world went without a last tick; 128 + a signal
  std::string reason;  ///< in one line
  std::uint64_t samples = 0;
  Gaps gaps;
  bool has_file = false;
};

/// Records swarm `common.swarm`, or the domain's only one. Once a sample is there the file is finished, however it
/// ends.
/// @throws std::runtime_error if DDS cannot be had, or the file cannot be written
[[nodiscard]] Recorded record_attached(const RecordPlan& plan);

}  // namespace skein
