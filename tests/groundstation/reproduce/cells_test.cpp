// Cells: the paper's by key, ours from a sweep's table; empty where there is nothing.
#include "groundstation/reproduce/cells.hpp"

#include <gtest/gtest.h>

namespace skein::reproduce {
namespace {

using Json = nlohmann::ordered_json;

struct Given {
  Json row{{"figures", {{"a", {{"max", 0.002}}}, {"b", {{"max", 0.003}}}}}};
  Json entry{{"plan_success", {{"count", 3}, {"rate", 0.75}, {"low", 0.3}, {"high", 0.95}}},
             {"success", {{"count", 0}, {"rate", nullptr}, {"low", nullptr}, {"high", nullptr}}},
             {"figures", {{"length_m", {{"count", 3}, {"mean", 35061.12}, {"sd", 1.5}}}}}};
  [[nodiscard]] Combination combination() const { return {&row, &entry}; }
};

TEST(Cells, ThePapersIsAsPrintedWithItsSource) {
  const Cell cell = paper_cell("table4.dcpso.l1");
  EXPECT_EQ(cell.text, "35.0611 (0.0001)");
  EXPECT_EQ(cell.data.at("value"), 35.0611);
  EXPECT_EQ(cell.data.at("sd"), 0.0001);
  EXPECT_EQ(cell.data.at("source"), "Table 4, p. 12");
  EXPECT_EQ(paper_cell("table4.dcpso.nothing").text, "-");
}

TEST(Cells, AMeanIsScaledAndRounded) {
  const Given given;
  EXPECT_EQ(mean_cell(given.combination(), "length_m", 1e-3, 4, false).text, "35.0611");
  const Cell cell = mean_cell(given.combination(), "length_m", 1e-3, 4, true);
  EXPECT_EQ(cell.text, "35.0611 (0.0015)");
  EXPECT_DOUBLE_EQ(cell.data.at("value").get<double>(), 35.06112);
  EXPECT_EQ(cell.data.at("count"), 3);
  EXPECT_EQ(mean_cell(given.combination(), "width_m", 1.0, 1, true).text, "-");
}

TEST(Cells, ARateHasItsInterval) {
  const Given given;
  EXPECT_EQ(rate_cell(given.combination(), "plan_success").text, "0.750 [0.300, 0.950]");
  EXPECT_EQ(successes_cell(given.combination(), "plan_success").text, "3");
  EXPECT_EQ(rate_cell(given.combination(), "success").text, "-");
  EXPECT_EQ(rate_cell(given.combination(), "plan_feasible").text, "-");
}

TEST(Cells, CountsAndTheMost) {
  const Given given;
  EXPECT_EQ(count_cell(69, 72).text, "69 of 72");
  EXPECT_EQ(count_cell(0, 0).text, "-");
  EXPECT_EQ(most_cell(given.combination(), {"a", "b", "c"}, 1e3, 3).text, "3.000");
  EXPECT_EQ(most_cell(given.combination(), {"c"}, 1e3, 3).text, "-");
}

TEST(Cells, SourcesStandOnceEach) {
  EXPECT_EQ(sources_of({"table3.dcpso.l1", "table3.solo.l1", "table4.dcpso.l1"}), "Table 3, p. 12; Table 4, p. 12");
  EXPECT_EQ(sources_of({"none.at.all"}), "-");
}

}  // namespace
}  // namespace skein::reproduce
