// What changed from one sample to the next, as events with reason codes.
//
// The codes are the words of planner/core/lockstep/names.hpp and of report.json. A missed sample merges two changes
// into one; nothing is made up. Source: none needed. Departs from source: none. Complexity: linear in the samples.
#pragma once

#include <string_view>
#include <vector>

#include "groundstation/watch/view.hpp"

namespace skein::watch {

[[nodiscard]] std::string_view name_of(EventKind kind);

/// @param before the last tick of the same run; nothing: the observer has just come
[[nodiscard]] std::vector<Event> changes(const Tick* before, const Tick& now);

/// @param before the last beacon of the same agent; nothing: it was not heard before
/// @param time_s simulated time of the last tick
[[nodiscard]] std::vector<Event> changes(const Beacon* before, const Beacon& now, double time_s);

}  // namespace skein::watch
