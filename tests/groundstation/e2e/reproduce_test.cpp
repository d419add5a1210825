// `skein reproduce` as its user calls it: figures that are those of `skein sweep`, a file that is the same each time.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <sstream>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

std::string content_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

nlohmann::json timeless(nlohmann::json table) {
  for (auto& entry : table) entry["figures"].erase("plan_s");
  return table;
}

TEST(Reproduce, FiguresAreThoseOfTheSweep) {
  const Ended ours =
      run_program({binary("skein"), "reproduce", "rendezvous", "--quick", "--seeds", "2", "--json"}, 120.0);
  ASSERT_EQ(ours.exit_code, 0) << ours.err;
  const auto document = nlohmann::json::parse(ours.out);
  EXPECT_EQ(document.at("complete"), true);
  const Ended sweep = run_program({binary("skein"), "sweep", scenario_path("rendezvous-2d"), "--runs", "2", "--seed",
                                   "0", "--planner", "dcpso-solo,dcpso-paper,dcpso,ccga", "--json"},
                                  120.0);
  ASSERT_EQ(sweep.exit_code, 0) << sweep.err;
  const auto table = nlohmann::json::parse(sweep.out).at("table");
  EXPECT_EQ(timeless(document.at("campaigns").at(0).at("table")), timeless(table));
  // and what is printed is what is in there
  const auto& printed = document.at("sections").at(0).at("tables").at(1);
  ASSERT_EQ(printed.at("id"), "rendezvous.table4");
  const auto& l2 = printed.at("rows").at(6);
  EXPECT_EQ(l2.at("figure"), "L2, mean (sd)");
  EXPECT_EQ(l2.at("source"), "Table 4, p. 12");
  const double mean_m = table.at(1).at("figures").at("vehicles.2.planned_length_m").at("mean");
  EXPECT_DOUBLE_EQ(l2.at("cells").at(1).at("value").get<double>(), 1e-3 * mean_m);
}

TEST(Reproduce, TheFileIsTheSameEachTime) {
  const ScratchFolder folder;
  for (const char* name : {"/a.md", "/b.md"}) {
    const Ended ended = run_program({binary("skein"), "reproduce", "rendezvous", "--quick", "--seeds", "1", "-o",
                                     folder.path() + name, "--jobs", name[1] == 'a' ? "1" : "2"},
                                    120.0);
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(ended.out, "");
  }
  const std::string text = content_of(folder.path() + "/a.md");
  EXPECT_EQ(text, content_of(folder.path() + "/b.md"));
  EXPECT_NE(text.find("| L1, mean (sd) | km | 35.0611 (0.0001) | "), std::string::npos) << text;
}

TEST(Reproduce, CtrlCPrintsWhatWasRunAndLeavesTheFile) {
  const ScratchFolder folder;
  const std::string file = folder.path() + "/kept.md";
  std::ofstream(file) << "as it was";
  Program program({binary("skein"), "reproduce", "all", "-o", file});
  ASSERT_TRUE(program.read_until(" of 4000 runs; ", 60.0));
  program.signal_group(SIGINT);
  const Ended ended = program.wait(60.0);
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_NE(ended.out.find("Interrupted"), std::string::npos);
  EXPECT_NE(ended.err.find("is as it was"), std::string::npos) << ended.err;
  EXPECT_EQ(content_of(file), "as it was");
}

TEST(Reproduce, WhatCannotBeWrittenIsSaidBeforeTheRuns) {
  const ScratchFolder folder;
  for (const std::string& file : {folder.path() + "/none/x.md", folder.path()}) {
    const Ended ended = run_program({binary("skein"), "reproduce", "all", "-o", file}, 20.0);
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_NE(ended.err.find("cannot write " + file), std::string::npos) << ended.err;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1);
  }
}

TEST(Reproduce, UsageIsChecked) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{binary("skein"), "reproduce"},
                                             {binary("skein"), "reproduce", "survey"},
                                             {binary("skein"), "reproduce", "all", "--seeds", "0"}}) {
    const Ended ended = run_program(arguments, 20.0);
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
  }
}

}  // namespace
}  // namespace skein::e2e
