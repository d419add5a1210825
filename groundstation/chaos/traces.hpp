// What a run leaves behind, as the system tells it: processes by their command line, files in /dev/shm and in a folder.
//
// Complexity: linear in the processes of the machine, or in the files.
#pragma once

#include <sys/types.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "planner/core/mission/mission.hpp"

namespace skein::chaos {

/// Processes, this one left out, that have `argument` among the arguments they were started with.
[[nodiscard]] std::vector<pid_t> processes_with(const std::string& argument);

/// The process of one agent of a swarm.
[[nodiscard]] std::optional<pid_t> process_of(const std::string& swarm, AgentId agent);

/// Files of DDS in /dev/shm, by name.
[[nodiscard]] std::set<std::string> shared_files();

/// What is in a folder, by name.
[[nodiscard]] std::set<std::string> files_in(const std::string& folder);

}  // namespace skein::chaos
