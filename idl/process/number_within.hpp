// The check of every option that is a number with a fraction: finite, and within its bounds.
//
// CLI::Range and CLI::PositiveNumber let NaN pass, since they ask whether it is under or over, and print what they were
// given in full. Source: none. Departs from source: none. Complexity: O(1).
#pragma once

#include <CLI/CLI.hpp>

namespace skein {

/// Finite and low <= value <= high; help shows the bounds.
[[nodiscard]] CLI::Validator number_within(double low, double high);

/// Finite and 0 < value <= high.
[[nodiscard]] CLI::Validator number_above_0(double high);

}  // namespace skein
