#include "groundstation/reproduce/table.hpp"

#include <algorithm>

namespace skein::reproduce {
namespace {

using Line = std::vector<std::string>;

std::string text_of(const Cell& cell, Layout layout) {
  return cell.timed && layout == Layout::File ? "[wall time](benchmarks.md)" : cell.text;
}

std::vector<Line> lines_of(const Table& table, Layout layout) {
  std::vector<Line> lines{{"figure", "unit"}};
  lines[0].insert(lines[0].end(), table.columns.begin(), table.columns.end());
  lines[0].emplace_back("source of the paper's");
  for (const TableRow& row : table.rows) {
    Line line{row.figure, row.unit};
    for (const Cell& cell : row.cells) line.push_back(text_of(cell, layout));
    line.push_back(row.source);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::string text_of(const Table& table, Layout layout) {
  const std::vector<Line> lines = lines_of(table, layout);
  std::vector<std::size_t> widths(lines[0].size(), layout == Layout::Terminal ? 3 : 0);
  if (layout == Layout::Terminal) {
    for (const Line& line : lines) {
      for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
    }
  }
  std::string text;
  const auto append = [&](const Line& line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      text += "| " + line[i] + std::string(std::max(widths[i], line[i].size()) - line[i].size() + 1, ' ');
    }
    text += "|\n";
  };
  append(lines[0]);
  Line rule;
  for (const std::size_t width : widths) rule.emplace_back(std::max<std::size_t>(width, 3), '-');
  append(rule);
  std::for_each(lines.begin() + 1, lines.end(), append);
  return text;
}

nlohmann::ordered_json json_of(const Table& table) {
  nlohmann::ordered_json json{{"id", table.id}, {"title", table.title}, {"notes", table.notes}};
  json["columns"] = table.columns;
  json["rows"] = nlohmann::ordered_json::array();
  for (const TableRow& row : table.rows) {
    nlohmann::ordered_json cells = nlohmann::ordered_json::array();
    for (const Cell& cell : row.cells) {
      nlohmann::ordered_json item{{"text", cell.text}};
      if (!cell.data.is_null()) item.update(cell.data);
      cells.push_back(item);
    }
    json["rows"].push_back({{"figure", row.figure}, {"unit", row.unit}, {"source", row.source}, {"cells", cells}});
  }
  return json;
}

}  // namespace skein::reproduce
