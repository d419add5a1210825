// `skein monitor`: a running swarm on the whole terminal, until the person, a signal or the run ends it.
#pragma once

#include <string>

#include "groundstation/monitor/canvas.hpp"
#include "idl/process/common_flags.hpp"

namespace skein::monitor {

struct MonitorOptions {
  bool keep = false;   ///< the last picture stays when the run has ended, until q
  bool ascii = false;  ///< no Braille patterns, whatever the terminal can
};

/// How it ended: the run's own exit code if it ended first, 0 after q, 128 + a signal, 2 no terminal or no swarm to
/// choose, 3 no world in time, 4 the world fell silent.
struct MonitorEnd {
  int exit_code = 0;
  std::string reason;  ///< one line, empty after q
};

/// Shows swarm `flags.swarm`, or the domain's only one. @throws std::runtime_error if DDS cannot be had
[[nodiscard]] MonitorEnd monitor(const CommonFlags& flags, const MonitorOptions& options);

}  // namespace skein::monitor
