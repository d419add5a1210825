#include "simworld/scenario/reader.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "simworld/scenario/overrides.hpp"

namespace skein::scenario {
namespace {

/// Levenshtein's distance, row by row.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

bool has_leading_zero(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  return text.size() > 1 && text[0] == '0' && text[1] >= '0' && text[1] <= '9';
}

/// The whole text as a number, or nothing. Only what starts as a decimal number does: not inf, nan, 0x10, +1, 1_000.
template <typename Number>
std::optional<Number> parse(const YamlNode& node) {
  const std::string& text = node.text;
  if (node.in_quotes || text.find_first_of("nN") != std::string::npos || has_leading_zero(text)) return std::nullopt;
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string shown(const YamlNode& node) {
  switch (node.kind) {
    case NodeKind::Null:
      return "empty";
    case NodeKind::List:
      return "a list";
    case NodeKind::Map:
      return "a map";
    case NodeKind::Scalar:
      break;
  }
  if (node.in_quotes) return "the text " + quote_text(node.text);
  return parse<double>(node) ? node.text.substr(0, 60) : quote_text(node.text);
}

bool means_more_than_text(const YamlNode& node) {
  static constexpr std::string_view kWords[] = {"yes", "no", "on", "off", "true", "false", "y", "n"};
  if (node.in_quotes) return false;
  std::string lower = node.text;
  std::ranges::transform(lower, lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return std::ranges::find(kWords, lower) != std::end(kWords) || parse<double>(node) || has_leading_zero(lower);
}

bool is_name(std::string_view text) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  };
  return !text.empty() && text.size() <= 64 && std::ranges::all_of(text, allowed);
}

}  // namespace

std::string_view nearest_key(std::string_view key, std::span<const std::string_view> allowed) {
  std::string_view nearest;
  std::size_t fewest = key.size() + 64;
  if (key.size() > 64) return nearest;
  for (const std::string_view candidate : allowed) {
    const std::size_t count = edits(key, candidate);
    if (count < fewest && count <= std::max<std::size_t>(1, candidate.size() / 3)) {
      nearest = candidate;
      fewest = count;
    }
  }
  return nearest;
}

Place place_of_item(const YamlNode& item) {
  for (const YamlNode& child : item.children) {
    if (!child.place.set_key.empty()) return child.place;
  }
  return item.place;
}

MapReader::MapReader(const YamlNode* node, std::string path, std::span<const std::string_view> allowed,
                     Place missing_at)
    : node_(node), path_(std::move(path)), missing_at_(std::move(missing_at)) {
  if (node_ == nullptr) return;
  if (node_->kind != NodeKind::Map) {
    throw ReadFault(node_->place, fmt::format("{} is {}; allowed: the keys {}", path_.empty() ? "the scenario" : path_,
                                              shown(*node_), fmt::join(allowed, ", ")));
  }
  for (const YamlNode& entry : node_->children) {
    if (std::ranges::find(allowed, entry.key) != allowed.end()) continue;
    const std::string_view nearest = nearest_key(entry.key, allowed);
    const std::string where = path_.empty() ? "" : " in " + path_;
    throw ReadFault(
        entry.key_place,
        nearest.empty()
            ? fmt::format("unknown key {}{}; allowed: {}", quote_text(entry.key), where, fmt::join(allowed, ", "))
            : fmt::format("unknown key {}{}; did you mean '{}'?", quote_text(entry.key), where, nearest));
  }
}

double MapReader::number(std::string_view key, const Limits& limits, std::optional<double> fallback) const {
  const std::string allowed =
      fmt::format("a number from {} to {}{}{}", limits.min, limits.max, limits.unit.empty() ? "" : " ", limits.unit);
  const YamlNode* node = scalar(key, !fallback.has_value(), allowed);
  if (node == nullptr) return *fallback;
  const std::optional<double> value = parse<double>(*node);
  if (!value || !std::isfinite(*value) || *value < limits.min || *value > limits.max) refuse(key, allowed);
  return *value;
}

std::uint64_t MapReader::whole(std::string_view key, std::uint64_t min, std::uint64_t max,
                               std::optional<std::uint64_t> fallback) const {
  const std::string allowed = fmt::format("a whole number from {} to {}", min, max);
  const YamlNode* node = scalar(key, !fallback.has_value(), allowed);
  if (node == nullptr) return *fallback;
  const std::optional<std::uint64_t> value = parse<std::uint64_t>(*node);
  if (!value || *value < min || *value > max) refuse(key, allowed);
  return *value;
}

std::string MapReader::word(std::string_view key, std::span<const std::string_view> words,
                            std::optional<std::string_view> fallback) const {
  const std::string allowed = fmt::format("{}", fmt::join(words, ", "));
  const YamlNode* node = scalar(key, !fallback.has_value(), allowed);
  if (node == nullptr) return std::string(*fallback);
  if (std::ranges::find(words, node->text) == words.end()) refuse(key, allowed);
  return node->text;
}

std::string MapReader::name(std::string_view key) const {
  constexpr std::string_view kAllowed = "1 to 64 letters, digits, dots, - and _";
  const YamlNode* node = scalar(key, true, kAllowed);
  if (means_more_than_text(*node)) {
    refuse(key, "text; put what YAML could take for a number or a truth value in quotes");
  }
  if (!is_name(node->text)) refuse(key, kAllowed);
  return node->text;
}

std::string MapReader::text(std::string_view key) const {
  constexpr std::string_view kAllowed = "1 to 256 printable characters";
  const YamlNode* node = scalar(key, true, kAllowed);
  const bool printable = std::ranges::all_of(node->text, [](char c) { return c >= ' ' && c <= '~'; });
  if (node->text.empty() || node->text.size() > 256 || !printable) refuse(key, kAllowed);
  return node->text;
}

std::span<const YamlNode> MapReader::list(std::string_view key, std::size_t max, bool required) const {
  const std::string allowed = fmt::format("a list of {} to {} items", required ? 1 : 0, max);
  const YamlNode* node = find(key);
  if (node == nullptr && !required) return {};
  if (node == nullptr || node->kind != NodeKind::List) refuse(key, allowed);
  if ((required && node->children.empty()) || node->children.size() > max) {
    throw ReadFault(node->place, fmt::format("{} has {} items; allowed: {} to {}", path_of(key), node->children.size(),
                                             required ? 1 : 0, max));
  }
  return node->children;
}

MapReader MapReader::map(std::string_view key, std::span<const std::string_view> allowed, bool required) const {
  const YamlNode* node = find(key);
  if (node == nullptr && required) refuse(key, fmt::format("the keys {}", fmt::join(allowed, ", ")));
  return {node, path_of(key), allowed, node == nullptr ? missing_at_ : node->key_place};
}

MapReader MapReader::item(std::string_view key, std::size_t index, std::span<const std::string_view> allowed) const {
  const YamlNode& list = *find(key);
  const YamlNode& node = list.children[index];
  return {&node, fmt::format("{}.{}", path_of(key), item_name(list, index)), allowed, node.place};
}

const YamlNode* MapReader::find(std::string_view key) const {
  return node_ == nullptr ? nullptr : node_->find(key);
}

Place MapReader::place_of(std::string_view key) const {
  const YamlNode* node = find(key);
  return node == nullptr ? missing_at_ : node->place;
}

std::string MapReader::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

void MapReader::refuse(std::string_view key, std::string_view allowed) const {
  const YamlNode* node = find(key);
  if (node == nullptr) throw ReadFault(missing_at_, fmt::format("{} is missing; allowed: {}", path_of(key), allowed));
  throw ReadFault(node->place, fmt::format("{} is {}; allowed: {}{}", path_of(key), shown(*node), allowed,
                                           has_leading_zero(node->text) ? ", without leading zeros" : ""));
}

const YamlNode* MapReader::scalar(std::string_view key, bool required, std::string_view allowed) const {
  const YamlNode* node = find(key);
  if (node == nullptr && !required) return nullptr;
  if (node == nullptr || node->kind != NodeKind::Scalar) refuse(key, allowed);
  return node;
}

}  // namespace skein::scenario
