// What only content may change: a bus that loses, doubles, delays and reorders samples gives the same run.
#include "tests/groundstation/inprocess/tampering.hpp"

namespace skein {
namespace {

using test::Losses;
using test::paper_scenario;
using test::run_with;

void expect_same_run(std::uint64_t seed, const std::string& name, const Losses& losses) {
  const Scenario scenario = paper_scenario(seed, name);
  const InProcessResult calm = run_with(scenario, {});
  std::uint64_t lost = 0;
  const InProcessResult rough = run_with(scenario, test::lossy(seed, losses, lost));
  ASSERT_EQ(rough.report.at("state_hash"), calm.report.at("state_hash")) << name << " " << seed;
  ASSERT_EQ(rough.exit_code, calm.exit_code) << name << " " << seed;
  ASSERT_TRUE(rough.report.at("roster_changes").empty()) << name << " " << seed;
  ASSERT_EQ(rough.report.at("vehicles"), calm.report.at("vehicles")) << name << " " << seed;
  ASSERT_EQ(rough.report.at("refused_samples"), 0) << name << " " << seed;
  if (losses.drop > 0.0) {
    ASSERT_GT(lost, 100U) << name << " " << seed;
  }
}

TEST(LossyBus, DroppedSamplesChangeNothing) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) expect_same_run(seed, "rendezvous-2d", {.drop = 0.2});
}

TEST(LossyBus, DuplicatesChangeNothing) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) expect_same_run(seed, "rendezvous-2d", {.duplicate = 0.5});
}

TEST(LossyBus, DelaysAndReorderingChangeNothing) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) expect_same_run(seed, "rendezvous-2d", {.delay = 0.5});
}

TEST(LossyBus, AllOfThemTogetherChangeNothing) {
  const Losses losses{.drop = 0.15, .duplicate = 0.2, .delay = 0.2};
  for (std::uint64_t seed = 100; seed < 115; ++seed) {
    expect_same_run(seed, "rendezvous-2d", losses);
    expect_same_run(seed, "rendezvous-2d-b", losses);
  }
}

// The mission is latched, but a loss of what was latched must heal as well.
TEST(LossyBus, AMissionThatGetsLostIsPublishedAgain) {
  const Scenario scenario = paper_scenario(3);
  const InProcessResult calm = run_with(scenario, {});
  for (const std::size_t losses : {1U, 3U}) {
    std::size_t lost = 0;
    const InProcessResult rough = run_with(scenario, [&](bus::Transit transit) {
      const bool first = std::holds_alternative<wire::Mission>(transit.sample) && transit.to == 2 && lost < losses;
      if (first) ++lost;
      return first ? std::vector<bus::Transit>{} : std::vector{std::move(transit)};
    });
    EXPECT_EQ(lost, losses);
    EXPECT_EQ(rough.exit_code, 0) << rough.report.at("reason");
    EXPECT_EQ(rough.report.at("state_hash"), calm.report.at("state_hash"));
  }
}

TEST(LossyBus, ALostIntroductionIsRepeated) {
  const Scenario scenario = paper_scenario(3);
  const InProcessResult calm = run_with(scenario, {});
  std::size_t lost = 0;
  const InProcessResult rough = run_with(scenario, [&](bus::Transit transit) {
    const bool first = std::holds_alternative<wire::Beacon>(transit.sample) && transit.from == 3 && lost < 5;
    if (first) ++lost;
    return first ? std::vector<bus::Transit>{} : std::vector{std::move(transit)};
  });
  EXPECT_EQ(lost, 5U);
  EXPECT_EQ(rough.report.at("state_hash"), calm.report.at("state_hash"));
}

}  // namespace
}  // namespace skein
