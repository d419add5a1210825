#include "idl/process/number_within.hpp"

#include <fmt/core.h>

#include <cmath>

#include "planner/core/text/utf8.hpp"

namespace skein {
namespace {

constexpr std::size_t kMostShown = 40;

CLI::Validator checked(const std::string& allowed, const std::function<bool(double)>& holds) {
  const auto check = [allowed, holds](const std::string& text) {
    double value = 0.0;
    if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && holds(value)) return std::string();
    return fmt::format("'{}' is not allowed: {}", one_line(text, kMostShown), allowed);
  };
  return {check, allowed};
}

}  // namespace

CLI::Validator number_within(double low, double high) {
  return checked(fmt::format("{} to {}", low, high), [=](double value) { return low <= value && value <= high; });
}

CLI::Validator number_above_0(double high) {
  return checked(fmt::format("over 0, to {}", high), [=](double value) { return 0.0 < value && value <= high; });
}

}  // namespace skein
