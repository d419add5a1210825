#include "idl/bus/peer_info.hpp"

#include <array>
#include <charconv>

namespace skein::bus {
namespace {

constexpr std::array<std::string_view, 3> kRoles{"observer", "world", "agent"};
constexpr std::string_view kMark = "skein";

template <typename Number>
bool read(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

/// The text up to the next blank, taken off its front.
std::string_view next_word(std::string_view& text) {
  const std::size_t end = text.find(' ');
  const std::string_view word = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  return word;
}

bool read_role(std::string_view text, Role& role) {
  for (std::size_t i = 0; i < kRoles.size(); ++i) {
    if (kRoles[i] == text) {
      role = static_cast<Role>(i);
      return true;
    }
  }
  return false;
}

}  // namespace

std::string to_text(const PeerInfo& info) {
  std::string text(kMark);
  text.append(" role=").append(kRoles[static_cast<std::size_t>(info.role)]);
  text.append(" swarm=").append(info.swarm);
  text.append(" id=").append(std::to_string(info.id));
  text.append(" nonce=").append(std::to_string(info.nonce));
  text.append(" wire=").append(std::to_string(info.wire_version));
  text.append(" start=").append(std::to_string(info.start_stamp_ns));
  if (info.members != 1) text.append(" members=").append(std::to_string(info.members));
  if (info.run != 0) text.append(" run=").append(std::to_string(info.run));
  if (info.renewals != 0) text.append(" renewals=").append(std::to_string(info.renewals));
  return text;
}

std::optional<PeerInfo> peer_info_from(std::string_view text) {
  if (next_word(text) != kMark) return std::nullopt;
  PeerInfo info;
  unsigned found = 0;
  while (!text.empty()) {
    const std::string_view word = next_word(text);
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos) continue;
    const std::string_view key = word.substr(0, equals);
    const std::string_view value = word.substr(equals + 1);
    bool good = true;
    if (key == "role") {
      good = read_role(value, info.role), found |= 1U;
    } else if (key == "swarm") {
      info.swarm = value, found |= 2U;
    } else if (key == "id") {
      good = read(value, info.id), found |= 4U;
    } else if (key == "nonce") {
      good = read(value, info.nonce), found |= 8U;
    } else if (key == "wire") {
      good = read(value, info.wire_version), found |= 16U;
    } else if (key == "start") {
      good = read(value, info.start_stamp_ns), found |= 32U;
    } else if (key == "members") {
      good = read(value, info.members) && info.members >= 1 && info.members <= kMaxAgents;
    } else if (key == "run") {
      good = read(value, info.run);
    } else if (key == "renewals") {
      good = read(value, info.renewals);
    }
    if (!good) return std::nullopt;
  }
  return found == 63U ? std::optional(info) : std::nullopt;
}

}  // namespace skein::bus
