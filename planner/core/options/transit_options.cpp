#include "planner/core/options/transit_options.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace skein {
std::optional<TransitOptions> transit_defaults_of(std::string_view planner) {
  if (std::ranges::find(kTransitPlanners, planner) == kTransitPlanners.end()) return std::nullopt;
  TransitOptions options;
  options.name = planner;
  return options;
}

std::optional<OptionFault> validate(const TransitOptions& options) {
  if (!transit_defaults_of(options.name)) {
    return OptionFault{"name", fmt::format("'{}' is no transit planner; allowed: {}", options.name,
                                           fmt::join(kTransitPlanners, ", "))};
  }
  if (auto fault = out_of_range(options, kTransitFields)) return fault;
  for (const auto& [key, value] : {std::pair{"patience", options.patience},
                                   {"share_maps", options.share_maps},
                                   {"known_line", options.known_line}}) {
    if (std::floor(value) != value)
      return OptionFault{key, fmt::format("{} is {}; allowed: whole numbers", key, value)};
  }
  return std::nullopt;
}

std::optional<OptionFault> validate(const RadioOptions& options) {
  if (auto fault = out_of_range(options, kRadioFields)) return fault;
  if (std::floor(options.latency_rounds) == options.latency_rounds) return std::nullopt;
  return OptionFault{"latency_rounds",
                     fmt::format("latency_rounds is {}; allowed: whole numbers", options.latency_rounds)};
}

std::optional<OptionFault> validate(const SensorOptions& options) {
  return out_of_range(options, kSensorFields);
}

}  // namespace skein
