#include "tests/groundstation/e2e/skein.hpp"

#include <cstdlib>

namespace skein::e2e {

std::string scenario_path(const std::string& name) {
  return std::string(SKEIN_SOURCE_DIR) + "/deploy/scenarios/" + name + ".yaml";
}

std::string binary(const std::string& name) {
  return std::string(SKEIN_BIN_DIR) + "/" + name;
}

unsigned seeds_or(const char* variable, unsigned fallback) {
  const char* text = std::getenv(variable);
  return text == nullptr ? fallback : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

SkeinRun skein_run(const std::string& scenario, unsigned domain, const std::string& out,
                   const std::vector<std::string>& more, const std::vector<std::string>& environment) {
  std::vector<std::string> arguments{binary("skein"), "run", scenario,   "--json",
                                     "--out",         out,   "--domain", std::to_string(domain)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  SkeinRun run;
  run.ended = run_program(arguments, 120.0, environment);
  run.report = nlohmann::json::parse(run.ended.out, nullptr, false);
  if (run.report.is_discarded()) run.report = nullptr;
  return run;
}

}  // namespace skein::e2e
