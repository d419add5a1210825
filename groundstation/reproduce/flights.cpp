#include "groundstation/reproduce/flights.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace skein::reproduce {
namespace {

/// "vehicles.12.path_length_m" -> 12, if it is that figure.
std::optional<std::uint32_t> vehicle_in(std::string_view figure) {
  constexpr std::string_view kHead = "vehicles.";
  constexpr std::string_view kTail = ".path_length_m";
  if (!figure.starts_with(kHead) || !figure.ends_with(kTail)) return std::nullopt;
  figure.remove_prefix(kHead.size());
  figure.remove_suffix(kTail.size());
  std::uint32_t id = 0;
  const auto read = std::from_chars(figure.data(), figure.data() + figure.size(), id);
  return read.ec == std::errc{} ? std::optional(id) : std::nullopt;
}

void add_run(const nlohmann::ordered_json& run, Flights& flights) {
  const auto& figures = run.at("figures");
  std::vector<std::uint32_t> ids;
  for (const auto& [name, value] : figures.items()) {
    if (const auto id = vehicle_in(name)) ids.push_back(*id);
  }
  const auto swarm = static_cast<std::uint32_t>(ids.size());
  for (const std::uint32_t id : ids) {
    const std::string name = fmt::format("vehicles.{}.", id);
    Flight flight{figures.contains(name + "arrival_step"), figures.at(name + "path_length_m").get<double>(), {}};
    const std::string shortest = name + "shortest_path_m";
    if (figures.contains(shortest)) flight.shortest_m = figures.at(shortest).get<double>();
    flights[{run.at("seed").get<std::uint64_t>(), swarm, id}] = flight;
  }
}

}  // namespace

Flights flights_of(const Results& results, const std::string& campaign, std::span<const Override> values) {
  Flights flights;
  for (const CampaignResult& result : results.campaigns) {
    if (result.campaign.name != campaign) continue;
    for (const auto& row : result.rows) {
      const auto& set = row.at("set");
      const bool wanted = std::ranges::all_of(
          values, [&](const Override& value) { return set.contains(value.key) && set.at(value.key) == value.value; });
      if (!wanted) continue;
      for (const auto& run : row.at("per_run")) add_run(run, flights);
    }
  }
  return flights;
}

std::vector<Flight> arrived_in_all(const Flights& flights, std::span<const Flights> others) {
  std::vector<Flight> together;
  for (const auto& [key, flight] : flights) {
    const bool all = std::ranges::all_of(others, [&key = key](const Flights& other) {
      const auto same = other.find(key);
      return same != other.end() && same->second.arrived;
    });
    if (flight.arrived && all) together.push_back(flight);
  }
  return together;
}

std::size_t arrivals(const Flights& flights) {
  return static_cast<std::size_t>(std::ranges::count_if(flights, [](const auto& item) { return item.second.arrived; }));
}

RunCount runs_in(const Flights& flights) {
  std::map<std::pair<std::uint64_t, std::uint32_t>, bool> all_arrive;
  for (const auto& [key, flight] : flights) {
    const auto [place, added] = all_arrive.try_emplace({std::get<0>(key), std::get<1>(key)}, true);
    place->second = place->second && flight.arrived;
  }
  const auto complete = std::ranges::count_if(all_arrive, [](const auto& item) { return item.second; });
  return {all_arrive.size(), all_arrive.size() - static_cast<std::size_t>(complete)};
}

std::optional<double> median_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
}

}  // namespace skein::reproduce
