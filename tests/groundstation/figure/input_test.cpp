// What a file or folder holds to draw, also where it was cut or damaged.
#include "groundstation/figure/input.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "groundstation/record/recording.hpp"
#include "groundstation/record/tap.hpp"
#include "simworld/report/report.hpp"
#include "tests/groundstation/mcap/rewritten.hpp"
#include "tests/groundstation/record/recorded.hpp"

namespace skein::figure {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class InputTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("skein-input-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& bytes) {
    std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  std::filesystem::path folder_;
};

std::string text_of(const mcap::Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

TEST_F(InputTest, ARecordingHoldsRunReportAndScenario) {
  const Scenario scenario = tests::small_scenario("small", 7);
  const tests::RecordedBytes recorded = tests::record(scenario, {});
  const auto input = std::get<RunInput>(read_input(write("a.mcap", text_of(recorded.file))));
  EXPECT_EQ(input.data.vehicles.size(), 2U);
  EXPECT_EQ(input.outlines.size(), 2U);
  EXPECT_EQ(input.scenario_text, scenario.text);
  EXPECT_EQ(input.report, recorded.result.report);
  EXPECT_EQ(input.facts.at("recorder"), "in-process");
  EXPECT_TRUE(input.notes.empty());
}

TEST_F(InputTest, ACutRecordingIsDrawnUpToThereAndSaysSo) {
  std::string bytes = text_of(tests::record(tests::small_scenario("small", 7), {}).file);
  bytes.resize(bytes.size() - 6000);
  const auto input = std::get<RunInput>(read_input(write("a.mcap", bytes)));
  EXPECT_FALSE(input.data.vehicles.front().flown.empty());
  EXPECT_THAT(input.notes, Contains(HasSubstr("the file is not whole")));
}

TEST_F(InputTest, SamplesThatCannotBeReadAreLeftOutAndCounted) {
  const mcap::Bytes whole = tests::record(tests::small_scenario("small", 7), {}).file;
  for (const auto& [count, note] : {std::pair{1, "1 sample cannot be read and is left out"},
                                    std::pair{2, "2 samples cannot be read and are left out"}}) {
    const auto cut = [left = count](std::size_t, const std::string& topic, mcap::Bytes& payload) mutable {
      if (topic == "skein/beacon" && left-- > 0) payload.resize(5);
    };
    const std::string file = write("bad.mcap", text_of(mcap::tests::rewritten(whole, cut)));
    EXPECT_THAT(std::get<RunInput>(read_input(file)).notes, ElementsAre(note));
  }
}

TEST_F(InputTest, ARecordingWhoseEndWasNotHeardSaysSo) {
  const Scenario scenario = tests::small_scenario("small", 7);
  for (const char* end_heard : {"false", "true"}) {
    mcap::Bytes file;
    Recording recording([&](mcap::ByteView bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); },
                        {"attached", "geese", &scenario, false});
    InProcessOptions options;
    options.tap = tap_into([&](const TakenSample& sample) { recording.add(sample); });
    (void)run_in_process(scenario, options);
    recording.finish({{"lost", "0"}, {"end_heard", end_heard}});
    const auto input = std::get<RunInput>(read_input(write("a.mcap", text_of(file))));
    const auto note = Contains(HasSubstr("the end was not heard"));
    if (end_heard == std::string("false")) {
      EXPECT_THAT(input.notes, note);
    } else {
      EXPECT_THAT(input.notes, ::testing::Not(note));
    }
  }
}

TEST_F(InputTest, OfABrokenFileNothingIsDrawn) {
  std::string bytes = text_of(tests::record(tests::small_scenario("small", 7), {}).file);
  EXPECT_THROW((void)read_input(write("a.mcap", bytes.substr(0, 100))), std::runtime_error);
  EXPECT_THROW((void)read_input(write("b.json", "{}")), std::runtime_error);
  EXPECT_THROW((void)read_input(write("c.json", "no JSON")), std::runtime_error);
  EXPECT_THROW((void)read_input((folder_ / "nothing").string()), std::runtime_error);
  EXPECT_THROW((void)read_input(folder_.string()), std::runtime_error);
}

TEST_F(InputTest, AFoldersRunIsDoneAgainIfItsScenarioIsTheSame) {
  const Scenario scenario = tests::small_scenario("small", 7);
  InProcessOptions options;
  options.faults.push_back(*parse_fault("kill:2@fly:40").fault);
  const nlohmann::ordered_json report = run_in_process(scenario, options).report;
  write_json((folder_ / "report.json").string(), report);
  write("scenario.yaml", scenario.text);
  const auto input = std::get<RunInput>(read_input(folder_.string()));
  EXPECT_THAT(input.notes, ElementsAre(HasSubstr("to the same state hash")));
  EXPECT_EQ(input.data.vehicles[1].flown.back().step, 39U);
  EXPECT_EQ(input.report["state_hash"], report["state_hash"]);
  write("scenario.yaml", scenario.text + "\n# changed\n");
  const auto other = std::get<RunInput>(read_input(folder_.string()));
  EXPECT_THAT(other.notes, ElementsAre(HasSubstr("it is of another scenario")));
  EXPECT_TRUE(other.data.vehicles.empty());
}

TEST_F(InputTest, OverridesAreKnownFromTheReport) {
  const std::string path = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";
  const std::vector<Override> overrides{{"planner.particles", "12"}};
  const Scenario scenario = std::get<Scenario>(load_scenario(path, overrides, 7));
  write_json((folder_ / "report.json").string(), run_in_process(scenario, {}).report);
  write("scenario.yaml", scenario.text);
  const auto input = std::get<RunInput>(read_input((folder_ / "report.json").string()));
  EXPECT_THAT(input.notes, ElementsAre(HasSubstr("to the same state hash")));
  ASSERT_EQ(input.overrides.size(), 1U);
  EXPECT_EQ(input.overrides[0].key, "planner.particles");
}

}  // namespace
}  // namespace skein::figure
