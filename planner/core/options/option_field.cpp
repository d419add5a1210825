#include "planner/core/options/option_field.hpp"

#include <fmt/core.h>

namespace skein {

OptionFault range_fault(std::string_view key, double value, double min, double max, std::string_view unit) {
  return {std::string(key),
          fmt::format("{} is {}; allowed: {} to {}{}{}", key, value, min, max, unit.empty() ? "" : " ", unit)};
}

}  // namespace skein
