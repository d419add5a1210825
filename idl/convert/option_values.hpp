// Option aggregates of numbers on the wire: their values, in the order of their table.
#pragma once

#include <vector>

#include "idl/convert/checker.hpp"
#include "idl/convert/limits.hpp"
#include "planner/core/options/option_field.hpp"

namespace skein {

template <typename Options, std::size_t N>
[[nodiscard]] std::vector<double> values_of(const Options& options, const std::array<OptionField<Options>, N>& fields) {
  std::vector<double> values;
  for (const OptionField<Options>& field : fields) values.push_back(options.*field.member);
  return values;
}

/// @pre as many values as fields
template <typename Options, std::size_t N>
[[nodiscard]] Options options_of(const std::vector<double>& values, const std::array<OptionField<Options>, N>& fields) {
  Options options;
  for (std::size_t i = 0; i < N; ++i) options.*fields[i].member = values[i];
  return options;
}

/// As many values as fields, each finite and legal.
template <typename Options, std::size_t N>
void check_values(Checker& check, const std::vector<double>& values, const std::array<OptionField<Options>, N>& fields,
                  std::string_view where) {
  check.require(values.size() == N, WireFaultReason::OutOfRange, where);
  for (const double value : values) check.within(value, -limits::kCost, limits::kCost, where);
  if (!check.ok()) return;
  check.require(!validate(options_of(values, fields)).has_value(), WireFaultReason::BadOptions, where);
}

}  // namespace skein
