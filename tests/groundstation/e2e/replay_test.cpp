// Only whole processes can prove it: a recording that is played is heard as the swarm was, and disturbs no live one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "groundstation/mcap/file.hpp"
#include "groundstation/mcap/reader.hpp"
#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kDomain = "101";
const std::string kSmall = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";

class Replay : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(skein_run(kSmall, 101, out.path(), {"--in-process", "--record", file}).ended.exit_code, 0);
  }
  static std::vector<std::string> replay_of(const std::string& path, const std::string& swarm,
                                            const std::vector<std::string>& more) {
    std::vector<std::string> arguments{binary("skein"), "replay", path, "--domain", kDomain, "--swarm", swarm};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  /// What `skein record` hears of a replay.
  std::string heard_of(const std::string& path, const std::string& swarm, const std::vector<std::string>& more) {
    std::string heard = out.path() + "/" + swarm + ".mcap";
    Program recorder({binary("skein"), "record", "--domain", kDomain, "--swarm", swarm, "-o", heard, "--json"});
    std::vector<std::string> waiting{"--wait", "1"};
    waiting.insert(waiting.end(), more.begin(), more.end());
    replayed = run_program(replay_of(path, swarm, waiting), 120.0);
    recorded = recorder.wait(60.0);
    return heard;
  }
  static Ended verify(const std::string& a, const std::string& b) {
    return run_program({binary("skein"), "verify", a, b}, 60.0);
  }

  const ScratchFolder out;
  const std::string file = out.path() + "/a.mcap";
  Ended replayed, recorded;
};

TEST_F(Replay, IsHeardAsTheSwarmWas) {
  const std::string heard = heard_of(file, "replayed", {"--rate", "50", "--json"});
  ASSERT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_EQ(recorded.exit_code, 0) << recorded.err;
  const Ended same = verify(file, heard);
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err << recorded.out;
  EXPECT_THAT(same.out, StartsWith("equal: "));
  const auto said = nlohmann::json::parse(replayed.out);
  EXPECT_EQ(said["swarm"], "replayed");
  EXPECT_EQ(said["refused"], 0);
  EXPECT_EQ(said["left_out"], 0);
}

TEST_F(Replay, FromLaterOnTheMissionStillComesFirst) {
  const std::string heard = heard_of(file, "later", {"--from", "100", "--rate", "0"});
  ASSERT_EQ(replayed.exit_code, 0) << replayed.err;
  const Ended mission = run_program({binary("skein"), "dump", heard, "--topic", "skein/mission"}, 30.0);
  EXPECT_EQ(std::ranges::count(mission.out, '\n'), 1);
  const Ended ticks = run_program({binary("skein"), "dump", heard, "--topic", "skein/tick"}, 30.0);
  const auto first = nlohmann::json::parse(ticks.out.substr(0, ticks.out.find('\n')));
  EXPECT_EQ(first["sample"]["time_s"], 100.0);
}

TEST_F(Replay, OfACutFileItPlaysUpToTheLastWholeChunkAndSaysSo) {
  const std::string cut = out.path() + "/cut.mcap";
  std::filesystem::copy_file(file, cut);
  {
    const mcap::MappedFile mapped(file);
    const mcap::ChunkIndex last = mcap::Reader(mapped.bytes()).contents().chunks.back();
    std::filesystem::resize_file(cut, last.chunk_offset + last.chunk_length + 5);
  }
  const Ended ended = run_program(replay_of(cut, "cut", {"--rate", "0"}), 60.0);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr(cut + ": it was cut"));
  EXPECT_THAT(ended.out, HasSubstr("samples played to swarm cut"));
}

TEST_F(Replay, IsASwarmToObserversAndToAnotherWorldAndEndsWithASignal) {
  Program replay(replay_of(file, "observed", {"--rate", "1", "--from", "20"}));
  ASSERT_TRUE(replay.read_until("playing", 60.0));
  const Ended other = run_program(
      {binary("skein-simworld"), kSmall, "--domain", kDomain, "--swarm", "observed", "--out", out.path() + "/world"},
      60.0);
  EXPECT_EQ(other.exit_code, 3) << other.err;
  EXPECT_THAT(other.err, HasSubstr("swarm 'observed' already has a world"));
  const Ended again = run_program(replay_of(file, "observed", {}), 60.0);
  EXPECT_EQ(again.exit_code, 3);
  EXPECT_EQ(again.err, "skein replay: swarm observed in domain 101 is live: choose another one with --swarm\n");
  const Ended seen = run_program({binary("skein"), "status", "--json", "--domain", kDomain}, 60.0);
  kill(replay.pid(), SIGINT);
  const Ended ended = replay.wait(30.0);
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_THAT(ended.err, HasSubstr("skein replay: ended by SIGINT\n"));
  const auto figures = nlohmann::json::parse(seen.out, nullptr, false);
  ASSERT_TRUE(figures.is_object()) << seen.out << seen.err;
  EXPECT_EQ(figures["phase"], "flying");
  EXPECT_EQ(figures["agents"].size(), 2U);
  EXPECT_TRUE(figures["agents"][1]["heard"]);
}

TEST_F(Replay, LeavesALiveSwarmAlone) {
  Program run({binary("skein"), "run", kSmall, "--json", "--out", out.path() + "/live", "--domain", kDomain, "--swarm",
               "living", "--realtime", "20"});
  ASSERT_TRUE(run.read_until("flight: step 1,", 60.0));
  const Ended refused = run_program(replay_of(file, "living", {}), 60.0);
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("swarm living in domain 101 is live"));
  EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1);
  const Ended ended = run.wait(60.0);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const SkeinRun alone = skein_run(kSmall, 101, out.path() + "/alone", {"--in-process"});
  EXPECT_EQ(nlohmann::json::parse(ended.out)["state_hash"], alone.report["state_hash"]);
}

TEST_F(Replay, WithoutTheObserversThatItWaitsForItEndsWith3) {
  const Ended ended = run_program(replay_of(file, "alone", {"--wait", "1", "--startup-timeout", "0.5"}), 60.0);
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_EQ(ended.err, "skein replay: 0 of 1 observers within 0.5 s\n");
}

}  // namespace
}  // namespace skein::e2e
