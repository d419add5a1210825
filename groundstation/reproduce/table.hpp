// A table of figures side by side: a row a figure, a column a method, and where the paper's figures stand.
//
// Written as a Markdown table, plain for a file, with its columns lined up for a terminal. Wall times differ from run
// to run; a file that is to be the same each time has a link in their place.
// Complexity: O(cells).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace skein::reproduce {

struct Cell {
  std::string text = "-";
  nlohmann::ordered_json data;  ///< the numbers for programs: value, sd, low, high, count, of; null if there is none
  bool timed = false;           ///< a wall time
};

struct TableRow {
  std::string figure;  ///< "L1, mean (sd)"
  std::string unit;    ///< "km", "-"
  std::vector<Cell> cells;
  std::string source;  ///< of the paper's figures in this row; "-" if it has none
};

struct Table {
  std::string id;                    ///< "rendezvous.table4"
  std::string title;                 ///< "Table 4: 30 runs"
  std::vector<std::string> notes;    ///< what differs in set-up, a sentence or two each
  std::vector<std::string> columns;  ///< heads of the cells
  std::vector<TableRow> rows;        ///< each with as many cells as there are columns
};

enum class Layout {
  Terminal,  ///< columns lined up, wall times as measured
  File,      ///< the same bytes for the same seeds: not lined up, no wall times
};

/// The table without title and notes; ends with a newline.
[[nodiscard]] std::string text_of(const Table& table, Layout layout);

/// id, title, notes, columns, rows (figure, unit, source, cells: text and the cell's numbers).
[[nodiscard]] nlohmann::ordered_json json_of(const Table& table);

}  // namespace skein::reproduce
