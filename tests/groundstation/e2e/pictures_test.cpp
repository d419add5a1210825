// Only whole programs can prove it: what skein run and skein sweep leave becomes pictures and pages, in files of their
// own that need nothing else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr unsigned kDomain = 98;  // all runs are in process
const std::string kSmall = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Ended skein(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {}) {
  std::vector<std::string> all{binary("skein")};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run_program(all, 120.0, environment);
}

/// What Python's XML parser and a look for references say of a page; empty: all is well.
std::string faults_of(const std::string& page) {
  const char* check =
      "import re, sys, xml.etree.ElementTree as tree\n"
      "text = open(sys.argv[1], encoding='utf-8').read()\n"
      "tree.fromstring(text)\n"
      "ids = re.findall(r'\\sid=[\"\\'](.*?)[\"\\']', text)\n"
      "if len(ids) != len(set(ids)): print('an id twice')\n"
      "bare = re.sub(r'xmlns(:xlink)?=\"[^\"]*\"', '', text)\n"
      "for pattern in ('<script', '<link', '<iframe', r'\\ssrc=', r'href=[\"\\'](?!#)', r'url\\((?!#)', '@import'):\n"
      "    if re.search(pattern, bare): print('it refers to elsewhere: ' + pattern)\n";
  const Ended ended = run_program({"python3", "-c", check, page}, 60.0);
  return ended.out + ended.err;
}

/// A run of 80 s at most, recorded.
struct Recorded {
  explicit Recorded(const std::vector<std::string>& more = {}) {
    std::vector<std::string> flags{"--in-process", "--record", file()};
    flags.insert(flags.end(), more.begin(), more.end());
    run = skein_run(kSmall, kDomain, folder(), flags);
  }
  [[nodiscard]] std::string file() const { return out.path() + "/run.mcap"; }
  [[nodiscard]] std::string folder() const { return out.path() + "/run"; }
  ScratchFolder out;
  SkeinRun run;
};

TEST(Pictures, ARecordingBecomesFiguresInBothFormats) {
  const Recorded recorded;
  ASSERT_EQ(recorded.run.ended.exit_code, 0) << recorded.run.ended.err;
  const std::string figures = recorded.out.path() + "/figures";
  const Ended all = skein({"plot", recorded.file(), "-o", figures, "--json"});
  ASSERT_EQ(all.exit_code, 0) << all.err;
  const auto list = nlohmann::json::parse(all.out);
  EXPECT_EQ(list.at("figures").size(), 4U);  // in the plane: neither in space nor torsion
  for (const auto& item : list.at("figures")) {
    EXPECT_THAT(text_of(item.at("file")), AllOf(HasSubstr("<svg"), HasSubstr("</svg>"))) << item;
  }
  const std::string png = recorded.out.path() + "/separation.png";
  EXPECT_EQ(skein({"plot", recorded.file(), "--figure", "separation", "-o", png}).exit_code, 0);
  EXPECT_THAT(text_of(png), StartsWith("\x89PNG"));
}

TEST(Pictures, APageHoldsTheRunAndNeedsNothingElse) {
  const Recorded recorded({"--set", "planner.particles=11"});
  ASSERT_EQ(recorded.run.ended.exit_code, 0) << recorded.run.ended.err;
  for (const std::string& input : {recorded.file(), recorded.folder()}) {
    const std::string page = recorded.out.path() + "/report.html";
    const Ended ended = skein({"report", input, "-o", page});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(faults_of(page), "") << input;
    const std::string text = text_of(page);
    EXPECT_THAT(text, HasSubstr(recorded.run.report.at("state_hash").get<std::string>()));
    EXPECT_THAT(text, HasSubstr(recorded.run.report.at("scenario_hash").get<std::string>()));
    EXPECT_THAT(text, HasSubstr("The smallest complete scenario"));
    EXPECT_THAT(text, HasSubstr("--seed 7 --set planner.particles=11 --in-process"));
    EXPECT_THAT(text, HasSubstr("<th>seed</th><td>7</td>"));
    EXPECT_THAT(text, Not(HasSubstr("another state hash")));
  }
}

