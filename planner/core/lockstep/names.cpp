#include "planner/core/lockstep/names.hpp"

#include <array>

namespace skein {
namespace {

constexpr std::array<std::string_view, 4> kPhases{"waiting", "planning", "flying", "finished"};
constexpr std::array<std::string_view, 15> kModes{"waiting",    "planning", "ready",    "failed",      "flying",
                                                  "arrived",    "leaving",  "rejoined", "unreachable", "deadlock",
                                                  "replanning", "holding",  "going_to", "landing",     "landed"};
constexpr std::array<std::string_view, 3> kSafetyModes{"autonomous", "controlled", "hold"};
constexpr std::array<std::string_view, 9> kSafetyReasons{
    "none", "obstacle", "peer", "unconfirmed", "deviation", "blocked", "stale_peer", "replanning", "no_plan"};
constexpr std::array<std::string_view, 4> kZoneStates{"ahead", "unconfirmed", "occupied", "clear"};
constexpr std::array<std::string_view, 8> kConstraints{"none",       "curvature", "obstacle", "no_fly",
                                                       "separation", "length",    "torsion",  "terrain"};
constexpr std::array<std::string_view, 4> kRefusals{"", "id_in_use", "unknown_id", "run_started"};
constexpr std::array<std::string_view, 5> kLosses{"none", "process_ended", "deadline", "left", "rejoined"};

constexpr std::array<std::string_view, 7> kOrders{"", "start", "hold", "resume", "abort", "land", "goto"};
constexpr std::array<std::string_view, 9> kResults{"accepted", "unknown_agent", "not_live", "not_flying", "ended",
                                                   "started",  "no_launcher",   "expired",  "refused"};
constexpr std::array<std::string_view, 5> kInjections{"", "obstacle", "pause", "kill", "restart"};

template <typename Enum, std::size_t N>
std::optional<Enum> find_name(const std::array<std::string_view, N>& names, std::string_view name) {
  for (std::size_t i = 0; i < N; ++i) {
    if (!name.empty() && names[i] == name) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

template <typename Enum, std::size_t N>
std::string_view look_up(const std::array<std::string_view, N>& names, Enum value) {
  const auto index = static_cast<std::size_t>(value);
  return index < N ? names[index] : std::string_view("unknown");
}

}  // namespace

std::string_view name_of(Phase phase) {
  return look_up(kPhases, phase);
}
std::string_view name_of(AgentMode mode) {
  return look_up(kModes, mode);
}
std::string_view name_of(Constraint constraint) {
  return look_up(kConstraints, constraint);
}
std::string_view name_of(RefusalReason reason) {
  return look_up(kRefusals, reason);
}
std::string_view name_of(LossReason reason) {
  return look_up(kLosses, reason);
}
std::string_view name_of(SafetyMode mode) {
  return look_up(kSafetyModes, mode);
}
std::string_view name_of(SafetyReason reason) {
  return look_up(kSafetyReasons, reason);
}
std::string_view name_of(ZoneState state) {
  return look_up(kZoneStates, state);
}

std::string_view name_of(OrderKind kind) {
  return look_up(kOrders, kind);
}
std::string_view name_of(OrderResult result) {
  return look_up(kResults, result);
}
std::string_view name_of(InjectionKind kind) {
  return look_up(kInjections, kind);
}

std::optional<LossReason> loss_reason_from(std::string_view name) {
  return find_name<LossReason>(kLosses, name);
}
std::optional<OrderKind> order_kind_from(std::string_view name) {
  return find_name<OrderKind>(kOrders, name);
}
std::optional<InjectionKind> injection_kind_from(std::string_view name) {
  return find_name<InjectionKind>(kInjections, name);
}

}  // namespace skein
