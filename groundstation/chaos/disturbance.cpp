#include "groundstation/chaos/disturbance.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "groundstation/launch/child.hpp"

namespace skein::chaos {
namespace {

constexpr double kDrop = 0.005;
constexpr double kDelay_mbps = 20.0;

std::optional<double> number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole ? std::optional(value) : std::nullopt;
}

bool legal(Kind kind, double amount) {
  if (kind == Kind::Drop) return amount >= 0.001 && amount <= 0.5;
  return amount >= 1.0 && amount <= 1000.0;
}

/// One line without its comment: the kind, or what is wrong with it; nothing of an empty line.
std::optional<std::variant<Disturbance, std::string>> read_line(const std::string& line) {
  std::istringstream words(line);
  std::string name;
  std::string amount;
  std::string more;
  if (!(words >> name)) return std::nullopt;
  words >> amount >> more;
  const auto place = std::ranges::find(kNames, name);
  if (place == kNames.end()) return fmt::format("unknown fault '{}'; allowed: {}", name, fmt::join(kNames, ", "));
  Disturbance kind{static_cast<Kind>(place - kNames.begin()), 0.0};
  for (const Disturbance& known : all_kinds()) {
    if (known.kind == kind.kind) kind.amount = known.amount;
  }
  if (amount.empty()) return kind;
  const std::optional<double> value = number(amount);
  if (!has_amount(kind.kind) || !more.empty()) return fmt::format("'{}' takes nothing after it", name);
  if (!value || !legal(kind.kind, *value)) {
    return fmt::format("'{}' is no amount for {}; allowed: {}", amount, name,
                       kind.kind == Kind::Drop ? "0.001 to 0.5" : "1 to 1000 Mbit/s");
  }
  kind.amount = *value;
  return kind;
}

}  // namespace

std::vector<Disturbance> all_kinds() {
  std::vector<Disturbance> kinds;
  for (std::size_t i = 0; i < kNames.size(); ++i) kinds.push_back({static_cast<Kind>(i), 0.0});
  kinds[static_cast<std::size_t>(Kind::Drop)].amount = kDrop;
  kinds[static_cast<std::size_t>(Kind::Delay)].amount = kDelay_mbps;
  return kinds;
}

std::variant<std::vector<Disturbance>, std::string> read_kinds(const std::string& text, const std::string& path) {
  std::vector<Disturbance> kinds;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const auto read = read_line(line.substr(0, line.find('#')));
    if (!read) continue;
    if (const auto* fault = std::get_if<std::string>(&*read)) return fmt::format("{}:{}:1: {}", path, number, *fault);
    kinds.push_back(std::get<Disturbance>(*read));
  }
  if (kinds.empty()) return fmt::format("{}:1:1: no fault is named; allowed: {}", path, fmt::join(kNames, ", "));
  return kinds;
}

std::string network_script(const Disturbance& kind) {
  const std::string ready = "ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo";
  if (kind.kind == Kind::Drop) {
    return fmt::format("{} && iptables -A INPUT -i lo -p udp -m statistic --mode random --probability {:.4f} -j DROP",
                       ready, kind.amount);
  }
  if (kind.kind == Kind::Partition) return ready + " && printf '*filter\\nCOMMIT\\n' | iptables-restore --noflush";
  return fmt::format("{} && tc qdisc add dev lo root tbf rate {:.3f}mbit burst 32kb latency 200ms", ready, kind.amount);
}

std::optional<std::string> obstacle_to(Kind kind) {
  if (!needs_network(kind)) return std::nullopt;
  if (geteuid() != 0) return "needs root, for a network namespace of its own";
  const Disturbance tried = all_kinds()[static_cast<std::size_t>(kind)];
  try {
    Child child("/usr/bin/unshare", {"--net", "/bin/sh", "-c", network_script(tried)}, "/dev/null", -1);
    child.wait();
    if (*child.status() == 0) return std::nullopt;
  } catch (const std::exception& error) {
    return error.what();
  }
  return fmt::format("a network namespace with {} is not to be had here", kind == Kind::Drop    ? "iptables (statistic)"
                                                                          : kind == Kind::Delay ? "tc (tbf)"
                                                                                                : "iptables-restore");
}

}  // namespace skein::chaos
