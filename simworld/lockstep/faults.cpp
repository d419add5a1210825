#include "simworld/lockstep/faults.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace skein {
namespace {

constexpr std::string_view kForm = "allowed: kill|stop|cont|restart:ID@plan:ROUND or @fly:STEP, or kill:world@...";
constexpr std::string_view kWorldName = "world";
constexpr std::array<std::string_view, 4> kKinds{"kill", "stop", "cont", "restart"};

/// The number that fills the whole text, at least 1.
std::optional<std::uint32_t> number(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value == 0) return std::nullopt;
  return value;
}

/// Splits at the first `mark`: the text before it, and `text` left as what follows.
std::optional<std::string_view> cut(std::string_view& text, char mark) {
  const auto at = text.find(mark);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view before = text.substr(0, at);
  text.remove_prefix(at + 1);
  return before;
}

ParsedFault wrong(std::string_view text, std::string_view what) {
  return {std::nullopt, fmt::format("--fault {}: {}; {}", text, what, kForm)};
}

}  // namespace

std::string text_of(const Fault& fault) {
  const std::string who = fault.agent == kWorldId ? std::string(kWorldName) : std::to_string(fault.agent);
  return fmt::format("{}:{}@{}:{}", kKinds.at(static_cast<std::size_t>(fault.kind)), who,
                     fault.phase == Phase::Planning ? "plan" : "fly", fault.at);
}

ParsedFault parse_fault(std::string_view text) {
  std::string_view rest = text;
  const auto kind = cut(rest, ':');
  const auto agent = kind ? cut(rest, '@') : std::nullopt;
  const auto phase = agent ? cut(rest, ':') : std::nullopt;
  if (!phase) return wrong(text, "not of the form KIND:ID@PHASE:NUMBER");
  const auto place = std::ranges::find(kKinds, *kind);
  if (place == kKinds.end()) return wrong(text, fmt::format("unknown kind '{}'", *kind));
  if (*phase != "plan" && *phase != "fly") return wrong(text, fmt::format("unknown phase '{}'", *phase));
  const auto kind_of_fault = static_cast<FaultKind>(place - kKinds.begin());
  const bool world = *agent == kWorldName && kind_of_fault == FaultKind::Kill;
  const auto id = world ? kWorldId : number(*agent);
  if (!id || *id > kMaxAgents) return wrong(text, fmt::format("'{}' is no agent id", *agent));
  const auto at = number(rest);
  if (!at) return wrong(text, fmt::format("'{}' is no round or step", rest));
  return {Fault{kind_of_fault, *id, *phase == "plan" ? Phase::Planning : Phase::Flying, *at}, {}};
}

}  // namespace skein
