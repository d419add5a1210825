// How far a run is, in words for a person.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "simworld/lockstep/world_session.hpp"

namespace skein {

/// What changes when a person wants to read a new line of progress.
[[nodiscard]] std::string progress_mark(Phase phase, std::size_t introduced, std::uint32_t round, std::uint32_t step);

/// The state of a run in the words of the progress display: {"phase", "introduced", "matched", "agents", "round",
/// "generation", "longest_m", "step", "time_s", "arrived", "live", "mark"}. The mark changes with what a person wants
/// to read a line about: the phase, the number of introduced agents, every ten planning rounds, every 200 steps.
[[nodiscard]] nlohmann::json progress_of(const WorldSession& session);

/// Speaks when the mark changes, and every 0.1 s between.
class ProgressFeed {
 public:
  /// @param sink takes the progress, and whether its mark is new.
  explicit ProgressFeed(std::function<void(const nlohmann::json&, bool)> sink) : sink_(std::move(sink)) {}

  void show(const WorldSession& session, double now_s);

 private:
  std::function<void(const nlohmann::json&, bool)> sink_;
  double last_s_ = -1e9;
  std::string last_mark_;
};

}  // namespace skein
