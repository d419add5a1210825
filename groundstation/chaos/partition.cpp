#include "groundstation/chaos/partition.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "groundstation/launch/child.hpp"

namespace skein::chaos {
namespace {

namespace fs = std::filesystem;

/// Inodes of the sockets that a process has open.
std::set<std::string> sockets_of(pid_t process) {
  std::set<std::string> inodes;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fmt::format("/proc/{}/fd", process), error)) {
    std::error_code closed;
    const std::string target = fs::read_symlink(entry.path(), closed).string();
    if (!closed && target.starts_with("socket:[")) inodes.insert(target.substr(8, target.size() - 9));
  }
  return inodes;
}

/// Adds the ports of the sockets in one table: sl local:port remote:port state queues timer retransmits uid timeout
/// inode.
void add_ports(const std::string& table, const std::set<std::string>& inodes, std::set<std::uint16_t>& ports) {
  std::ifstream file(table);
  std::string line;
  std::getline(file, line);  // the heading
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::vector<std::string> fields;
    for (std::string word; words >> word;) fields.push_back(word);
    if (fields.size() < 10 || !inodes.contains(fields[9])) continue;
    const std::size_t colon = fields[1].rfind(':');
    ports.insert(static_cast<std::uint16_t>(std::stoul(fields[1].substr(colon + 1), nullptr, 16)));
  }
}

}  // namespace

std::set<std::uint16_t> udp_ports_of(pid_t process) {
  const std::set<std::string> inodes = sockets_of(process);
  std::set<std::uint16_t> ports;
  for (const char* table : {"udp", "udp6"}) add_ports(fmt::format("/proc/{}/net/{}", process, table), inodes, ports);
  return ports;
}

std::set<std::uint16_t> ports_of_one_side(const std::vector<pid_t>& cut, const std::vector<pid_t>& others) {
  std::set<std::uint16_t> ports;
  for (const pid_t process : cut) ports.merge(udp_ports_of(process));
  for (const pid_t process : others) {
    for (const std::uint16_t port : udp_ports_of(process)) ports.erase(port);
  }
  return ports;
}

std::string partition_rules(const std::set<std::uint16_t>& ports) {
  std::string rules = "*filter\n:INPUT ACCEPT [0:0]\n:SKEIN_FROM - [0:0]\n:SKEIN_TO - [0:0]\n-F INPUT\n";
  for (const std::uint16_t port : ports) {
    rules +=
        fmt::format("-A INPUT -p udp --sport {} -j SKEIN_FROM\n-A INPUT -p udp --dport {} -j SKEIN_TO\n", port, port);
    rules +=
        fmt::format("-A SKEIN_FROM -p udp --dport {} -j RETURN\n-A SKEIN_TO -p udp --sport {} -j RETURN\n", port, port);
  }
  return rules + "-A SKEIN_FROM -j DROP\n-A SKEIN_TO -j DROP\nCOMMIT\n";
}

bool put_rules(pid_t inside, const std::string& rules, const std::string& scratch) {
  std::ofstream(scratch) << rules;
  Child tool("/bin/sh", {"-c", fmt::format("exec nsenter -t {} -n iptables-restore --noflush < '{}'", inside, scratch)},
             scratch + ".log", -1);
  tool.wait();
  return *tool.status() == 0;
}

}  // namespace skein::chaos
