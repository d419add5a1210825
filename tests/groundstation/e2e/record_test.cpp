// Only whole processes can prove it: a recording of a swarm over DDS holds every sample, and one that is made from
// outside counts exactly what it lost.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <map>
#include <memory>
#include <set>

#include "groundstation/mcap/file.hpp"
#include "groundstation/mcap/reader.hpp"
#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr unsigned kDomain = 91;
constexpr unsigned kOtherDomain = 92;
const std::string kSmall = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";

Ended verify(const std::vector<std::string>& files) {
  std::vector<std::string> arguments{binary("skein"), "verify"};
  arguments.insert(arguments.end(), files.begin(), files.end());
  return run_program(arguments, 60.0);
}

/// Sequence numbers by channel: topic, writer, agent.
std::map<std::string, std::set<std::uint64_t>> numbers_in(const std::string& path) {
  const mcap::MappedFile file(path);
  const mcap::Reader reader(file.bytes());
  std::map<std::string, std::set<std::uint64_t>> numbers;
  reader.for_each([&](const mcap::Message& message) {
    const mcap::Channel& channel = reader.contents().channels.at(message.channel_id);
    const std::string agent = channel.metadata.contains("agent") ? channel.metadata.at("agent") : "";
    numbers[channel.topic + " " + channel.metadata.at("writer") + " " + agent].insert(message.sequence);
  });
  return numbers;
}

TEST(Record, ARunOverDdsIsRecordedWholeAndEqualsTheOneInProcess) {
  const ScratchFolder out;
  const std::string dds = out.path() + "/dds.mcap";
  const std::string here = out.path() + "/here.mcap";
  const SkeinRun run = skein_run(kSmall, kDomain, out.path() + "/a", {"--record", dds});
  ASSERT_EQ(run.ended.exit_code, 0) << run.ended.err;
  ASSERT_EQ(skein_run(kSmall, kDomain, out.path() + "/b", {"--in-process", "--record", here}).ended.exit_code, 0);
  const Ended same = verify({dds, here});
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  EXPECT_THAT(same.out, StartsWith("equal: "));
  EXPECT_EQ(verify({dds, "--rerun"}).exit_code, 0);
  const mcap::MappedFile file(dds);
  EXPECT_EQ(mcap::Reader(file.bytes()).metadata("skein.kept").value().texts.at("lost"), "0");
}

TEST(Record, TwentyFiveAgentsLoseNothing) {
  const ScratchFolder out;
  const std::string file = out.path() + "/ring.mcap";
  const SkeinRun run =
      skein_run(scenario_path("rendezvous-ring"), kDomain, out.path(),
                {"--agents", "25", "--per-process", "5", "--record", file, "--set", "world.max_steps=60"});
  ASSERT_TRUE(run.report.is_object()) << run.ended.err;
  EXPECT_EQ(run.report["steps"], 60);
  const Ended same = verify({file, "--rerun"});
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  const mcap::MappedFile mapped(file);
  EXPECT_EQ(mcap::Reader(mapped.bytes()).metadata("skein.kept").value().texts.at("lost"), "0");
}

TEST(Record, LossesAndReturnsAreInTheRecordAndRunAgain) {
  const ScratchFolder out;
  const std::string file = out.path() + "/faults.mcap";
  const SkeinRun run = skein_run(kSmall, kDomain, out.path(),
                                 {"--record", file, "--fault", "restart:2@plan:6", "--fault", "kill:1@fly:40"});
  ASSERT_TRUE(run.report.is_object()) << run.ended.err;
  EXPECT_EQ(run.report["roster_changes"].size(), 3U);
  const Ended same = verify({file, "--rerun"});
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
}

TEST(Record, AFileThatCannotBeWrittenIsSaidBeforeAnythingStarts) {
  const ScratchFolder out;
  const SkeinRun run = skein_run(kSmall, kDomain, out.path(), {"--record", "/dev/full"});
  EXPECT_EQ(run.ended.exit_code, 2) << run.ended.err;
  EXPECT_THAT(run.ended.err, HasSubstr("/dev/full"));
}

