// Runs as JUnit XML: what a continuous integration reads, and no byte that XML forbids.
#include "groundstation/sweep/junit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

TEST(Junit, ASuiteARowAndACaseARun) {
  const Json good{{"seed", 4}, {"exit_code", 0}, {"reason", "all arrived"}};
  const Json bad{{"seed", 5}, {"exit_code", 1}, {"reason", "the flight did not end"}};
  const Json rows{{{"set", {{"planner.particles", "10"}}}, {"per_run", {good, bad}}}};
  EXPECT_EQ(junit_xml("small.yaml", junit_suites(rows, 2)),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites name=\"small.yaml\" tests=\"2\" failures=\"1\" errors=\"0\">\n"
            "  <testsuite name=\"planner.particles=10\" tests=\"2\" failures=\"1\" errors=\"0\">\n"
            "    <testcase classname=\"planner.particles=10\" name=\"seed 4\"/>\n"
            "    <testcase classname=\"planner.particles=10\" name=\"seed 5\">\n"
            "      <failure message=\"the flight did not end\" type=\"exit code 1\"/>\n"
            "    </testcase>\n"
            "  </testsuite>\n"
            "</testsuites>\n");
}

TEST(Junit, EscapesWhatXmlDoesNotHold) {
  const std::string xml = junit_xml("a&b", {{"x<y>", {{"\"quoted\"", "line\nand \x01", "t"}}}});
  EXPECT_THAT(xml, HasSubstr("<testsuites name=\"a&amp;b\""));
  EXPECT_THAT(xml, HasSubstr("classname=\"x&lt;y&gt;\" name=\"&quot;quoted&quot;\""));
  EXPECT_THAT(xml, HasSubstr("message=\"line and ?\""));
}

TEST(Junit, BytesThatAreNoCharactersDoNotGetIn) {
  const std::string xml = junit_xml("caf\xC3\xA9 \xFF\xFE", {{"a\xEF\xBF\xBF", {{"x\xC3", "\xE2\x82", "t"}}}});
  EXPECT_THAT(xml, HasSubstr("<testsuites name=\"caf\xC3\xA9 ??\""));
  EXPECT_THAT(xml, HasSubstr("classname=\"a?\" name=\"x?\""));
  EXPECT_THAT(xml, HasSubstr("message=\"??\""));
}

TEST(Junit, WhatWasNotRunIsAnError) {
  const Json good{{"seed", 4}, {"exit_code", 0}, {"reason", "all arrived"}};
  const Json rows{{{"set", Json::object()}, {"per_run", {good}}}};
  const std::string xml = junit_xml("s", junit_suites(rows, 5));
  EXPECT_THAT(xml, HasSubstr("tests=\"2\" failures=\"0\" errors=\"1\">\n  <testsuite"));
  EXPECT_THAT(xml, HasSubstr("name=\"runs that were not made\">\n      <error message=\"4 of 5 runs were not made\" "
                             "type=\"interrupted\"/>"));
}

TEST(Junit, AFailureWithoutReasonIsStillOne) {
  const Json rows{{{"set", Json::object()}, {"per_run", {{{"seed", 1}, {"exit_code", 4}, {"reason", ""}}}}}};
  EXPECT_THAT(junit_xml("s", junit_suites(rows, 1)),
              HasSubstr("<failure message=\"exit code 4\" type=\"exit code 4\"/>"));
}

}  // namespace
}  // namespace skein
