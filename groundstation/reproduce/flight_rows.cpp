#include "groundstation/reproduce/flight_rows.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "groundstation/reproduce/cells.hpp"

namespace skein::reproduce {

Table table_of_rows(const std::string& prefix, const std::vector<Planner>& planners, const std::vector<Row>& rows) {
  Table table;
  for (const Planner& planner : planners) {
    if (!planner.paper.empty()) table.columns.push_back(planner.title);
    table.columns.push_back("`" + planner.name + "`");
  }
  for (const Row& row : rows) {
    TableRow line{row.figure, row.unit, {}, ""};
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < planners.size(); ++i) {
      if (!planners[i].paper.empty()) {
        keys.push_back(fmt::format("{}.{}.{}", prefix, planners[i].paper, row.key));
        line.cells.push_back(paper_cell(keys.back()));
      }
      line.cells.push_back(row.ours(i));
    }
    line.source = sources_of(keys);
    table.rows.push_back(std::move(line));
  }
  return table;
}

std::vector<CellFlights> by_cell(const Results& results, const std::string& campaign,
                                 const std::vector<Planner>& planners, std::span<const char* const> cells) {
  std::vector<CellFlights> all;
  for (const char* cell : cells) {
    CellFlights flights{cell, {}, {}};
    for (const Planner& planner : planners) {
      const std::vector<Override> values{{"planner.name", planner.name}, {"planner.cell_m", cell}};
      flights.by_planner.push_back(flights_of(results, campaign, values));
    }
    for (const Flights& own : flights.by_planner) flights.together.push_back(arrived_in_all(own, flights.by_planner));
    all.push_back(std::move(flights));
  }
  return all;
}

Cell median_cell(const std::vector<Flight>& flights, FlightFigure figure, int digits) {
  std::vector<double> values;
  for (const Flight& flight : flights) {
    if (const auto value = figure(flight)) values.push_back(*value);
  }
  const auto median = median_of(values);
  if (!median) return {};
  Cell cell = number_cell(*median, digits);
  cell.data["count"] = values.size();
  return cell;
}

std::optional<double> flown_of(const Flight& flight) {
  return flight.flown_m;
}

std::optional<double> over_shortest(const Flight& flight) {
  return flight.shortest_m ? std::optional(flight.flown_m / *flight.shortest_m) : std::nullopt;
}

Row median_row(const CellFlights& flights) {
  return {"median" + flights.cell_m, fmt::format("distance flown, cells of {} m, median", flights.cell_m), "m",
          [&flights](std::size_t i) { return median_cell(flights.together[i], flown_of, 0); }};
}

Row ratio_row(const CellFlights& flights) {
  return {"ratio" + flights.cell_m, fmt::format("over the shortest, cells of {} m, median", flights.cell_m), "-",
          [&flights](std::size_t i) { return median_cell(flights.together[i], over_shortest, 2); }};
}

Row arrived_row(const CellFlights& flights) {
  return {
      "arrived" + flights.cell_m, fmt::format("arrived, cells of {} m", flights.cell_m), "-",
      [&flights](std::size_t i) { return count_cell(arrivals(flights.by_planner[i]), flights.by_planner[i].size()); }};
}

Row arrived_row(const std::vector<CellFlights>& cells) {
  return {"arrived", "UAVs that arrive", "-", [&cells](std::size_t i) {
            std::size_t there = 0;
            std::size_t all = 0;
            for (const CellFlights& cell : cells) {
              there += arrivals(cell.by_planner[i]);
              all += cell.by_planner[i].size();
            }
            return count_cell(there, all);
          }};
}

Row stuck_row(const std::vector<CellFlights>& cells) {
  return {"stuck", "runs in which some do not", "-", [&cells](std::size_t i) {
            RunCount count;
            for (const CellFlights& cell : cells) {
              const RunCount own = runs_in(cell.by_planner[i]);
              count.runs += own.runs;
              count.incomplete += own.incomplete;
            }
            return count_cell(count.incomplete, count.runs);
          }};
}

Row collisions_row(const Results& results, const std::string& campaign, const std::vector<Planner>& planners) {
  return {"collisions", "collisions", "-", [&results, campaign, &planners](std::size_t i) {
            double sum = 0.0;
            bool any = false;
            for (const CampaignResult& result : results.campaigns) {
              if (result.campaign.name != campaign) continue;
              for (const auto& row : result.rows) {
                if (row.at("set").at("planner.name") != planners[i].name) continue;
                for (const auto& run : row.at("per_run")) sum += run.at("figures").at("collisions").get<double>();
                any = any || !row.at("per_run").empty();
              }
            }
            return any ? number_cell(sum, 0) : Cell{};
          }};
}

}  // namespace skein::reproduce
