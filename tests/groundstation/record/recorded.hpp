// Recordings in memory of small runs in this process.
#pragma once

#include "groundstation/inprocess/in_process.hpp"
#include "groundstation/record/recording.hpp"

namespace skein::tests {

[[nodiscard]] Scenario small_scenario(const std::string& name, std::uint64_t seed);

struct RecordedBytes {
  mcap::Bytes file;
  InProcessResult result;
};

/// The run with `options` (its tap is replaced), recorded whole.
[[nodiscard]] RecordedBytes record(const Scenario& scenario, InProcessOptions options);

}  // namespace skein::tests
