// The words that reports, logs and command lines use for the protocol's enumerations; each maps both ways.
#pragma once

#include <optional>
#include <string_view>

#include "planner/core/lockstep/samples.hpp"

namespace skein {

[[nodiscard]] std::string_view name_of(Phase phase);
[[nodiscard]] std::string_view name_of(AgentMode mode);
[[nodiscard]] std::string_view name_of(Constraint constraint);
[[nodiscard]] std::string_view name_of(RefusalReason reason);
[[nodiscard]] std::string_view name_of(LossReason reason);
[[nodiscard]] std::string_view name_of(SafetyMode mode);
[[nodiscard]] std::string_view name_of(SafetyReason reason);
[[nodiscard]] std::string_view name_of(ZoneState state);
[[nodiscard]] std::string_view name_of(OrderKind kind);
[[nodiscard]] std::string_view name_of(OrderResult result);
[[nodiscard]] std::string_view name_of(InjectionKind kind);
[[nodiscard]] std::optional<LossReason> loss_reason_from(std::string_view name);
[[nodiscard]] std::optional<OrderKind> order_kind_from(std::string_view name);
[[nodiscard]] std::optional<InjectionKind> injection_kind_from(std::string_view name);

}  // namespace skein