TEST(Record, AStarvedRecorderCountsExactlyWhatItLost) {
  const ScratchFolder out;
  const std::string whole = out.path() + "/whole.mcap";
  const std::string part = out.path() + "/part.mcap";
  const std::string domain = std::to_string(kOtherDomain);
  Program run({binary("skein"), "run", kSmall, "--json", "--out", out.path(), "--domain", domain, "--swarm", "starved",
               "--record", whole, "--realtime", "60"});
  ASSERT_TRUE(run.read_until("flight: step 1,", 30.0));
  Program recorder(
      {binary("skein"), "record", "--swarm", "starved", "--domain", domain, "-o", part, "--json", "--inbox", "5"});
  ASSERT_TRUE(run.read_until("step 200,", 60.0));
  EXPECT_EQ(run.wait(60.0).exit_code, 0);
  const Ended ended = recorder.wait(30.0);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto result = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(result.is_object()) << ended.out;
  EXPECT_GT(result["lost"].get<std::uint64_t>(), 0U);
  const auto all = numbers_in(whole);
  std::uint64_t lost = 0;
  for (const auto& [channel, kept] : numbers_in(part)) {
    ASSERT_TRUE(all.contains(channel)) << channel;
    const auto& sent = all.at(channel);
    const auto between = std::distance(sent.lower_bound(*kept.begin()), sent.upper_bound(*kept.rbegin()));
    lost += static_cast<std::uint64_t>(between) - kept.size();
  }
  std::uint64_t counted = 0;
  for (const auto& writer : result["writers"]) {
    counted += writer["to"].get<std::uint64_t>() - writer["from"].get<std::uint64_t>() + 1;
    counted -= writer["kept"].get<std::uint64_t>();
  }
  EXPECT_EQ(counted, lost);
  EXPECT_GE(result["lost"], lost);  // and what ticks tell of the end
  EXPECT_EQ(verify({whole, "--rerun"}).exit_code, 0);
}

/// Of the beacons and ticks of a result of `skein record --json`: by channel, whether the end was heard.
std::map<std::string, bool> ends_in(const nlohmann::json& result) {
  std::map<std::string, bool> ends;
  for (const auto& writer : result.at("writers")) {
    const auto name = writer.at("writer").get<std::string>();
    if (writer.at("end_heard").is_boolean()) ends[name] = writer.at("end_heard").get<bool>();
  }
  return ends;
}

TEST(Record, ARecorderThatStoodStillOwnsThatItDidNotHearTheEnd) {
  const ScratchFolder out;
  const std::string whole = out.path() + "/whole.mcap";
  const std::string part = out.path() + "/part.mcap";
  const std::string domain = std::to_string(kOtherDomain);
  Program run({binary("skein"), "run", scenario_path("rendezvous-ring"), "--agents", "6", "--json", "--out", out.path(),
               "--domain", domain, "--swarm", "stopped", "--record", whole, "--realtime", "60"});
  Program recorder({binary("skein"), "record", "--swarm", "stopped", "--domain", domain, "-o", part, "--json",
                    "--startup-timeout", "60"});
  ASSERT_TRUE(run.read_until("flight: step 200,", 60.0));
  ASSERT_EQ(kill(recorder.pid(), SIGSTOP), 0);
  EXPECT_EQ(run.wait(60.0).exit_code, 0);
  ASSERT_EQ(kill(recorder.pid(), SIGCONT), 0);
  const Ended ended = recorder.wait(60.0);
  const auto result = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(result.is_object()) << ended.out << ended.err;
  // its last tick may have waited in the socket
  EXPECT_TRUE(ended.exit_code == 0 || ended.exit_code == 3) << ended.err;
  if (ended.exit_code == 3) {
    EXPECT_THAT(result["reason"], HasSubstr("this process stood still for"));
    EXPECT_FALSE(result["end_heard"].get<bool>());
  }
  EXPECT_TRUE(result["lost"] > 0 || !result["end_heard"].get<bool>());
  const auto ends = ends_in(result);
  const auto all = numbers_in(whole);
  constexpr int kRepeats = 4;  // of the last tick, and of what answers it
  for (const auto& [channel, kept] : numbers_in(part)) {
    const bool is_tick = channel.starts_with("skein/tick");
    if (!is_tick && !channel.starts_with("skein/beacon agent")) continue;
    const auto after = std::distance(all.at(channel).upper_bound(*kept.rbegin()), all.at(channel).end());
    const std::string writer =
        is_tick ? "skein/tick of world" : "skein/beacon of " + channel.substr(13, channel.rfind(' ') - 13);
    ASSERT_TRUE(ends.contains(writer)) << writer << ended.out;
    EXPECT_FALSE(after > kRepeats && ends.at(writer)) << writer << ": " << after << " more were sent";
  }
}

