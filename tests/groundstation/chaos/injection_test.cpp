// Faults are drawn within the run that they befall, and the same stream draws the same.
#include "groundstation/chaos/injection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace skein::chaos {
namespace {

const Undisturbed kRun{.rounds = 40, .steps = 300, .step_s = 0.5, .agents = {2, 3, 7}, .state_hash = ""};
constexpr double kDeadline_s = 2.0;

Injection drawn(const Disturbance& kind, std::uint64_t index, const Undisturbed& run = kRun) {
  RandomStream random(5, 0, Purpose::Chaos, index);
  return draw(kind, run, kDeadline_s, random);
}

TEST(Injection, FallsWithinTheRun) {
  for (const Disturbance& kind : all_kinds()) {
    for (std::uint64_t index = 0; index < 500; ++index) {
      const Injection injection = drawn(kind, index);
      for (const Fault& fault : injection.script) {
        ASSERT_GE(fault.at, 1U) << text_of(injection);
        ASSERT_LE(fault.at, fault.phase == Phase::Planning ? 40U : 300U) << text_of(injection);
        ASSERT_TRUE(parse_fault(skein::text_of(fault)).fault.has_value());
      }
      const double longest_s = kind.kind == Kind::Slow        ? 1.5
                               : kind.kind == Kind::Partition ? 2.5 * kDeadline_s
                                                              : 0.5 * kDeadline_s;
      ASSERT_LE(injection.for_s, longest_s);
      ASSERT_EQ(injection.cut.empty(), kind.kind != Kind::Partition);
      ASSERT_LE(injection.after_s, kPacedFlight_s);
      const bool nobody = kind.kind == Kind::World || needs_network(kind.kind);
      ASSERT_EQ(injection.agent == kWorldId, nobody);
    }
  }
}

TEST(Injection, BefallsEverybodyInBothPhases) {
  std::set<AgentId> agents;
  std::set<Phase> phases;
  for (std::uint64_t index = 0; index < 100; ++index) {
    const Injection injection = drawn({Kind::Kill}, index);
    agents.insert(injection.agent);
    phases.insert(injection.script.at(0).phase);
    EXPECT_EQ(injection.script.at(0).agent, injection.agent);
  }
  EXPECT_EQ(agents, (std::set<AgentId>{2, 3, 7}));
  EXPECT_EQ(phases.size(), 2U);
}

TEST(Injection, AStopIsContinuedLaterAlsoInAShortRun) {
  Undisturbed brief = kRun;
  brief.rounds = 1;
  for (const std::uint32_t steps : {1U, 8U, 30U, 300U}) {
    brief.steps = steps;
    for (std::uint64_t index = 0; index < 200; ++index) {
      const auto script = drawn({Kind::Stop}, index, brief).script;
      ASSERT_EQ(script.size(), 2U);
      EXPECT_EQ(script[1].kind, FaultKind::Cont);
      EXPECT_EQ(script[0].phase, Phase::Flying);
      EXPECT_GE(script[1].at, script[0].at);
      EXPECT_LE(script[1].at, steps);
    }
  }
}

TEST(Injection, TheSameStreamDrawsTheSameAndAnotherSomethingElse) {
  EXPECT_EQ(text_of(drawn({Kind::Stop}, 3)), text_of(drawn({Kind::Stop}, 3)));
  EXPECT_NE(text_of(drawn({Kind::Stop}, 3)), text_of(drawn({Kind::Stop}, 4)));
}

TEST(Injection, APartitionCutsOneOrHalfOffShorterOrLongerThanTheDeadline) {
  Undisturbed run = kRun;
  run.agents = {1, 2, 3, 4, 5, 6, 7};
  std::set<std::size_t> sizes;
  std::set<AgentId> agents;
  int longer = 0;
  for (std::uint64_t index = 0; index < 200; ++index) {
    const Injection injection = drawn({Kind::Partition}, index, run);
    EXPECT_TRUE(std::ranges::is_sorted(injection.cut));
    EXPECT_EQ(std::ranges::adjacent_find(injection.cut), injection.cut.end());
    sizes.insert(injection.cut.size());
    agents.insert(injection.cut.begin(), injection.cut.end());
    EXPECT_TRUE(injection.for_s <= 0.5 * kDeadline_s || injection.for_s >= 1.25 * kDeadline_s) << injection.for_s;
    const bool outlasts = injection.for_s > kDeadline_s;
    longer += outlasts ? 1 : 0;
    const double flight_s = run.steps * run.step_s / injection.realtime;
    const double rest_s = flight_s - injection.after_s;  // of wall time; while somebody is waited for it does not pass
    EXPECT_GE(rest_s, (outlasts ? injection.for_s - kDeadline_s : 0.0) + 0.2 * kPacedFlight_s - 1e-9);
  }
  EXPECT_EQ(sizes, (std::set<std::size_t>{1, 3}));
  EXPECT_EQ(agents.size(), 7U);
  EXPECT_GT(longer, 60);
  EXPECT_LT(longer, 140);
}

TEST(Injection, SaysInWordsWhatIsDone) {
  EXPECT_EQ(text_of(Injection{.kind = {Kind::Drop, 0.02}, .cut = {}, .script = {}}), "drop 0.02");
  EXPECT_EQ(text_of(Injection{.kind = {Kind::Partition}, .cut = {2, 5}, .script = {}, .for_s = 3.5}),
            "partition:2,5 3.50 s");
  EXPECT_EQ(text_of(Injection{.kind = {Kind::Pause}, .agent = 3, .cut = {}, .script = {}, .for_s = 0.25}),
            "pause:3 0.25 s");
  EXPECT_EQ(text_of(Injection{
                .kind = {Kind::World},
                .cut = {},
                .script = {{FaultKind::Kill, kWorldId, Phase::Flying, 9}, {FaultKind::Kill, 2, Phase::Flying, 10}}}),
            "kill:world@fly:9 kill:2@fly:10");
}

}  // namespace
}  // namespace skein::chaos
