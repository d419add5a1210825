#include "groundstation/reproduce/transit_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "groundstation/reproduce/cells.hpp"
#include "groundstation/reproduce/flight_rows.hpp"

namespace skein::reproduce {
namespace {

constexpr double kSide_m = 500.0;           ///< of the area, section IV-B
constexpr double kBitsPerCell = 2.0;        ///< section IV-B
constexpr double kPaperShortest_m = 600.0;  ///< section IV-C: cells of 6 m
constexpr std::array<const char*, 3> kCells_m{"2", "4", "6"};

/// What section IV-C says of cells of 6 m.
std::vector<Row> rows_of_six(const CellFlights& flights) {
  return {{"least6", "least distance flown, cells of 6 m", "m",
           [&flights](std::size_t i) {
             std::optional<double> least;
             for (const auto& [key, flight] : flights.by_planner[i]) {
               if (flight.arrived) least = std::min(least.value_or(flight.flown_m), flight.flown_m);
             }
             return least ? number_cell(*least, 0) : Cell{};
           }},
          {"under600", "flights under 600 m, cells of 6 m", "-",
           [&flights](std::size_t i) {
             const Flights& own = flights.by_planner[i];
             const auto under = std::ranges::count_if(
                 own, [](const auto& item) { return item.second.arrived && item.second.flown_m < kPaperShortest_m; });
             return count_cell(static_cast<std::size_t>(under), own.size());
           }},
          {"longest6", "the longest flight, cells of 6 m, is in a swarm of", "-", [&flights](std::size_t i) {
             const Flights& own = flights.by_planner[i];
             const FlightKey* longest = nullptr;
             double most_m = 0.0;
             for (const auto& [key, flight] : own) {
               if (!flight.arrived || flight.flown_m <= most_m) continue;
               most_m = flight.flown_m;
               longest = &key;
             }
             return longest != nullptr ? number_cell(std::get<1>(*longest), 0) : Cell{};
           }}};
}

bool was_run(const Results& results, const std::string& campaign) {
  return std::ranges::any_of(results.campaigns, [&](const CampaignResult& result) {
    return result.campaign.name == campaign &&
           std::ranges::any_of(result.rows, [](const auto& row) { return row.at("runs") != 0; });
  });
}

const std::vector<Planner>& planners_of_fig5() {
  static const std::vector<Planner> kPlanners{
      {"peach", "peach", "paper, Peach"}, {"peach3d-paper", "peach3d", "paper, 3DGPeach"}, {"peach3d", "", ""}};
  return kPlanners;
}

Table fig5(const Results& results, const std::string& campaign, bool drawn) {
  const std::vector<Planner>& planners = planners_of_fig5();
  const auto cells = by_cell(results, campaign, planners, kCells_m);
  std::vector<Row> rows{arrived_row(cells), stuck_row(cells)};
  for (const CellFlights& cell : cells) rows.push_back(arrived_row(cell));
  for (const CellFlights& cell : cells) rows.push_back(median_row(cell));
  for (const CellFlights& cell : cells) rows.push_back(ratio_row(cell));
  for (Row& row : drawn ? std::vector<Row>{} : rows_of_six(cells.back())) rows.push_back(std::move(row));
  rows.push_back(collisions_row(results, campaign, planners));
  return table_of_rows("fig5", planners, rows);
}

/// Bits that a UAV sends in a frame of 2 s, headers and intents with them.
Cell mean_bits(const Combination& combination, double agents) {
  constexpr double kFrame_s = 2.0;
  constexpr double kHeader_bits = 192.0;
  double sum = 0.0;
  const auto& runs = combination.row->at("per_run");
  for (const auto& run : runs) {
    const auto& f = run.at("figures");
    const double bits =
        8.0 * f.at("radio.sent_bytes").get<double>() + kHeader_bits * f.at("radio.sent_samples").get<double>();
    sum += bits / (agents * std::ceil(f.at("steps").get<double>() / kFrame_s));
  }
  return number_cell(1e-3 * sum / static_cast<double>(runs.size()), 1);
}

Table on_air(const Results& results) {
  Table table;
  table.columns = {"paper, at most", "whole matrix, reckoned", "`peach3d`, mean", "`peach3d`, most", "a UAV's slot"};
  for (const char* cell : kCells_m) {
    TableRow row{fmt::format("sent by a UAV in 2 s, nine UAVs, cells of {} m", cell), "kbit", {}, ""};
    const double side = std::floor(kSide_m / std::stod(cell));
    row.cells = {paper_cell("radio.matrix.limit"), number_cell(1e-3 * kBitsPerCell * side * side, 1)};
    const std::vector<Override> values{{"planner.name", "peach3d"}, {"planner.cell_m", cell}, {"vehicles.agents", "9"}};
    const auto combination = combination_of(results, "fig5-listed", values);
    row.cells.push_back(combination ? mean_bits(*combination, 9.0) : Cell{});
    row.cells.push_back(combination ? most_cell(*combination, {"radio.peak_slot_bits"}, 1e-3, 1) : Cell{});
    row.cells.push_back(combination ? most_cell(*combination, {"radio.slot_bits"}, 1e-3, 1) : Cell{});
    row.source = sources_of({"radio.matrix.limit"});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table fig8(const Results& results) {
  static const std::vector<Planner> kPlanners{{"peach3d-paper", "peach3d", "paper, 3DGPeach"}, {"peach3d", "", ""}};
  constexpr std::array<const char*, 4> kWidths_m{"1", "2", "3", "4"};
  const auto cells = by_cell(results, "fig8", kPlanners, kWidths_m);
  std::vector<Row> rows{arrived_row(cells)};
  for (const CellFlights& cell : cells) rows.push_back(median_row(cell));
  for (const CellFlights& cell : cells) rows.push_back(ratio_row(cell));
  rows.push_back(collisions_row(results, "fig8", kPlanners));
  return table_of_rows("fig8", kPlanners, rows);
}

Table fig9(const Results& results) {
  const std::vector<Planner>& planners = planners_of_fig5();
  std::vector<Flights> by_planner;
  by_planner.reserve(planners.size());
  for (const Planner& planner : planners) {
    by_planner.push_back(flights_of(results, "fig9", std::vector<Override>{{"planner.name", planner.name}}));
  }
  const auto median = [&](std::size_t i, const auto& figure, int digits) {
    std::vector<Flight> there;
    for (const auto& [key, flight] : by_planner[i]) {
      if (flight.arrived) there.push_back(flight);
    }
    return median_cell(there, figure, digits);
  };
  return table_of_rows(
      "fig9", planners,
      {{"arrived", "UAVs that arrive", "-",
        [&](std::size_t i) { return count_cell(arrivals(by_planner[i]), by_planner[i].size()); }},
       {"median", "distance flown, median of its arrivals", "m", [&](std::size_t i) { return median(i, flown_of, 0); }},
       {"ratio", "over the shortest, median of its arrivals", "-",
        [&](std::size_t i) { return median(i, over_shortest, 2); }},
       collisions_row(results, "fig9", planners)});
}

void add(std::vector<Table>& tables, Table table, std::string id, std::string title, std::vector<std::string> notes) {
  table.id = std::move(id);
  table.title = std::move(title);
  table.notes = std::move(notes);
  tables.push_back(std::move(table));
}

}  // namespace

std::vector<Table> transit_tables(const Results& results) {
  std::vector<Table> tables;
  if (was_run(results, "fig5-listed")) {
    add(tables, fig5(results, "fig5-listed", false), "transit.fig5",
        "Fig. 5: 3, 5, 7 and 9 UAVs across the power station",
        {"Each run has the scenario's own starts and goal; the seed draws the losses. The paper plots each distance "
         "and "
         "prints no median.",
         "Medians are over the flights in which all three arrive; 'the shortest' is the shortest path with full "
         "knowledge along 8 directions, which flight at any angle can undercut."});
    add(tables, on_air(results), "transit.radio", "Section IV-B: what goes on air",
        {"The paper's UAVs send the whole matrix, 2 bits a cell (of 500 m x 500 m, reckoned here: it prints the limit "
         "alone); ours send what the others lack, within a ninth of the channel each. Headers and intents are "
         "counted."});
  }
  if (was_run(results, "fig5-drawn")) {
    add(tables, fig5(results, "fig5-drawn", true), "transit.fig5b", "Fig. 5 again: starts and goals drawn by the seed",
        {"Starts lie anywhere west of the wall and one goal east of it, from cells that a path joins: what the paper "
         "says of "
         "600 m does not apply."});
  }
  if (was_run(results, "fig8")) {
    add(tables, fig8(results), "transit.fig8", "Fig. 7 and 8: six UAVs through a corridor",
        {"After Sun et al.; obstacles in pictures only. Levels of 1 m, cells of 1 to 4 m."});
  }
  if (was_run(results, "fig9")) {
    add(tables, fig9(results), "transit.fig9", "Fig. 9: four UAVs in space, each to its own goal",
        {"`peach` is the paper's planner in the plane, here over 27 cells; the paper does not fly it in space. Runs "
         "end "
         "after 4000 s."});
  }
  return tables;
}

}  // namespace skein::reproduce
