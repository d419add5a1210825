// Rows of the transit tables: a figure of each planner, reckoned from its flights.
//
// A row keeps references to the flights that it is reckoned from; they must live until its table is made.
// Complexity: O(flights log flights) a row.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "groundstation/reproduce/campaign.hpp"
#include "groundstation/reproduce/flights.hpp"
#include "groundstation/reproduce/table.hpp"

namespace skein::reproduce {

/// A planner of ours, and whose figures of the paper stand before it.
struct Planner {
  std::string name;
  std::string paper;  ///< "peach", "peach3d", or empty: the paper has none
  std::string title;  ///< of the paper's
};

/// A figure of each planner; `ours(i)` is that of planner i.
struct Row {
  std::string key;
  std::string figure;
  std::string unit;
  std::function<Cell(std::size_t)> ours;
};

/// The flights of one cell size, by planner.
struct CellFlights {
  std::string cell_m;
  std::vector<Flights> by_planner;
  std::vector<std::vector<Flight>> together;  ///< by planner: those in which all arrive
};

/// A column of each planner, that of the paper's before it; the paper's figures are those of `prefix`.
[[nodiscard]] Table table_of_rows(const std::string& prefix, const std::vector<Planner>& planners,
                                  const std::vector<Row>& rows);

[[nodiscard]] std::vector<CellFlights> by_cell(const Results& results, const std::string& campaign,
                                               const std::vector<Planner>& planners,
                                               std::span<const char* const> cells);

/// The median of a figure over the flights that have it.
using FlightFigure = std::optional<double> (*)(const Flight&);
[[nodiscard]] Cell median_cell(const std::vector<Flight>& flights, FlightFigure figure, int digits);
[[nodiscard]] std::optional<double> flown_of(const Flight& flight);
[[nodiscard]] std::optional<double> over_shortest(const Flight& flight);

/// Over the flights in which all planners arrive.
[[nodiscard]] Row median_row(const CellFlights& flights);
[[nodiscard]] Row ratio_row(const CellFlights& flights);

/// UAVs that arrive, of one cell size and of all.
[[nodiscard]] Row arrived_row(const CellFlights& flights);
[[nodiscard]] Row arrived_row(const std::vector<CellFlights>& cells);

/// Runs in which somebody does not arrive.
[[nodiscard]] Row stuck_row(const std::vector<CellFlights>& cells);

/// Of all runs of a campaign.
[[nodiscard]] Row collisions_row(const Results& results, const std::string& campaign,
                                 const std::vector<Planner>& planners);

}  // namespace skein::reproduce
