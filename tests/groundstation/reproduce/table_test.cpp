// A table as text: lined up for a terminal, plain and without wall times for a file.
#include "groundstation/reproduce/table.hpp"

#include <gtest/gtest.h>

namespace skein::reproduce {
namespace {

Table small() {
  Table table{"t.small", "Small", {"A note."}, {"paper", "`ours`"}, {}};
  table.rows.push_back({"L1", "km", {{"35.0611", {{"value", 35.0611}}}, {"7.1", {{"value", 7.125}}}}, "Table 3"});
  table.rows.push_back({"time", "s", {{"2.35", {{"value", 2.35}}}, {"0.0028", {{"value", 0.0028}}, true}}, "Table 4"});
  table.rows.push_back({"other", "-", {Cell{}, Cell{}}, "-"});
  return table;
}

TEST(Table, IsLinedUpForATerminal) {
  EXPECT_EQ(text_of(small(), Layout::Terminal),
            "| figure | unit | paper   | `ours` | source of the paper's |\n"
            "| ------ | ---- | ------- | ------ | --------------------- |\n"
            "| L1     | km   | 35.0611 | 7.1    | Table 3               |\n"
            "| time   | s    | 2.35    | 0.0028 | Table 4               |\n"
            "| other  | -    | -       | -      | -                     |\n");
}

TEST(Table, InAFileHasNoWallTimes) {
  EXPECT_EQ(text_of(small(), Layout::File),
            "| figure | unit | paper | `ours` | source of the paper's |\n"
            "| --- | --- | --- | --- | --- |\n"
            "| L1 | km | 35.0611 | 7.1 | Table 3 |\n"
            "| time | s | 2.35 | [wall time](benchmarks.md) | Table 4 |\n"
            "| other | - | - | - | - |\n");
}

TEST(Table, ItsNumbersAreInTheJson) {
  const auto json = json_of(small());
  EXPECT_EQ(json.at("id"), "t.small");
  EXPECT_EQ(json.at("columns").size(), 2U);
  const auto& row = json.at("rows").at(0);
  EXPECT_EQ(row.at("source"), "Table 3");
  EXPECT_EQ(row.at("unit"), "km");
  EXPECT_EQ(row.at("cells").at(1).at("value"), 7.125);
  EXPECT_EQ(row.at("cells").at(1).at("text"), "7.1");
  EXPECT_FALSE(json.at("rows").at(2).at("cells").at(0).contains("value"));
}

}  // namespace
}  // namespace skein::reproduce
