#include "planner/core/options/rendezvous_options.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace skein {

std::optional<RendezvousOptions> defaults_of(std::string_view planner) {
  RendezvousOptions options;
  options.name = planner;
  if (planner == "dcpso") return options;
  options.equalise = 0;
  if (planner == "dcpso-solo") {
    options.cooperate = 0;
    return options;
  }
  options.max_segments = 1;
  options.reinitialise_probability = 0.0;
  options.velocity_limit = 0.2;
  if (planner == "dcpso-paper") return options;
  options.own_reference = 0;
  if (planner == "ccga") return options;
  return std::nullopt;
}

std::optional<OptionFault> validate(const RendezvousOptions& options) {
  if (!defaults_of(options.name)) {
    return OptionFault{"name", fmt::format("'{}' is no rendezvous planner; allowed: {}", options.name,
                                           fmt::join(kRendezvousPlanners, ", "))};
  }
  for (const RendezvousField& field : kRendezvousFields) {
    const double value = std::visit([&](auto member) { return static_cast<double>(options.*member); }, field.member);
    if (!(value >= field.min && value <= field.max)) {
      return range_fault(field.key, value, field.min, field.max, field.unit);
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
