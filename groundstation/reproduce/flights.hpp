// Single flights out of the runs of a transit campaign, and figures over many of them.
//
// A flight is one vehicle of one run. Planners are compared over the flights in which all of them arrive: the same
// seed, swarm and vehicle, hence the same start and goal. Complexity: O(flights log flights).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "groundstation/reproduce/campaign.hpp"

namespace skein::reproduce {

struct Flight {
  bool arrived = false;
  double flown_m = 0.0;
  std::optional<double> shortest_m;  ///< with full knowledge along 8 (26) directions; none if there is no way
};

/// Seed, vehicles of the swarm, id.
using FlightKey = std::tuple<std::uint64_t, std::uint32_t, std::uint32_t>;
using Flights = std::map<FlightKey, Flight>;

/// All flights of the campaign's combinations that have these values.
[[nodiscard]] Flights flights_of(const Results& results, const std::string& campaign, std::span<const Override> values);

/// The flights of `flights` that arrive in each of `others` too.
[[nodiscard]] std::vector<Flight> arrived_in_all(const Flights& flights, std::span<const Flights> others);

[[nodiscard]] std::size_t arrivals(const Flights& flights);

/// The runs (seed and swarm), and those of them in which somebody did not arrive.
struct RunCount {
  std::size_t runs = 0;
  std::size_t incomplete = 0;
};
[[nodiscard]] RunCount runs_in(const Flights& flights);

/// The middle one, or the mean of the middle two; nothing of nothing.
[[nodiscard]] std::optional<double> median_of(std::vector<double> values);

}  // namespace skein::reproduce
