// Option aggregates of numbers as tables: one row a number, for the scenario loader, the wire and the documentation.
//
// Source, Departs from source: none. Complexity: O(fields).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace skein {

/// What is wrong with one option: its key and one line that names value and legal range.
struct OptionFault {
  std::string key;
  std::string message;
};

/// One number of an option aggregate: its key in a scenario, its place, unit ("" for none) and closed legal range.
template <typename Options>
struct OptionField {
  std::string_view key;
  double Options::*member;
  std::string_view unit;
  double min;
  double max;
};

/// The fault of a value that is out of its range.
[[nodiscard]] OptionFault range_fault(std::string_view key, double value, double min, double max,
                                      std::string_view unit);

/// The first number that is out of its range, or nothing.
template <typename Options, std::size_t N>
[[nodiscard]] std::optional<OptionFault> out_of_range(const Options& options,
                                                      const std::array<OptionField<Options>, N>& fields) {
  for (const OptionField<Options>& field : fields) {
    const double value = options.*field.member;
    if (value >= field.min && value <= field.max) continue;
    return range_fault(field.key, value, field.min, field.max, field.unit);
  }
  return std::nullopt;
}

}  // namespace skein
