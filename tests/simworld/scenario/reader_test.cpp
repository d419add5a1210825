// The strict reads below the scenario: which texts are numbers, which keys are near.
#include "simworld/scenario/reader.hpp"

#include <gtest/gtest.h>

#include <array>

namespace skein::scenario {
namespace {

constexpr std::array<std::string_view, 2> kKeys{"x_m", "count"};

/// 'read', or the message, of x_m in [-10, 1000].
std::string number_fault(const std::string& value) {
  const YamlNode root = parse_yaml("x_m: " + value);
  try {
    (void)MapReader(&root, "", kKeys, {}).number("x_m", {-10, 1000, "m"});
  } catch (const ReadFault& fault) {
    return fault.what();
  }
  return "read";
}

TEST(Reader, TakesDecimalNumbers) {
  for (const char* text : {"0", "-0", "0.5", "-10", "1e2", "1000", "1E+2", "5."}) {
    EXPECT_EQ(number_fault(text), "read") << text;
  }
}

TEST(Reader, RefusesWhatYamlOrCTakeForNumbers) {
  for (const char* text : {"010", "-010", "0x1", "0b1", "1_0", "1:30", "+1", ".inf", "nan", "inf", "-.inf", "1e999",
                           "1,5", "'1'", "\"1\"", "~", "true", "1 m"}) {
    EXPECT_NE(number_fault(text), "read") << text;
  }
}

TEST(Reader, ReadsTheNearestDouble) {
  const YamlNode root = parse_yaml("x_m: 0.1");
  EXPECT_EQ(MapReader(&root, "", kKeys, {}).number("x_m", {0, 1}), 0.1);
}

TEST(Reader, LimitsAreClosed) {
  EXPECT_EQ(number_fault("1000"), "read");
  EXPECT_EQ(number_fault("1000.0000000000001"), "x_m is 1000.0000000000001; allowed: a number from -10 to 1000 m");
}

TEST(Reader, WholeNumbersHaveNoFraction) {
  const YamlNode root = parse_yaml("count: 3\nx_m: 3.0");
  const MapReader reader(&root, "", kKeys, {});
  EXPECT_EQ(reader.whole("count", 1, 5), 3U);
  EXPECT_THROW((void)reader.whole("x_m", 1, 5), ReadFault);
  EXPECT_THROW((void)reader.whole("count", 4, 5), ReadFault);
}

TEST(Reader, AnAbsentMapHasOnlyDefaults) {
  const MapReader reader(nullptr, "here", kKeys, Place{4, 2, ""});
  EXPECT_EQ(reader.number("x_m", {0, 1}, 0.25), 0.25);
  try {
    (void)reader.number("x_m", {0, 1});
    FAIL() << "a required key of an absent map was read";
  } catch (const ReadFault& fault) {
    EXPECT_EQ(fault.place(), (Place{4, 2, ""}));
    EXPECT_STREQ(fault.what(), "here.x_m is missing; allowed: a number from 0 to 1");
  }
}

TEST(NearestKey, IsFewEditsAway) {
  constexpr std::array<std::string_view, 3> keys{"speed_mps", "starts", "type"};
  EXPECT_EQ(nearest_key("sped_mps", keys), "speed_mps");
  EXPECT_EQ(nearest_key("startz", keys), "starts");
  EXPECT_EQ(nearest_key("tpye", keys), "");  // two edits of four letters
  EXPECT_EQ(nearest_key("weather", keys), "");
  EXPECT_EQ(nearest_key(std::string(100'000, 's'), keys), "");
}

}  // namespace
}  // namespace skein::scenario
