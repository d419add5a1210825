// A sweep that goes on from its journal gives what one without interruption gives; another's journal is refused.
#include "groundstation/sweep/journal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <set>

#include "groundstation/sweep/sweep.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

class Journal : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove(path); }
  void TearDown() override { std::filesystem::remove(path); }

  static std::string text_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& text) const { std::ofstream(path, std::ios::binary) << text; }
  [[nodiscard]] std::string refusal(const std::vector<std::uint64_t>& hashes) const {
    try {
      const RunJournal journal(path, "sweep", hashes);
      return "";
    } catch (const JournalRefused& refused) {
      return refused.what();
    }
  }
  [[nodiscard]] SweepPlan plan() const {
    SweepPlan sweep;
    sweep.scenario = SKEIN_SOURCE_DIR "/tests/data/small.yaml";
    sweep.keys = {{"planner.particles", {"6", "12"}}};
    sweep.first_seed = 3;
    sweep.runs = 3;
    sweep.journal = path;
    return sweep;
  }

  const std::string path =
      (std::filesystem::temp_directory_path() / ("skein-journal-" + std::to_string(::getpid()))).string();
};

Json run(std::uint64_t seed) {
  return {{"seed", seed}, {"exit_code", 0}, {"figures", {{"a", 0.1}, {"b", 1e-300}, {"c", 7}}}};
}

TEST_F(Journal, KeepsRunsByScenarioAndSeedToTheLastBit) {
  {
    RunJournal journal(path, "sweep", {1, 2});
    journal.add(0, run(5));
    journal.add(1, run(UINT64_MAX));
  }
  const RunJournal again(path, "sweep", {1, 2});
  ASSERT_NE(again.find(0, 5), nullptr);
  EXPECT_EQ(again.find(0, 5)->dump(), run(5).dump());
  ASSERT_NE(again.find(1, UINT64_MAX), nullptr);
  EXPECT_EQ(again.find(1, 5), nullptr);
  EXPECT_EQ(again.find(0, 6), nullptr);
}

TEST_F(Journal, ATornLastLineIsCutOff) {
  {
    RunJournal journal(path, "sweep", {1});
    journal.add(0, run(5));
    journal.add(0, run(6));
  }
  const std::string whole = text_of(path);
  const std::size_t second = whole.rfind('\n', whole.size() - 2) + 1;
  for (const std::size_t size : {second, second + 1, whole.size() - 1}) {
    write(whole.substr(0, size));
    {
      RunJournal journal(path, "sweep", {1});
      EXPECT_NE(journal.find(0, 5), nullptr);
      EXPECT_EQ(journal.find(0, 6), nullptr);
      journal.add(0, run(6));
    }
    EXPECT_EQ(text_of(path), whole);
  }
  write(whole.substr(0, 10));  // torn in its first line
  EXPECT_EQ(refusal({1}), "");
}

TEST_F(Journal, AnotherSweepsIsRefusedAndLeftAlone) {
  { RunJournal(path, "sweep", {1, 2}).add(0, run(5)); }
  const std::string before = text_of(path);
  for (const std::vector<std::uint64_t>& hashes : {std::vector<std::uint64_t>{1}, {2, 1}, {1, 2, 3}}) {
    EXPECT_THAT(refusal(hashes), HasSubstr("it is the journal of another skein sweep"));
  }
  EXPECT_THAT(refusal({1}), HasSubstr(": of 2 combinations of values, these are 1"));
  EXPECT_THAT(refusal({1, 3}), HasSubstr(": of another scenario or other values"));
  EXPECT_EQ(text_of(path), before);
  std::string other = before;
  other.replace(other.find("\"version\":\"") + 11, 1, "9");
  write(other);
  EXPECT_THAT(refusal({1, 2}), HasSubstr(": of version 9"));
  for (const char* text : {"hello\n", "hello", "{}\n", "{\"journal\":1}\n"}) {
    write(text);
    EXPECT_EQ(refusal({1, 2}), path + ": it is no journal of skein sweep");
    EXPECT_EQ(text_of(path), text);
  }
  write(before + "[1]\n");
  EXPECT_EQ(refusal({1, 2}), path + ":3: it is no run of skein sweep");
}

