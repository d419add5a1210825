#include <fmt/core.h>

#include "idl/wire.hpp"
#include "planner/core/lockstep/names.hpp"
#include "simworld/lockstep/world_session.hpp"

namespace skein {
namespace {

/// Faults and roster changes that were asked for and whose moment never came, as the end of a reason.
std::string unused_of(const WorldSession& session) {
  std::string text;
  for (const Fault& fault : session.unused_faults()) {
    text += fmt::format("; the fault {} never took place", text_of(fault));
  }
  for (const RosterChange& change : session.unused_changes()) {
    text += fmt::format("; the {} of agent {} at round {} never took place",
                        change.reason == LossReason::Rejoined ? "return" : "loss", change.agent, change.round);
  }
  for (const OrderedAt& order : session.desk().unused_orders()) {
    text += fmt::format("; the {} of round {} never took place", name_of(order.order.kind), order.round);
  }
  for (const InjectedAt& injected : session.desk().unused_injections()) {
    text += fmt::format("; the obstacle of round {} never took place", injected.round);
  }
  return text;
}

}  // namespace

Outcome WorldSession::outcome() const {
  Outcome outcome;
  if (interrupted_) {
    outcome = *interrupted_;
  } else {
    const Verdict verdict = run_.verdict();
    const std::string unused = unused_of(*this);
    const bool spoiled = verdict.code == ExitCode::Success && !unused.empty();
    outcome = {static_cast<std::uint8_t>(spoiled ? ExitCode::Failed : verdict.code), verdict.reason + unused};
  }
  return outcome;
}

}  // namespace skein
