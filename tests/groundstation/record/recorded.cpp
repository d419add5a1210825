#include "tests/groundstation/record/recorded.hpp"

#include <stdexcept>

#include "groundstation/record/tap.hpp"

namespace skein::tests {

Scenario small_scenario(const std::string& name, std::uint64_t seed) {
  ScenarioResult result = load_scenario(std::string(SKEIN_SOURCE_DIR) + "/tests/data/" + name + ".yaml", {}, seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::invalid_argument(fault->line());
  return std::get<Scenario>(std::move(result));
}

RecordedBytes record(const Scenario& scenario, InProcessOptions options) {
  RecordedBytes recorded;
  Recording recording(
      [&](mcap::ByteView bytes) { recorded.file.insert(recorded.file.end(), bytes.begin(), bytes.end()); },
      {"in-process", "", &scenario, options.fail_fast});
  options.tap = tap_into([&](const TakenSample& sample) { recording.add(sample); });
  recorded.result = run_in_process(scenario, options);
  recording.finish({}, recorded.result.report);
  return recorded;
}

}  // namespace skein::tests
