// skein doctor as its user calls it, on the machine that runs the tests and on one with a limit put on it.
#include <gtest/gtest.h>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

TEST(Doctor, FindsThatThisMachineCanRunAFew) {
  const Ended ended = run_program({binary("skein"), "doctor", "--agents", "2", "--domain", "85", "--json"}, 30.0);
  ASSERT_EQ(ended.exit_code, 0) << ended.out << ended.err;
  const auto document = nlohmann::json::parse(ended.out);
  EXPECT_EQ(document.at("agents"), 2);
  EXPECT_EQ(document.at("domain"), 85);
  EXPECT_EQ(document.at("can_run"), true);
  EXPECT_EQ(document.at("findings").size(), 9U);
  for (const auto& finding : document.at("findings")) EXPECT_NE(finding.at("level"), "fail") << finding;
}

TEST(Doctor, NamesALimitInOneLineAndEndsWith1) {
  const std::string command = "ulimit -n 40 && exec '" + binary("skein") + "' doctor --agents 2 --domain 85";
  const Ended ended = run_program({"/bin/sh", "-c", command}, 30.0);
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  EXPECT_NE(ended.out.find("fail  descriptors     40 for each process, 64 needed; remedy: "), std::string::npos)
      << ended.out;
  EXPECT_NE(ended.out.find("2 agents cannot run on this machine\n"), std::string::npos) << ended.out;
}

}  // namespace
}  // namespace skein::e2e
