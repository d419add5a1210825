// The rows of a sweep side by side, as one table: how often each plans and arrives, and what it plans.
//
// A rate is given with Wilson's interval of 95 %, z = 1.96,
//   (p + z^2 / 2n -+ z sqrt(p (1 - p) / n + z^2 / 4n^2)) / (1 + z^2 / n),
// a mean with mean -+ z sd / sqrt(n). Figures are means over the successful plans, as in the paper's Table 4 (a plan is
// successful if it is feasible and its lengths differ by at most planner.length_tolerance_m), or, of a row that has
// none, over the feasible ones.
// Source: papers/001, Tables 3 and 4; E. B. Wilson, J. Am. Stat. Assoc. 22 (1927). Departs from source: intervals.
// Complexity: O(runs x figures).
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace skein {

/// An interval of 95 %.
struct Interval95 {
  double low = 0.0;
  double high = 0.0;
};

/// Wilson's interval of a rate. @pre count <= of, and of is not 0
[[nodiscard]] Interval95 interval_of(std::size_t count, std::size_t of);

/// One entry a row of run_sweep: set, runs, plan_success, plan_feasible and success (count, rate, low, high), over
/// ("successful plans", "feasible plans" or "none") and figures {name: count, mean, sd, low, high}.
[[nodiscard]] nlohmann::ordered_json table_of(const nlohmann::ordered_json& rows);

/// The table for people: a column an entry, a line a figure; ends with a newline.
[[nodiscard]] std::string text_of_table(const nlohmann::ordered_json& table);

/// Whether a figure is printed for people: of more pairs of vehicles than these only --json has each.
inline constexpr std::size_t kPairsPrinted = 15;
[[nodiscard]] bool is_printed(const std::string& name, const nlohmann::ordered_json& figures);

/// A row's name: its swept values, the planner's without its key.
[[nodiscard]] std::string title_of(const nlohmann::ordered_json& row);

}  // namespace skein
