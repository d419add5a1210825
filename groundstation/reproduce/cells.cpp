#include "groundstation/reproduce/cells.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace skein::reproduce {

Cell paper_cell(std::string_view key) {
  const PaperFigure* figure = find_paper_figure(key);
  if (figure == nullptr) return {};
  Cell cell{std::string(figure->text), {{"paper", true}, {"source", figure->source}}};
  if (figure->value) cell.data["value"] = *figure->value;
  if (figure->sd) cell.data["sd"] = *figure->sd;
  return cell;
}

Cell number_cell(double value, int digits) {
  return {fmt::format("{:.{}f}", value, digits), {{"value", value}}};
}

Cell count_cell(std::size_t count, std::size_t of) {
  if (of == 0) return {};
  return {fmt::format("{} of {}", count, of), {{"count", count}, {"of", of}}};
}

Cell mean_cell(const Combination& combination, const std::string& figure, double scale, int digits, bool with_sd) {
  const auto& figures = combination.entry->at("figures");
  if (!figures.contains(figure)) return {};
  const double mean = scale * figures.at(figure).at("mean").get<double>();
  const double sd = scale * figures.at(figure).at("sd").get<double>();
  Cell cell = number_cell(mean, digits);
  if (with_sd) cell.text += fmt::format(" ({:.{}f})", sd, digits);
  cell.data["sd"] = sd;
  cell.data["count"] = figures.at(figure).at("count");
  return cell;
}

Cell rate_cell(const Combination& combination, const char* rate) {
  if (!combination.entry->contains(rate)) return {};
  const auto& data = combination.entry->at(rate);
  if (data.at("rate").is_null()) return {};
  return {fmt::format("{:.3f} [{:.3f}, {:.3f}]", data.at("rate").get<double>(), data.at("low").get<double>(),
                      data.at("high").get<double>()),
          {{"value", data.at("rate")}, {"low", data.at("low")}, {"high", data.at("high")}}};
}

Cell successes_cell(const Combination& combination, const char* rate) {
  if (!combination.entry->contains(rate)) return {};
  const auto count = combination.entry->at(rate).at("count").get<std::size_t>();
  return {fmt::format("{}", count), {{"value", count}}};
}

Cell most_cell(const Combination& combination, const std::vector<std::string>& figures, double scale, int digits) {
  const auto& summary = combination.row->at("figures");
  std::optional<double> most;
  for (const std::string& figure : figures) {
    if (!summary.contains(figure)) continue;
    most = std::max(most.value_or(0.0), scale * summary.at(figure).at("max").get<double>());
  }
  return most ? number_cell(*most, digits) : Cell{};
}

std::string sources_of(const std::vector<std::string>& keys) {
  std::string text;
  for (const std::string& key : keys) {
    const PaperFigure* figure = find_paper_figure(key);
    if (figure == nullptr || text.find(figure->source) != std::string::npos) continue;
    text += (text.empty() ? "" : "; ") + std::string(figure->source);
  }
  return text.empty() ? "-" : text;
}

}  // namespace skein::reproduce
