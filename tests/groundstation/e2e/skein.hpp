// The ground station as the end-to-end tests use it: each run in a DDS domain and a swarm of its own.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/groundstation/e2e/program.hpp"

namespace skein::e2e {

/// Folder of the repository's scenarios, with the file's ending: "rendezvous-2d" -> its path.
[[nodiscard]] std::string scenario_path(const std::string& name);
[[nodiscard]] std::string binary(const std::string& name);

/// A number from the environment variable, or `fallback`: campaigns by hand run more seeds than CI.
[[nodiscard]] unsigned seeds_or(const char* variable, unsigned fallback);

/// `skein run SCENARIO --json --out OUT ...` in the domain. @return the ended program and its report (null if none)
struct SkeinRun {
  Ended ended;
  nlohmann::json report;
};
[[nodiscard]] SkeinRun skein_run(const std::string& scenario, unsigned domain, const std::string& out,
                                 const std::vector<std::string>& more,
                                 const std::vector<std::string>& environment = {});

}  // namespace skein::e2e
