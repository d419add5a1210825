#include "planner/core/options/controller_options.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace skein {

std::optional<OptionFault> validate(const ControllerOptions& options) {
  if (std::ranges::find(kControllers, options.name) == kControllers.end()) {
    return OptionFault{"name",
                       fmt::format("'{}' is no controller; allowed: {}", options.name, fmt::join(kControllers, ", "))};
  }
  if (auto fault = out_of_range(options, kControllerFields)) return fault;
  if (std::floor(options.filter) == options.filter) return std::nullopt;
  return OptionFault{"filter", fmt::format("filter is {}; allowed: whole numbers", options.filter)};
}

}  // namespace skein
