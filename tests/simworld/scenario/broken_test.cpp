// Each file of tests/data/broken has one fault, and beside it the exact line that must be said about it.
#include <gmock/gmock.h>

#include <filesystem>
#include <set>

#include "tests/simworld/scenario/scenarios.hpp"

namespace skein::test {
namespace {

std::vector<std::string> broken_names() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kDataDir + "broken")) {
    if (entry.path().extension() == ".yaml") names.insert(entry.path().stem().string());
  }
  return {names.begin(), names.end()};
}

class Broken : public testing::TestWithParam<std::string> {};

TEST_P(Broken, IsRefusedInTheExpectedLine) {
  const std::string dir = kDataDir + "broken/";
  const std::string expected = text_of(dir + GetParam() + ".expect");
  ASSERT_FALSE(expected.empty()) << "there is no " << GetParam() << ".expect";
  const std::string line = fault_line(load_scenario(dir + GetParam() + ".yaml", {}, std::nullopt));
  EXPECT_EQ(line + "\n", dir + expected);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Broken, testing::ValuesIn(broken_names()),
                         [](const auto& broken) { return broken.param; });

TEST(BrokenScenarios, AreManyAndOnlyOneFaultFromTheSmallOne) {
  EXPECT_GE(broken_names().size(), 22U);
  EXPECT_EQ(fault_line(load_small({})), "no fault");
}

TEST(BrokenScenarios, NamePlaceAndRemedy) {
  for (const std::string& name : broken_names()) {
    const std::string line = text_of(kDataDir + "broken/" + name + ".expect");
    EXPECT_THAT(line,
                testing::MatchesRegex(
                    "[a-z_]+\\.yaml:[0-9]+:[0-9]+: [^\n]+(allowed: |did you mean |write the |leave it )[^\n]+\n"));
  }
}

}  // namespace
}  // namespace skein::test
