#include "planner/core/radio/radio_budget.hpp"

#include <gtest/gtest.h>

#include <map>

namespace skein {
namespace {

/// papers/004, appendix.
RadioOptions paper() {
  RadioOptions options;
  options.bit_rate_bps = 250e3;
  options.send_period_s = 2.0;
  return options;
}

TEST(RadioBudget, ByHandOfNineAgentsAsInThePaper) {
  // 250 kbit/s x 2 s / 9 = 55555 bits a frame; two decisions, of which one has the map
  RadioBudget budget(paper(), {.decision_s = 1.0, .rank = 0, .count = 9, .control_bytes = 132});
  EXPECT_EQ(budget.slot_bits(), 55555.0);
  EXPECT_EQ(budget.decisions_per_frame(), 2u);
  const Allowance first = budget.at(1);
  EXPECT_TRUE(first.map_slot);
  EXPECT_EQ(first.payload_bytes, 6764u);  // (55555 - 192 - (192 + 8 x 132)) / 8
  budget.sent(1, first.payload_bytes);
  const Allowance second = budget.at(2);
  EXPECT_FALSE(second.map_slot);
  EXPECT_EQ(second.payload_bytes, 132u);
  budget.sent(2, 132);
  EXPECT_LE(budget.peak_bits(), 55555.0);
  EXPECT_EQ(budget.at(3).payload_bytes, 6764u);
}

TEST(RadioBudget, TheLaterHalfOfTheRanksHasTheSecondDecision) {
  for (std::uint32_t rank = 0; rank < 9; ++rank) {
    const RadioBudget budget(paper(), {.decision_s = 1.0, .rank = rank, .count = 9, .control_bytes = 132});
    EXPECT_EQ(budget.at(1).map_slot, rank < 5) << rank;
    EXPECT_EQ(budget.at(2).map_slot, rank >= 5) << rank;
  }
}

TEST(RadioBudget, NeverExceedsItsShareInAnyFrame) {
  for (const double decision_s : {0.1, 0.3, 0.5, 1.0, 2.0, 3.0}) {
    for (const double send_period_s : {0.2, 1.0, 2.0, 5.0}) {
      for (const std::uint32_t count : {1U, 3U, 9U, 64U}) {
        RadioOptions options = paper();
        options.send_period_s = send_period_s;
        RadioBudget budget(options, {decision_s, count / 2, count, 132});
        std::map<long, double> bits;
        for (std::uint32_t decision = 1; decision <= 60; ++decision) {
          const Allowance allowed = budget.at(decision);
          if (allowed.payload_bytes == 0) {
            budget.silent();
            continue;
          }
          budget.sent(decision, allowed.payload_bytes);
          const double time_s = (decision - 1) * decision_s;
          bits[static_cast<long>(time_s / send_period_s + 1e-9)] +=
              192.0 + 8.0 * static_cast<double>(allowed.payload_bytes);
        }
        for (const auto& [frame, sum] : bits) EXPECT_LE(sum, 250e3 * send_period_s / count) << frame;
        EXPECT_LE(budget.peak_bits(), 250e3 * send_period_s / count);
      }
    }
  }
}

TEST(RadioBudget, OneMapSlotAFrameAndRoomForAllControlParts) {
  RadioOptions options = paper();
  for (std::uint32_t rank = 0; rank < 9; ++rank) {
    RadioBudget budget(options, {0.2, rank, 9, 132});
    for (std::uint32_t frame = 0; frame < 5; ++frame) {
      int slots = 0;
      for (std::uint32_t decision = frame * 10 + 1; decision <= frame * 10 + 10; ++decision) {
        const Allowance allowed = budget.at(decision);
        EXPECT_GE(allowed.payload_bytes, 132u);
        slots += allowed.map_slot ? 1 : 0;
        budget.sent(decision, allowed.payload_bytes);
      }
      EXPECT_EQ(slots, 1);
    }
  }
}

TEST(RadioBudget, IsSilentWhereNotEvenAControlPartFits) {
  RadioOptions options = paper();
  options.bit_rate_bps = 2400.0;
  RadioBudget budget(options, {1.0, 0, 9, 132});
  EXPECT_EQ(budget.at(1).payload_bytes, 0u);
  EXPECT_FALSE(budget.at(1).map_slot);
  budget.silent();
  EXPECT_EQ(budget.silences(), 1u);
  EXPECT_EQ(budget.peak_bits(), 0.0);
  EXPECT_THROW(budget.sent(1, 1), std::invalid_argument);
}

TEST(RadioBudget, TheIdealRadioHasRoomForAnySample) {
  const RadioBudget budget(RadioOptions{}, {1.0, 63, 64, 132});
  EXPECT_TRUE(budget.at(1).map_slot);
  EXPECT_GT(budget.at(1).payload_bytes, 60000u);
}

TEST(RadioBudget, RefusesAShareThatIsNone) {
  EXPECT_THROW(RadioBudget(paper(), {0.0, 0, 1, 132}), std::invalid_argument);
  EXPECT_THROW(RadioBudget(paper(), {1.0, 3, 3, 132}), std::invalid_argument);
}

}  // namespace
}  // namespace skein
