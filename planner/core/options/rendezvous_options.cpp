#include "planner/core/options/rendezvous_options.hpp"

#include <fmt/core.h>

namespace skein {

std::optional<OptionFault> validate(const RendezvousOptions& options) {
  if (options.name != "dcpso") {
    return OptionFault{"name", fmt::format("'{}' is no rendezvous planner; allowed: dcpso", options.name)};
  }
  for (const RendezvousField& field : kRendezvousFields) {
    const double value = std::visit([&](auto member) { return static_cast<double>(options.*member); }, field.member);
    if (!(value >= field.min && value <= field.max)) {
      return OptionFault{std::string(field.key),
                         fmt::format("{} is {}; allowed: {} to {}{}{}", field.key, value, field.min, field.max,
                                     field.unit.empty() ? "" : " ", field.unit)};
    }
  }
  if (options.search_min_chords >= options.search_max_chords) {
    return OptionFault{"search_min_chords",
                       fmt::format("search_min_chords is {}; allowed: less than search_max_chords, {}",
                                   options.search_min_chords, options.search_max_chords)};
  }
  return std::nullopt;
}

}  // namespace skein
