#include "groundstation/chaos/traces.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace skein::chaos {
namespace {

namespace fs = std::filesystem;

/// Empty if the process has ended.
std::vector<std::string> arguments_of(const fs::path& process) {
  std::ifstream file(process / "cmdline", std::ios::binary);
  std::vector<std::string> arguments;
  for (std::string word; std::getline(file, word, '\0');) arguments.push_back(word);
  return arguments;
}

template <typename Wanted>
std::vector<pid_t> processes(const Wanted& wanted) {
  std::vector<pid_t> pids;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const auto pid = static_cast<pid_t>(std::stol(name));
    if (pid != getpid() && wanted(arguments_of(entry.path()))) pids.push_back(pid);
  }
  return pids;
}

bool holds(const std::vector<std::string>& arguments, const std::string& argument) {
  return std::ranges::find(arguments, argument) != arguments.end();
}

}  // namespace

std::vector<pid_t> processes_with(const std::string& argument) {
  return processes([&](const std::vector<std::string>& arguments) { return holds(arguments, argument); });
}

std::optional<pid_t> process_of(const std::string& swarm, AgentId agent) {
  const std::string id = std::to_string(agent);
  const auto pids = processes([&](const std::vector<std::string>& arguments) {
    const auto flag = std::ranges::find(arguments, "--id");
    return holds(arguments, swarm) && flag != arguments.end() && flag + 1 != arguments.end() && flag[1] == id;
  });
  return pids.empty() ? std::nullopt : std::optional(pids.front());
}

std::set<std::string> shared_files() {
  std::set<std::string> names;
  for (const std::string& name : files_in("/dev/shm")) {
    const bool of_dds =
        name.find("fastrtps") != std::string::npos || name.find("fast_datasharing") != std::string::npos;
    if (of_dds) names.insert(name);
  }
  return names;
}

std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) names.insert(entry.path().filename());
  return names;
}

}  // namespace skein::chaos
