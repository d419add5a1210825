// A recording holds what the bus carried: all samples, their bytes, and what is needed to run it again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "groundstation/mcap/reader.hpp"
#include "groundstation/record/tap.hpp"
#include "groundstation/schema/topics.hpp"
#include "idl/convert/cdr.hpp"
#include "tests/groundstation/record/recorded.hpp"
#include "tests/idl/convert/examples.hpp"

namespace skein {
namespace {

using tests::record;
using tests::RecordedBytes;
using tests::small_scenario;

TEST(Recording, HoldsEverySampleThatTheRunCounted) {
  for (const char* name : {"small", "small-transit"}) {
    SCOPED_TRACE(name);
    const RecordedBytes recorded = record(small_scenario(name, 7), {});
    ASSERT_EQ(recorded.result.exit_code, 0) << recorded.result.report["reason"];
    const mcap::Reader reader(recorded.file);
    reader.check();
    std::map<std::string, std::set<std::tuple<std::uint32_t, AgentId>>> found;
    reader.for_each([&](const mcap::Message& message) {
      const mcap::Channel& channel = reader.contents().channels.at(message.channel_id);
      const bus::TopicSpec* spec = schema::topic_named(channel.topic);
      ASSERT_NE(spec, nullptr);
      const auto head = head_of(spec->id, message.data).value();
      if (spec->id != bus::TopicId::Mission && head.round == 0) return;  // before the start
      found[channel.topic.substr(6)].emplace(head.round, head.agent);
    });
    for (const auto& [topic, counted] : recorded.result.report["topics"].items()) {
      const auto expected = counted["samples"].get<std::uint64_t>();
      // the report counts the ticks of the waiting phase too
      if (topic == "tick") {
        EXPECT_LE(found[topic].size(), expected);
        EXPECT_GE(found[topic].size() + 10, expected);
      } else if (topic == "mission") {
        EXPECT_EQ(found[topic].size(), 1U);
      } else {
        EXPECT_EQ(found[topic].size(), expected) << topic;
      }
    }
  }
}

TEST(Recording, TellsWhatItIsOf) {
  const Scenario scenario = small_scenario("small", 21);
  const RecordedBytes recorded = record(scenario, {});
  const mcap::Reader reader(recorded.file);
  const auto text = reader.attachment(kScenarioName).value();
  EXPECT_EQ(std::string(text.data.begin(), text.data.end()), scenario.text);
  EXPECT_EQ(reader.metadata("skein.scenario").value().texts.at("seed"), "21");
  EXPECT_EQ(reader.metadata("skein.run").value().texts.at("scenario"), "small");
  EXPECT_EQ(reader.metadata("skein").value().texts.at("wire_version"), std::to_string(wire::kWireVersion));
  EXPECT_EQ(reader.metadata("skein.kept").value().texts.at("samples"),
            std::to_string(reader.contents().statistics.message_count));
  const auto report = reader.attachment(kReportName).value();
  EXPECT_EQ(nlohmann::ordered_json::parse(report.data)["state_hash"], recorded.result.report["state_hash"]);
}

TEST(Recording, HasAChannelForEachTopicWriterAndAgentWithTimesThatDoNotGoBack) {
  const RecordedBytes recorded = record(small_scenario("small", 7), {});
  const mcap::Reader reader(recorded.file);
  std::set<std::tuple<std::string, std::string, std::string>> keys;
  for (const auto& [id, channel] : reader.contents().channels) {
    EXPECT_EQ(channel.message_encoding, "cdr");
    const mcap::Schema& schema = reader.contents().schemas.at(channel.schema_id);
    EXPECT_EQ(schema.encoding, "omgidl");
    EXPECT_EQ(schema.name, schema::topic_named(channel.topic)->type);
    const auto agent = channel.metadata.contains("agent") ? channel.metadata.at("agent") : "";
    EXPECT_TRUE(keys.emplace(channel.topic, channel.metadata.at("writer"), agent).second);
  }
  EXPECT_TRUE(keys.contains({"skein/sense", "world", "2"}));
  EXPECT_TRUE(keys.contains({"skein/beacon", "agent 1", "1"}));
  std::map<std::uint16_t, std::pair<std::uint64_t, std::uint32_t>> last;
  reader.for_each([&](const mcap::Message& message) {
    auto& [time, sequence] = last[message.channel_id];
    EXPECT_GE(message.log_time, time);
    EXPECT_EQ(message.sequence, sequence + 1);
    time = message.log_time;
    sequence = message.sequence;
  });
  EXPECT_GT(reader.contents().statistics.end_time, 1'000'000'000U);  // simulated time
}

TEST(Recording, WhatAGroundStationSaysIsOfTheNewestRound) {
  mcap::Bytes file;
  Recording recording([&](mcap::ByteView bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); },
                      {"attached", "geese", nullptr, false});
  Tick tick = examples::tick();
  tick.round = 7;
  tick.time_s = 2.5;
  const Bytes ticked = to_cdr(to_wire(tick, examples::kStamp));
  const Bytes told = to_cdr(to_wire(examples::command(), examples::kStamp));
  recording.add({bus::TopicId::Tick, true, 1, ticked});
  recording.add({bus::TopicId::Command, false, 1, told});
  recording.finish({});
  const mcap::Reader reader(file);
  std::vector<std::pair<std::string, std::uint64_t>> said;
  reader.for_each([&](const mcap::Message& message) {
    const mcap::Channel& channel = reader.contents().channels.at(message.channel_id);
    said.emplace_back(channel.metadata.at("writer"), message.log_time);
  });
  EXPECT_THAT(said,
              ::testing::ElementsAre(std::pair("world", 2'500'000'007U), std::pair("ground station", 2'500'000'007U)));
}

TEST(Recording, CountsWhatIsNoSample) {
  mcap::Bytes file;
  Recording recording([&](mcap::ByteView bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); },
                      {"attached", "geese", nullptr, false});
  const Bytes garbage(10, 1);
  recording.add({bus::TopicId::Beacon, false, 5, garbage});
  recording.finish({{"lost", "3"}});
  const mcap::Reader reader(file);
  EXPECT_EQ(reader.metadata("skein.kept").value().texts,
            (mcap::Texts{{"lost", "3"}, {"refused", "1"}, {"samples", "0"}}));
  EXPECT_EQ(reader.attachment(kScenarioName), std::nullopt);
}

}  // namespace
}  // namespace skein
