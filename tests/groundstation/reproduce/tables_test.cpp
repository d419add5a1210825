// The tables as a whole, from made-up runs: every figure of the papers stands in one of them, each row has a source,
// and what is reckoned from flights is right by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "groundstation/reproduce/rendezvous_tables.hpp"
#include "groundstation/reproduce/transit_tables.hpp"
#include "groundstation/sweep/table.hpp"

namespace skein::reproduce {
namespace {

using Json = nlohmann::ordered_json;

Json figures_of_flights(int agents) {
  Json figures{{"collisions", 0}, {"steps", 100}, {"radio.sent_bytes", 45000}, {"radio.sent_samples", 450}};
  for (int k = 1; k <= agents; ++k) {
    const std::string name = "vehicles." + std::to_string(k) + ".";
    figures[name + "path_length_m"] = 500.0 + 10.0 * k;
    figures[name + "shortest_path_m"] = 500.0;
    if (k > 1) figures[name + "arrival_step"] = 80;  // the first does not arrive
  }
  return figures;
}

Json figures_of_plans() {
  Json figures{{"plan_spread_m", 3.0}, {"plan_s", 0.01}};
  for (const char* k : {"1", "2", "3"}) {
    const std::string name = std::string("vehicles.") + k;
    figures[name + ".planned_length_m"] = 35000.0 + 10.0 * (k[0] - '0');
    figures[name + ".max_curvature_per_m"] = 0.0015;
    figures[name + ".max_torsion_per_m"] = 0.001;
  }
  for (const char* pair : {"1-2", "1-3", "2-3"}) figures[std::string("separations.") + pair + ".planned_m"] = 1000.0;
  return figures;
}

/// One run of every combination.
Results made_up(Paper paper) {
  Results results;
  for (Campaign& campaign : campaigns_of(paper)) {
    CampaignResult result{campaign, 1, Json::array(), Json::array()};
    for (const auto& set : combinations_of(campaign.keys)) {
      Json row{{"set", Json::object()}, {"runs", 1}, {"figures", Json::object()}};
      int agents = 9;
      for (const Override& item : set) {
        row["set"][item.key] = item.value;
        if (item.key == "vehicles.agents") agents = std::stoi(item.value);
      }
      const bool plans = paper == Paper::Rendezvous;
      const Json figures = plans ? figures_of_plans() : figures_of_flights(agents);
      for (const auto& [name, value] : figures.items()) row["figures"][name] = summary_of({value.get<double>()});
      const Json plan = plans ? Json(true) : Json(nullptr);
      row["per_run"] = {
          {{"seed", 0}, {"exit_code", 0}, {"plan_success", plan}, {"plan_feasible", plan}, {"figures", figures}}};
      result.rows.push_back(row);
    }
    result.table = table_of(result.rows);
    results.campaigns.push_back(std::move(result));
  }
  return results;
}

const TableRow& row_of(const std::vector<Table>& tables, const std::string& id, const std::string& figure) {
  const auto table = std::ranges::find(tables, id, &Table::id);
  if (table == tables.end()) throw std::out_of_range(id);
  const auto row = std::ranges::find(table->rows, figure, &TableRow::figure);
  if (row == table->rows.end()) throw std::out_of_range(figure);
  return *row;
}

/// Tables with a cell for each column, a source for each row with a figure of a paper, and none without. @return the
/// papers' figures in them, as "text @ source"
std::set<std::string> check_shape(const std::vector<Table>& tables) {
  std::set<std::string> seen;
  for (const Table& table : tables) {
    EXPECT_FALSE(table.id.empty());
    EXPECT_FALSE(table.notes.empty()) << table.id;
    for (const TableRow& row : table.rows) {
      EXPECT_EQ(row.cells.size(), table.columns.size()) << table.id << ": " << row.figure;
      EXPECT_FALSE(row.unit.empty()) << table.id << ": " << row.figure;
      bool paper = false;
      for (const Cell& cell : row.cells) {
        if (!cell.data.contains("paper")) continue;
        paper = true;
        seen.insert(cell.text + " @ " + cell.data.at("source").get<std::string>());
      }
      EXPECT_EQ(paper, row.source != "-") << table.id << ": " << row.figure;
    }
  }
  return seen;
}

TEST(Tables, EveryFigureOfThePapersStandsInOne) {
  std::set<std::string> seen = check_shape(rendezvous_tables(made_up(Paper::Rendezvous)));
  seen.merge(check_shape(transit_tables(made_up(Paper::Transit))));
  for (const PaperFigure& figure : paper_figures()) {
    EXPECT_TRUE(seen.contains(std::string(figure.text) + " @ " + std::string(figure.source))) << figure.key;
  }
}

TEST(Tables, AreLeftOutIfNothingWasRun) {
  EXPECT_TRUE(rendezvous_tables({}).empty());
  EXPECT_TRUE(transit_tables({}).empty());
}

TEST(Tables, TheMethodAsPrintedStandsBesideThePapers) {
  const auto tables = rendezvous_tables(made_up(Paper::Rendezvous));
  const auto table4 = std::ranges::find(tables, "rendezvous.table4", &Table::id);
  ASSERT_NE(table4, tables.end());
  EXPECT_EQ(table4->columns, (std::vector<std::string>{"paper, DCPSO", "`dcpso-paper`", "`dcpso`", "paper, CCGA",
                                                       "`ccga`", "`dcpso-solo`"}));
  const TableRow& l1 = row_of(tables, "rendezvous.table4", "L1, mean (sd)");
  EXPECT_EQ(l1.cells[0].text, "35.0611 (0.0001)");
  EXPECT_EQ(l1.cells[1].text, "35.0100 (0.0000)");
  const TableRow& difference = row_of(tables, "rendezvous.table4", "largest difference of the means");
  EXPECT_EQ(difference.cells[1].text, "0.0200");
  EXPECT_TRUE(row_of(tables, "rendezvous.table4", "computation time, mean").cells[1].timed);
}

TEST(Tables, FlightsAreCountedOverSwarmsAndCells) {
  const auto tables = transit_tables(made_up(Paper::Transit));
  const TableRow& arrived = row_of(tables, "transit.fig5", "UAVs that arrive");
  EXPECT_EQ(arrived.cells[1].text, "60 of 72");  // 24 a cell size, of which the first of each of four swarms is missing
  EXPECT_EQ(row_of(tables, "transit.fig5", "runs in which some do not").cells[3].text, "12 of 12");
  EXPECT_EQ(row_of(tables, "transit.fig5", "arrived, cells of 4 m").cells[4].text, "20 of 24");
  // of 2 .. 3, 5, 7 and 9, the middle two of 20 are the fourth ones: 540 m
  EXPECT_EQ(row_of(tables, "transit.fig5", "distance flown, cells of 2 m, median").cells[4].text, "540");
  EXPECT_EQ(row_of(tables, "transit.fig5", "over the shortest, cells of 2 m, median").cells[4].text, "1.08");
  EXPECT_EQ(row_of(tables, "transit.fig5", "least distance flown, cells of 6 m").cells[4].text, "520");
  EXPECT_EQ(row_of(tables, "transit.fig5", "flights under 600 m, cells of 6 m").cells[4].text, "20 of 24");
  EXPECT_EQ(row_of(tables, "transit.fig5", "the longest flight, cells of 6 m, is in a swarm of").cells[4].text, "9");
}

TEST(Tables, BitsOnAirAreAMeanOfFrames) {
  const auto tables = transit_tables(made_up(Paper::Transit));
  const TableRow& row = row_of(tables, "transit.radio", "sent by a UAV in 2 s, nine UAVs, cells of 4 m");
  EXPECT_EQ(row.cells[1].text, "31.2");  // 125 x 125 cells of 2 bits
  // 45000 bytes and 450 headers of 192 bits, by nine in 50 frames
  EXPECT_EQ(row.cells[2].text, "1.0");
  EXPECT_NEAR(row.cells[2].data.at("value").get<double>(), (8.0 * 45000 + 192.0 * 450) / 450.0 / 1000.0, 1e-12);
}

}  // namespace
}  // namespace skein::reproduce
