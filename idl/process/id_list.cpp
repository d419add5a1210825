#include "idl/process/id_list.hpp"

#include <algorithm>
#include <charconv>

namespace skein {
namespace {

std::optional<AgentId> id_from(std::string_view text) {
  AgentId id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && id >= 1 && id <= kMaxAgents ? std::optional(id) : std::nullopt;
}

}  // namespace

std::optional<std::vector<AgentId>> id_list_from(std::string_view text) {
  std::vector<AgentId> ids;
  for (bool more = true; more;) {
    const auto comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    more = comma != std::string_view::npos;
    if (more) text.remove_prefix(comma + 1);
    const auto dash = item.find('-');
    const auto first = id_from(item.substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : id_from(item.substr(dash + 1));
    if (!first || !last || *first > *last) return std::nullopt;
    for (AgentId id = *first; id <= *last; ++id) ids.push_back(id);
  }
  std::ranges::sort(ids);
  return std::ranges::adjacent_find(ids) == ids.end() ? std::optional(ids) : std::nullopt;
}

std::string text_of(std::span<const AgentId> ids) {
  std::string text;
  for (std::size_t i = 0; i < ids.size();) {
    std::size_t last = i;
    while (last + 1 < ids.size() && ids[last + 1] == ids[last] + 1) ++last;
    if (last < i + 2) last = i;
    if (!text.empty()) text += ',';
    text += std::to_string(ids[i]);
    if (last > i) text += '-' + std::to_string(ids[last]);
    i = last + 1;
  }
  return text;
}

}  // namespace skein
