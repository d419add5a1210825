// Putting a recording back on the bus: whoever observes a swarm observes it once more.
//
// A swarm that is live is left alone: who is heard in it within kLook_s, or later turns out to have been there first,
// ends the replay before anything is played. Readers are waited for until none was found for kSettle_s, since what is
// not latched is heard by those alone that are there. At its end the last tick is repeated, as a world does it.
// Source: none. Departs from source: none. Complexity: that of the file, and rate x its simulated time.
#pragma once

#include <functional>
#include <string>

#include "idl/process/common_flags.hpp"

namespace skein::replay {

struct ReplayPlan {
  CommonFlags common;
  std::string file;
  double rate = 1.0;               ///< times real time; 0: as fast as the machine can
  double from_s = 0.0;             ///< simulated time
  std::uint32_t observers = 0;     ///< readers of ticks that must be there before it begins
  std::function<void()> on_begin;  ///< before the first sample; may be empty
  std::function<void(double time_s, double end_s)> on_progress;  ///< simulated time; may be empty
};

struct Replayed {
  int exit_code = 0;   ///< 0 played to its end; 3 the swarm is live, or observers did not come; 128 + a signal
  std::string reason;  ///< in one line, unless it was played to its end
  std::uint64_t samples = 0;
  std::uint64_t refused = 0;   ///< DDS did not take them
  std::uint64_t left_out = 0;  ///< of other runs, or none of their type
  std::string missing;         ///< of a recording that was cut: what it lacks, in one line
  double from_s = 0.0;
  double to_s = 0.0;  ///< simulated time up to which it was played
};

/// Plays the file to swarm `common.swarm`. @throws mcap::Damaged, std::runtime_error with one line if the file cannot
/// be read or played, or DDS cannot be had
[[nodiscard]] Replayed replay(const ReplayPlan& plan);

}  // namespace skein::replay
