#include "idl/convert/wire_fault.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace skein {
namespace {

TEST(Checked, HoldsAValueOrAFault) {
  const Checked<int> value(7);
  EXPECT_TRUE(value.ok());
  EXPECT_EQ(value.value(), 7);
  EXPECT_THROW((void)value.fault(), std::logic_error);
  const Checked<int> fault(WireFault{WireFaultReason::BadEnum, "tick.phase"});
  EXPECT_FALSE(fault);
  EXPECT_EQ(fault.fault().where, "tick.phase");
  EXPECT_THROW((void)fault.value(), std::logic_error);
}

TEST(FaultCounts, CountsEachReasonByItself) {
  FaultCounts counts;
  counts.add(WireFaultReason::NonFinite);
  counts.add(WireFaultReason::NonFinite);
  counts.add(WireFaultReason::BadOptions);
  EXPECT_EQ(counts.of(WireFaultReason::NonFinite), 2u);
  EXPECT_EQ(counts.of(WireFaultReason::BadOptions), 1u);
  EXPECT_EQ(counts.of(WireFaultReason::WrongRun), 0u);
  EXPECT_EQ(counts.total(), 3u);
}

TEST(WireFaultReason, EveryReasonHasItsOwnName) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < kWireFaultReasons; ++i) names.emplace(name_of(static_cast<WireFaultReason>(i)));
  EXPECT_EQ(names.size(), kWireFaultReasons);
  EXPECT_EQ(names.count("unknown"), 0u);
  EXPECT_EQ(name_of(static_cast<WireFaultReason>(200)), "unknown");
}

}  // namespace
}  // namespace skein
