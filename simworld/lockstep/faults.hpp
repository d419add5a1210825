// Faults on purpose: what shall happen to which agent, at which tick.
//
// Written `KIND:ID@plan:ROUND` or `KIND:ID@fly:STEP`; `kill:world@...` kills the world, which goes on from its
// checkpoint. The world holds that tick until the effect is confirmed, so that a fault takes place at the same point of
// every run (simworld/lockstep/interventions.hpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "planner/core/lockstep/samples.hpp"

namespace skein {

enum class FaultKind : std::uint8_t {
  Kill,     ///< SIGKILL to the agent's process
  Stop,     ///< SIGSTOP: it falls silent, and the deadline drops it
  Cont,     ///< SIGCONT: a dropped agent comes back
  Restart,  ///< kills the process, if there is one, and starts another
};

struct Fault {
  FaultKind kind = FaultKind::Kill;
  AgentId agent = 0;              ///< kWorldId with Kill: the world
  Phase phase = Phase::Planning;  ///< Planning or Flying
  std::uint32_t at = 0;           ///< the planning round or the flight step whose tick is held

  bool operator==(const Fault&) const = default;
};

/// What parsing a fault gives: the fault, or one line that names what is wrong and what is allowed.
struct ParsedFault {
  std::optional<Fault> fault;
  std::string error;
};

/// The fault in the words that parse_fault takes.
[[nodiscard]] std::string text_of(const Fault& fault);

[[nodiscard]] ParsedFault parse_fault(std::string_view text);

}  // namespace skein
