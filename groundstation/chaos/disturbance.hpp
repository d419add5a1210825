// The kinds of faults that a campaign injects, and which of them this machine allows.
//
// A kind is done to whole processes, on purpose at a tick (--fault), by signals at a moment of the wall clock, or below
// DDS by the kernel, in a network namespace that the run has for itself:
//   kill      an agent's process dies
//   stop      it is stopped until the deadline has dropped it, and continued some steps later
//   restart   it dies, and another one takes its place
//   world     the world dies and goes on from its checkpoint
//   pause     an agent is stopped for less than the deadline
//   slow      an agent is stopped for four fifths of the time, for a while
//   drop      every received datagram is lost with probability `amount` (iptables)
//   delay     the network carries `amount` Mbit/s, with what waits for it in a queue (tc tbf)
//   partition one agent, or half of them, is cut off for a while, and heals (iptables)
// Source: own. Departs from source: none.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace skein::chaos {

enum class Kind : std::uint8_t { Kill, Stop, Restart, World, Pause, Slow, Drop, Delay, Partition };

inline constexpr std::array<std::string_view, 9> kNames{"kill", "stop", "restart", "world",    "pause",
                                                        "slow", "drop", "delay",   "partition"};

[[nodiscard]] constexpr std::string_view name_of(Kind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

/// A kind as a campaign uses it.
struct Disturbance {
  Kind kind = Kind::Kill;
  double amount = 0.0;  ///< drop: 0.001 to 0.5; delay: 1 to 1000 Mbit/s; else 0

  bool operator==(const Disturbance&) const = default;
};

/// All kinds, with the amounts that a campaign uses by itself: 0.005, and 20 Mbit/s.
[[nodiscard]] std::vector<Disturbance> all_kinds();

/// Reads a file of faults: a kind a line, `drop AMOUNT` and `delay AMOUNT` with theirs; a # begins a comment. A kind
/// that is named twice is drawn twice as often. @return the kinds, or one line that names the line and what is wrong
[[nodiscard]] std::variant<std::vector<Disturbance>, std::string> read_kinds(const std::string& text,
                                                                             const std::string& path);

/// Whether the kind acts below DDS.
[[nodiscard]] constexpr bool needs_network(Kind kind) {
  return kind == Kind::Drop || kind == Kind::Delay || kind == Kind::Partition;
}

/// Whether it has an amount.
[[nodiscard]] constexpr bool has_amount(Kind kind) {
  return kind == Kind::Drop || kind == Kind::Delay;
}

/// Why this machine cannot do it, in one line; nothing if it can. Tries a network namespace if need be.
[[nodiscard]] std::optional<std::string> obstacle_to(Kind kind);

/// What a shell does in a network namespace of its own before the run: loopback with multicast, and the fault.
[[nodiscard]] std::string network_script(const Disturbance& kind);

}  // namespace skein::chaos