TEST(Record, WithoutASwarmAFileThatIsThereStays) {
  const ScratchFolder out;
  const std::string file = out.path() + "/old.mcap";
  std::ofstream(file) << "an old recording";
  const Ended ended = run_program({binary("skein"), "record", "--swarm", "nobody", "--domain", std::to_string(kDomain),
                                   "-o", file, "--startup-timeout", "0.3"},
                                  30.0);
  EXPECT_EQ(ended.exit_code, 3) << ended.err;
  std::ifstream read(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(read), {}), "an old recording");
}

TEST(Record, AKilledRecordingOpensUpToItsLastChunk) {
  const ScratchFolder out;
  const std::string file = out.path() + "/killed.mcap";
  const std::string swarm = "record-killed";
  Program run({binary("skein"), "run", kSmall, "--out", out.path(), "--domain", std::to_string(kDomain), "--swarm",
               swarm, "--record", file, "--realtime", "20"});
  ASSERT_TRUE(run.read_until("step 200,", 60.0));
  ASSERT_EQ(kill(run.pid(), SIGKILL), 0);
  (void)run.wait(10.0);
  EXPECT_TRUE(gone_within(swarm, 20.0));
  const Ended again = verify({file, "--rerun"});
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
  EXPECT_THAT(again.err, HasSubstr("it was cut"));
}

TEST(Verify, SaysWhatIsWrongWithAFile) {
  const ScratchFolder out;
  const std::string file = out.path() + "/a.mcap";
  ASSERT_EQ(skein_run(kSmall, kDomain, out.path(), {"--in-process", "--record", file}).ended.exit_code, 0);
  const std::string other = out.path() + "/b.mcap";
  ASSERT_EQ(skein_run(kSmall, kDomain, out.path(), {"--in-process", "--seed", "8", "--record", other}).ended.exit_code,
            0);
  const Ended different = verify({file, other});
  EXPECT_EQ(different.exit_code, 1);
  EXPECT_EQ(different.out, "different: round 0, the world, skein/mission, field seed: A \"7\", B \"8\"\n");
  std::uint64_t chunk = 0;
  {
    const mcap::MappedFile mapped(other);
    chunk = mcap::Reader(mapped.bytes()).contents().chunks.front().chunk_offset;
  }
  std::fstream damaged(other, std::ios::in | std::ios::out | std::ios::binary);
  damaged.seekp(static_cast<std::streamoff>(chunk) + 500);
  damaged.put('\x55');
  damaged.close();
  const Ended bad = verify({file, other});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.err, HasSubstr(other + ": byte " + std::to_string(chunk) + ": a chunk"));
  EXPECT_EQ(verify({file, out.path() + "/none"}).exit_code, 2);
  EXPECT_EQ(verify({file}).exit_code, 2);
}

}  // namespace
}  // namespace skein::e2e
