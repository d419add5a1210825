// Where two runs differ first: round, agent and field, with both values.
//
// Samples are gone through by round, then topic (mission, tick, sense, beacon, representative, obstacle map), then
// agent. A sample that neither run counts is not compared. Source: none. Departs from source: none.
// Complexity: linear in the samples; only the first difference is decoded.
#pragma once

#include <nlohmann/json.hpp>

#include "groundstation/verify/recorded_run.hpp"

namespace skein {

struct RunDifference {
  SampleName where;
  std::string field;            ///< empty: one run has no such sample
  nlohmann::ordered_json a, b;  ///< both values; null: it is not there, or the bytes are none of its type
};

struct Comparison {
  std::uint64_t samples = 0;  ///< that were compared and are equal
  std::uint32_t rounds = 0;   ///< up to which
  std::optional<RunDifference> difference;
};

/// @param before only rounds under it are compared
[[nodiscard]] Comparison compare(const RecordedRun& a, const RecordedRun& b, std::uint32_t before = UINT32_MAX);

/// In one line, without the file's names.
[[nodiscard]] std::string text_of(const Comparison& comparison);
[[nodiscard]] nlohmann::ordered_json json_of(const Comparison& comparison);

}  // namespace skein