TEST_F(Journal, ValuesOfWrongTypesAreRefused) {
  write("{\"journal\":\"skein sweep\",\"version\":5,\"scenario_hashes\":7}\n");
  EXPECT_THAT(refusal({1, 2}), HasSubstr(": of version unknown, this is "));
  const auto with = [&](const Json& line) {
    std::filesystem::remove(path);
    { const RunJournal empty(path, "sweep", {1}); }
    std::ofstream(path, std::ios::app) << line.dump() << "\n";
    return refusal({1});
  };
  const std::string no_run = path + ":2: it is no run of skein sweep";
  const std::string hash = "0000000000000001";
  EXPECT_EQ(with({{"scenario_hash", hash}, {"run", 1}}), no_run);
  EXPECT_EQ(with({{"scenario_hash", hash}, {"run", {{"seed", -1}}}}), no_run);
  EXPECT_EQ(with({{"scenario_hash", hash}, {"run", {{"seed", "1"}}}}), no_run);
  EXPECT_EQ(with({{"scenario_hash", 1}, {"run", {{"seed", 1}}}}), no_run);
}

TEST_F(Journal, ARunWithoutWhatASweepTakesFromItIsRefused) {
  (void)run_sweep(plan());
  const std::string whole = text_of(path);
  const std::size_t first = whole.find('\n') + 1;
  const std::size_t second = whole.find('\n', first);
  const Json good = Json::parse(whole.substr(first, second - first));
  const auto refused = [&](const Json& line) {
    write(whole.substr(0, first) + line.dump() + whole.substr(second));
    try {
      (void)run_sweep(plan());
      return std::string();
    } catch (const JournalRefused& refusal) {
      return std::string(refusal.what());
    }
  };
  EXPECT_EQ(refused(good), "");
  for (const char* key : {"exit_code", "state_hash", "reason", "plan_feasible", "plan_success", "figures"}) {
    Json without = good;
    without["run"].erase(key);
    EXPECT_EQ(refused(without), path + ":2: it is no run of skein sweep") << key;
    Json wrong = good;
    wrong["run"][key] = Json::array();
    EXPECT_EQ(refused(wrong), path + ":2: it is no run of skein sweep") << key;
  }
  Json text = good;
  text["run"]["figures"]["steps"] = "many";
  EXPECT_EQ(refused(text), path + ":2: it is no run of skein sweep");
}

TEST_F(Journal, OneAtATimeHasIt) {
  {
    RunJournal journal(path, "sweep", {1});
    EXPECT_EQ(refusal({1}), path + ": another skein goes on with it now");
    journal.add(0, run(5));
  }
  EXPECT_EQ(refusal({1}), "");
}

TEST_F(Journal, OneThatCannotBeWrittenIsRefused) {
  EXPECT_THROW(RunJournal("/nowhere/at/all", "sweep", {1}), JournalRefused);
  EXPECT_THROW(RunJournal("/dev/full", "sweep", {1}), JournalRefused);
}

TEST_F(Journal, ASweepThatGoesOnEqualsOneWithoutInterruption) {
  SweepPlan whole = plan();
  const std::string expected = run_sweep(whole).rows.dump();  // its journal holds its wall times too
  const std::string journal = text_of(path);
  std::size_t made = 0;
  std::size_t before = SIZE_MAX;
  whole.on_progress = [&](std::size_t, std::size_t) { ++made; };
  whole.on_resume = [&](std::size_t done) { before = done; };
  EXPECT_EQ(run_sweep(whole).rows.dump(), expected);
  EXPECT_EQ(made, 0U);
  EXPECT_EQ(before, 6U);

  std::filesystem::remove(path);
  SweepPlan interrupted = plan();
  interrupted.stop = [calls = 0]() mutable { return ++calls == 2; };
  EXPECT_TRUE(run_sweep(interrupted).stopped);
  whole.jobs = 3;
  const Json rows = run_sweep(whole).rows;
  EXPECT_EQ(made, 4U);
  EXPECT_EQ(before, 2U);
  static const std::set<std::string> kTimed{"discovery_s", "plan_s", "rounds_per_s", "steps_per_s", "realtime_factor"};
  const auto timeless = [](Json all) {
    for (Json& row : all) {
      for (const std::string& name : kTimed) row["figures"].erase(name);
      for (Json& one : row["per_run"]) {
        for (const std::string& name : kTimed) one["figures"].erase(name);
      }
    }
    return all.dump();
  };
  EXPECT_EQ(timeless(rows), timeless(Json::parse(expected)));
}

}  // namespace
}  // namespace skein
