// Waiting in a process's main loop: for descriptors, with a deadline.
#pragma once

#include <initializer_list>

namespace skein {

/// Seconds of the steady clock. For deadlines and figures of speed alone: nothing of a run's result depends on it.
[[nodiscard]] double steady_now_s();

/// Returns when a descriptor is readable (or closed by its other end) or `timeout_s` has passed. Negative ones are left
/// out.
void wait_readable(std::initializer_list<int> descriptors, double timeout_s);

}  // namespace skein
