// Numbers on the command line are finite and within their bounds, or refused in a short line.
#include "idl/process/number_within.hpp"

#include <gtest/gtest.h>

namespace skein {
namespace {

TEST(NumberWithin, TakesItsBoundsAndWhatIsBetween) {
  for (const char* text : {"0.5", "1", "2e0", "2.0"}) EXPECT_EQ(number_within(0.5, 2.0)(text), "") << text;
  for (const char* text : {"1e-300", "3"}) EXPECT_EQ(number_above_0(3.0)(text), "") << text;
}

TEST(NumberWithin, RefusesWhatIsBeyondNotFiniteOrNoNumber) {
  for (const char* text : {"nan", "NAN", "-nan", "inf", "-inf", "1e999", "0.4999", "2.0001", "", "x", "1x"}) {
    EXPECT_NE(number_within(0.5, 2.0)(text), "") << text;
  }
  for (const char* text : {"nan", "inf", "0", "-0", "-1", "3.1"}) EXPECT_NE(number_above_0(3.0)(text), "") << text;
}

TEST(NumberWithin, SaysWhatIsAllowedInAShortLine) {
  EXPECT_EQ(number_within(0.1, 3600.0)("nan"), "'nan' is not allowed: 0.1 to 3600");
  EXPECT_EQ(number_above_0(1e4)("-1"), "'-1' is not allowed: over 0, to 10000");
  EXPECT_LT(number_within(0.0, 1.0)(std::string(100000, '9')).size(), 100U);
}

}  // namespace
}  // namespace skein
