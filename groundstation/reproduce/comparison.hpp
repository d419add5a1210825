// A table from a list of methods (its columns) and a list of figures (its rows).
//
// A column is either a method of the paper, whose figures are looked up by `paper` and the row's key, or one of ours,
// whose figures the row reckons from what a sweep gave. Complexity: O(methods x figures).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "groundstation/reproduce/campaign.hpp"
#include "groundstation/reproduce/table.hpp"

namespace skein::reproduce {

struct Method {
  std::string title;
  std::string paper;             ///< "table4.dcpso": the paper's; empty: ours
  std::string campaign;          ///< ours: of which campaign
  std::vector<Override> values;  ///< ours: which combination of it
};

struct Line {
  std::string key;  ///< the last part of the paper's key
  std::string figure;
  std::string unit;
  std::function<Cell(const Combination&)> ours;
};

/// The rows and columns, or none if not one of our methods was run.
[[nodiscard]] std::optional<Table> compare(const Results& results, const std::vector<Method>& methods,
                                           const std::vector<Line>& lines);

}  // namespace skein::reproduce
