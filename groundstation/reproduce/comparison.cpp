#include "groundstation/reproduce/comparison.hpp"

#include "groundstation/reproduce/cells.hpp"

namespace skein::reproduce {

std::optional<Table> compare(const Results& results, const std::vector<Method>& methods,
                             const std::vector<Line>& lines) {
  Table table;
  std::vector<std::optional<Combination>> combinations;
  bool any = false;
  for (const Method& method : methods) {
    table.columns.push_back(method.title);
    combinations.push_back(method.paper.empty() ? combination_of(results, method.campaign, method.values)
                                                : std::nullopt);
    any = any || combinations.back();
  }
  if (!any) return std::nullopt;
  for (const Line& line : lines) {
    TableRow row{line.figure, line.unit, {}, ""};
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (!methods[i].paper.empty()) {
        keys.push_back(methods[i].paper + "." + line.key);
        row.cells.push_back(paper_cell(keys.back()));
      } else {
        row.cells.push_back(combinations[i] ? line.ours(*combinations[i]) : Cell{});
      }
    }
    row.source = sources_of(keys);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace skein::reproduce