TEST(Pictures, ACutRecordingSaysSoInItsPage) {
  const Recorded recorded;
  ASSERT_EQ(recorded.run.ended.exit_code, 0) << recorded.run.ended.err;
  std::filesystem::resize_file(recorded.file(), std::filesystem::file_size(recorded.file()) - 6000);
  const std::string page = recorded.out.path() + "/report.html";
  const Ended ended = skein({"report", recorded.file(), "-o", page});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("the file is not whole"));
  EXPECT_EQ(faults_of(page), "");
  EXPECT_THAT(text_of(page), HasSubstr("the file is not whole"));
}

TEST(Pictures, ASweepBecomesAPageOnceOrLater) {
  const ScratchFolder out;
  const std::string page = out.path() + "/sweep.html";
  const Ended swept = skein(
      {"sweep", kSmall, "--runs", "3", "--seed", "4", "--set", "planner.particles=8,12", "--json", "--report", page});
  ASSERT_EQ(swept.exit_code, 0) << swept.err;
  EXPECT_EQ(faults_of(page), "");
  EXPECT_THAT(text_of(page), AllOf(HasSubstr("planner.particles"), HasSubstr("--runs 3 --seed 4"), HasSubstr("<svg")));
  const std::string file = out.path() + "/sweep.json";
  std::ofstream(file) << swept.out;
  const std::string later = out.path() + "/later.html";
  ASSERT_EQ(skein({"report", file, "-o", later}).exit_code, 0);
  EXPECT_EQ(faults_of(later), "");
  EXPECT_THAT(text_of(later), HasSubstr("--runs 3 --seed 4"));
  const std::string steps = out.path() + "/steps.svg";
  EXPECT_EQ(skein({"plot", file, "--figure", "box", "--value", "steps", "-o", steps}).exit_code, 0);
  EXPECT_THAT(text_of(steps), HasSubstr("steps"));
}

TEST(Pictures, WhatCannotBeDoneIsSaidInOneLine) {
  const Recorded recorded;
  const std::string nothing = recorded.out.path() + "/nothing.mcap";
  std::ofstream(nothing) << text_of(recorded.file()).substr(0, 200);
  const std::string file = recorded.file();
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"plot", nothing},
                                             {"report", nothing},
                                             {"plot", "/nowhere.mcap"},
                                             {"report", "/nowhere"},
                                             {"report", file, "-o", "/nowhere/report.html"},
                                             {"report", file, "-o", "/dev/full"},
                                             {"plot", file, "--figure", "paths", "-o", "/nowhere/paths.svg"},
                                             {"plot", file, "-o", "/dev/null/figures"},
                                             {"plot", file, "--figure", "torsion"},
                                             {"plot", file, "--figure", "pie"},
                                             {"plot", file, "--format", "gif"},
                                             {"sweep", kSmall, "--runs", "1", "--report", "/nowhere/sweep.html"}}) {
    const Ended ended = skein(arguments);
    const std::string what = testing::PrintToString(arguments) + "\n" + ended.err;
    EXPECT_EQ(ended.exit_code, 2) << what;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << what;
  }
}

TEST(Pictures, WithoutGnuplotThePackageIsNamed) {
  const Recorded recorded;
  const std::vector<std::string> nowhere{"PATH=" + recorded.out.path()};
  const std::string page = recorded.out.path() + "/report.html";
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"plot", recorded.file(), "-o", recorded.out.path()},
                                             {"report", recorded.file(), "-o", page},
                                             {"sweep", kSmall, "--runs", "1", "--report", page}}) {
    const Ended ended = skein(arguments, nowhere);
    EXPECT_EQ(ended.exit_code, 3) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("gnuplot-nox"));
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  }
}

}  // namespace
}  // namespace skein::e2e
