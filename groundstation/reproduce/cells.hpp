// Cells of the tables: the paper's figures by key, ours from what a sweep gave for one combination.
//
// A mean is of the successful plans, as in the paper's Table 4, and of all feasible ones of a planner that has none
// (sweep/table.hpp). A rate has Wilson's interval of 95 % behind it.
// Complexity: O(1) each.
#pragma once

#include <string>
#include <string_view>

#include "groundstation/reproduce/campaign.hpp"
#include "groundstation/reproduce/table.hpp"

namespace skein::reproduce {

/// The paper's figure, or an empty cell if it prints none.
[[nodiscard]] Cell paper_cell(std::string_view key);

/// A number as text; `digits` after the point.
[[nodiscard]] Cell number_cell(double value, int digits);

/// "36 of 40"; empty of 0.
[[nodiscard]] Cell count_cell(std::size_t count, std::size_t of);

/// Mean (and with `with_sd` standard deviation in brackets) of a figure of the sweep's table, times `scale`.
[[nodiscard]] Cell mean_cell(const Combination& combination, const std::string& figure, double scale, int digits,
                             bool with_sd);

/// "0.964 [0.951, 0.974]" of plan_success, plan_feasible or success.
[[nodiscard]] Cell rate_cell(const Combination& combination, const char* rate);

/// How many of the runs have it.
[[nodiscard]] Cell successes_cell(const Combination& combination, const char* rate);

/// The most of several figures over all runs, times `scale`.
[[nodiscard]] Cell most_cell(const Combination& combination, const std::vector<std::string>& figures, double scale,
                             int digits);

/// The sources of the paper's figures that a row shows, each once; "-" if there is none.
[[nodiscard]] std::string sources_of(const std::vector<std::string>& keys);

}  // namespace skein::reproduce
