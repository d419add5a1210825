// Any text as a scenario file: a scenario, or one line that names a place in it and says what is wrong.
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>

#include "simworld/scenario/scenario.hpp"
#include "tests/fuzz/require.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const skein::ScenarioResult result = skein::parse_scenario(text, "fuzz.yaml", {}, std::nullopt);
  if (const auto* fault = std::get_if<skein::ScenarioFault>(&result)) {
    skein::require(fault->where.starts_with("fuzz.yaml:"), "a fault names its place");
    skein::require(!fault->message.empty(), "a fault says what is wrong");
    skein::require(fault->line().find('\n') == std::string::npos, "a fault is one line");
  } else {
    skein::require(!std::get<skein::Scenario>(result).mission.vehicles.empty(), "a scenario has vehicles");
  }
  return 0;
}
