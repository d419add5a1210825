// A run of a campaign goes into its journal and comes back as it was; what is no run is refused.
#include "groundstation/chaos/outcome.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace skein::chaos {
namespace {

using Json = nlohmann::ordered_json;

/// With a value of its own in each field.
RunOutcome full() {
  RunOutcome outcome;
  outcome.seed = std::numeric_limits<std::uint64_t>::max();
  outcome.kind = Kind::Partition;
  outcome.fault = "partition:2,5 0.31 s";
  outcome.befallen = {2, 5};
  outcome.injected = true;
  outcome.result = Result::Degraded;
  outcome.exit_code = 4;
  outcome.reason = "agents lost";
  outcome.state_hash = "00ff";
  outcome.orphans = {"skein-agent 7"};
  outcome.leftovers = {"/dev/shm/x"};
  outcome.unexplained = {"agent 3"};
  outcome.replay_differs = true;
  outcome.maps_due = 3;
  outcome.maps_differ = 1;
  outcome.unaccepted = {"plan 2"};
  outcome.recovery_steps = 9;
  outcome.recovery_s = 0.1 + 0.2;
  outcome.wall_s = 1.0 / 3.0;
  return outcome;
}

TEST(Outcome, ComesBackFromItsTextAsItWas) {
  for (const RunOutcome& outcome : {full(), RunOutcome{}}) {
    const Json written = json_of(outcome);
    const RunOutcome read = outcome_of(Json::parse(written.dump()));
    EXPECT_EQ(json_of(read).dump(), written.dump());
    EXPECT_EQ(read.kind, outcome.kind);
    EXPECT_EQ(read.result, outcome.result);
    EXPECT_EQ(read.recovery_s, outcome.recovery_s);
    EXPECT_EQ(read.befallen, outcome.befallen);
    EXPECT_EQ(is_sound(read), is_sound(outcome));
  }
}

TEST(Outcome, IsRefusedWithoutAnyOfItsFieldsOrWithAnotherName) {
  const Json whole = json_of(full());
  for (const auto& [key, value] : whole.items()) {
    if (key == "sound") continue;  // follows from the others
    Json less = whole;
    less.erase(key);
    EXPECT_THROW((void)outcome_of(less), std::runtime_error) << key;
  }
  for (const char* key : {"kind", "result"}) {
    Json other = whole;
    other[key] = "melt";
    EXPECT_THROW((void)outcome_of(other), std::runtime_error) << key;
  }
}

}  // namespace
}  // namespace skein::chaos
