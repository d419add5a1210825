// Which swarm an observer watches: the one that it was told of, or the only one of its domain.
#pragma once

#include <string>

#include "idl/process/common_flags.hpp"
#include "idl/process/signals.hpp"

namespace skein {

struct SwarmChoice {
  std::string swarm;   ///< empty: none
  int exit_code = 0;   ///< without one: 2 several to choose from, 3 none in time, 128 + a signal
  std::string reason;  ///< without one, in one line
};

/// `flags.swarm`, or the only swarm that is heard in the domain; the first one must be heard within the start-up
/// timeout. A change of the window (SIGWINCH) ends nothing.
/// @throws std::runtime_error if DDS cannot be had
[[nodiscard]] SwarmChoice choose_swarm(const CommonFlags& flags, const SignalWatch& signals);

/// "ended by SIGTERM"
[[nodiscard]] std::string ended_by(int signal);

}  // namespace skein
