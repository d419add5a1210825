// What a run says at its end: one JSON object, the same from world and in-process runs (docs/report.md).
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "simworld/lockstep/world_session.hpp"

namespace skein {

/// The program's own version.
[[nodiscard]] std::string_view version();

/// What the report needs besides the session.
struct ReportContext {
  std::string carrier;                  ///< "dds" or "in-process"
  std::uint64_t lost_samples = 0;       ///< on the world's side of the bus
  std::optional<PhaseTimes> wall = {};  ///< when the session's own clock is not the wall's
};

/// The report of a session that is over (state Done). Figures that do not exist (no flight, one vehicle) are null.
[[nodiscard]] nlohmann::ordered_json make_report(const WorldSession& session, const Scenario& scenario,
                                                 const ReportContext& context);

/// Why a report's losses cannot be replayed here, in one line: another scenario, seed or --fail-fast; empty if they
/// can.
[[nodiscard]] std::string replay_obstacle(const nlohmann::json& report, const Scenario& scenario, bool fail_fast);

/// Writes JSON to a file. @throws std::runtime_error with one line if it is not all there.
void write_json(const std::string& path, const nlohmann::ordered_json& json);

/// The losses that a report holds, for a replay. @throws std::runtime_error with one line that says what is wrong.
[[nodiscard]] std::vector<RosterChange> roster_changes_of(const nlohmann::json& report);

}  // namespace skein
