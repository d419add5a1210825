// Only whole files prove it: whatever byte of a recorded payload is another one, verify names round, agent and field,
// unless it is one that is not compared; and without checksums that match it names the record.
//
// What is expected comes from the schema that the file carries, and from the table in docs/recording.md alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "groundstation/mcap/file.hpp"
#include "groundstation/mcap/reader.hpp"
#include "groundstation/schema/decode.hpp"
#include "groundstation/schema/topics.hpp"
#include "planner/core/random/random_stream.hpp"
#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

using schema::Json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr unsigned kDomain = 102;
constexpr unsigned kBytes = 60;       ///< that are changed, each in a file of its own; SKEIN_ALTERED_BYTES
constexpr unsigned kRawBytes = 25;    ///< the same, without checksums that match
constexpr std::uint32_t kMargin = 2;  ///< rounds at both ends, where some samples have no counterpart
const std::string kSmall = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";
const std::string kAlter = std::string(SKEIN_BIN_DIR) + "/../tests/mcap_alter";

struct Sample {
  std::size_t number = 0;  ///< in the file
  std::string topic;
  std::uint32_t round = 0;
  mcap::Bytes payload;
};

Json fields_of(const std::string& topic, const mcap::Bytes& payload) {
  const auto fields = schema::decode(schema::type_of(schema::topic_named(topic)->id), payload);
  return fields ? *fields : Json();
}

/// Those that are compared, and of which there is no copy.
std::vector<Sample> compared_in(const std::string& path) {
  const mcap::MappedFile file(path);
  const mcap::Reader reader(file.bytes());
  std::vector<Sample> samples;
  std::map<std::string, unsigned> copies;
  std::map<std::size_t, std::string> names;
  std::size_t number = 0;
  std::uint32_t last = 0;
  reader.for_each([&](const mcap::Message& message) {
    Sample sample{number++, reader.contents().channels.at(message.channel_id).topic, 0,
                  mcap::Bytes(message.data.begin(), message.data.end())};
    const Json fields = fields_of(sample.topic, sample.payload);
    sample.round = fields.value("round", 0U);
    last = std::max(last, sample.round);
    names[sample.number] = fmt::format("{} {} {} {}", sample.topic, sample.round, fields.value("agent", 0U),
                                       fields["head"]["incarnation"].dump());
    ++copies[names[sample.number]];
    const bool introduces = sample.topic == "skein/beacon" && fields["head"]["incarnation"] == 0;
    if (!introduces && fields.value("closes_round", true)) samples.push_back(std::move(sample));
  });
  std::erase_if(samples, [&](const Sample& sample) {
    const bool at_an_end = sample.round < kMargin || sample.round + kMargin > last;
    return copies[names[sample.number]] > 1 || (at_an_end && sample.topic != "skein/mission");
  });
  return samples;
}

bool is_one_of(const std::string& field, std::initializer_list<const char*> names) {
  return std::ranges::any_of(names, [&](const std::string& name) {
    return field == name || field.starts_with(name + "[") || field.starts_with(name + ".");
  });
}

bool is_compared(const std::string& topic, const std::string& field) {
  if (field == "head.stamp_ns" || is_one_of(field, {"refused", "given"})) return false;
  if (field.starts_with("roster[") && field.ends_with(".nonce")) return false;
  return topic != "skein/beacon" || !is_one_of(field, {"nonce", "matched", "needs"});
}

/// What says which sample it is: with another one it is another sample, and the one there was is missing.
bool names_it(const std::string& topic, const std::string& field, const Json& value) {
  if (field == "head.run") return true;
  if (topic == "skein/mission") return false;
  if (field == "head.incarnation") return topic == "skein/beacon" && value == 0;
  return field == "round" || (topic != "skein/tick" && field == "agent") || field == "closes_round";
}

/// How the line begins that verify prints, A being the original.
std::string expectation(const Sample& sample, const mcap::Bytes& changed) {
  const Json a = fields_of(sample.topic, sample.payload);
  const Json b = fields_of(sample.topic, changed);
  const std::string agent = a.contains("agent") ? fmt::format("agent {}", a["agent"].dump()) : "the world";
  const std::string place = fmt::format("different: round {}, {}, {}", sample.round, agent, sample.topic);
  if (b.is_null()) {
    const auto& type = schema::type_of(schema::topic_named(sample.topic)->id);
    const auto fault = schema::first_null(a, schema::decode_partly(type, changed));
    return fmt::format("{}, field {}: A ", place, fault->field);
  }
  const auto difference = schema::first_difference(a, b);
  if (!difference || !is_compared(sample.topic, difference->field)) return "equal: ";
  if (names_it(sample.topic, difference->field, difference->b)) return place + ": the sample is only in A";
  return fmt::format("{}, field {}: A {}, B {}\n", place, difference->field, difference->a.dump(),
                     difference->b.dump());
}

class Altered : public testing::Test {
 protected:
  void SetUp() override {
    const SkeinRun run = skein_run(kSmall, kDomain, out.path() + "/run", {"--record", file});
    ASSERT_EQ(run.ended.exit_code, 0) << run.ended.err;
  }
  Ended verify_other() const { return run_program({binary("skein"), "verify", file, other}, 60.0); }

  const ScratchFolder out;
  const std::string file = out.path() + "/a.mcap";
  const std::string other = out.path() + "/b.mcap";
};

TEST_F(Altered, TwoRunsOfASeedAreEqual) {
  ASSERT_EQ(skein_run(kSmall, kDomain, out.path() + "/again", {"--record", other}).ended.exit_code, 0);
  const Ended same = verify_other();
  EXPECT_EQ(same.exit_code, 0);
  EXPECT_THAT(same.out, StartsWith("equal: "));
}

TEST_F(Altered, AnyByteOfAPayloadIsNamedByRoundAgentAndField) {
  const std::vector<Sample> samples = compared_in(file);
  std::map<std::string, std::vector<const Sample*>> by_topic;
  for (const Sample& sample : samples) by_topic[sample.topic].push_back(&sample);
  ASSERT_EQ(by_topic.size(), 5U);  // of a rendezvous: no obstacle maps
  RandomStream random(8, 0, Purpose::Test, 3);
  const unsigned bytes = seeds_or("SKEIN_ALTERED_BYTES", kBytes);
  unsigned equal = 0, fields = 0, missing = 0;
  for (unsigned i = 0; i < bytes; ++i) {
    const auto topic = std::next(by_topic.begin(), i % 5);
    const Sample& sample = *topic->second[random.below(topic->second.size())];
    const std::size_t byte = 4 + random.below(sample.payload.size() - 4);
    const std::uint64_t bits = 1 + random.below(255);
    SCOPED_TRACE(fmt::format("message {} of {}, byte {}, bits {}", sample.number, sample.topic, byte, bits));
    const Ended altered = run_program(
        {kAlter, file, other, std::to_string(sample.number), std::to_string(byte), std::to_string(bits)}, 60.0);
    ASSERT_EQ(altered.exit_code, 0) << altered.err;
    mcap::Bytes changed = sample.payload;
    changed[byte] ^= static_cast<std::uint8_t>(bits);
    const std::string expected = expectation(sample, changed);
    const Ended ended = verify_other();
    EXPECT_THAT(ended.out, StartsWith(expected));
    EXPECT_EQ(ended.exit_code, expected == "equal: " ? 0 : 1) << ended.err;
    ++(expected == "equal: " ? equal : expected.ends_with("only in A") ? missing : fields);
  }
  EXPECT_GT(equal, 0U);
  EXPECT_GT(missing, 0U);
  EXPECT_GT(fields, bytes / 3);
}

TEST_F(Altered, WithoutChecksumsThatMatchTheRecordIsNamed) {
  std::vector<mcap::ChunkIndex> chunks;
  std::string bytes;
  {
    const mcap::MappedFile mapped(file);
    chunks = mcap::Reader(mapped.bytes()).contents().chunks;
    bytes.assign(mapped.bytes().begin(), mapped.bytes().end());
  }
  RandomStream random(8, 0, Purpose::Test, 4);
  for (unsigned i = 0; i < kRawBytes; ++i) {
    const mcap::ChunkIndex& chunk = chunks[random.below(chunks.size())];
    const std::uint64_t at = chunk.chunk_offset + random.below(chunk.chunk_length);
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ static_cast<char>(1 + random.below(255)));
    std::ofstream(other, std::ios::binary) << damaged;
    const Ended ended = verify_other();
    EXPECT_EQ(ended.exit_code, 2) << "byte " << at;
    EXPECT_EQ(ended.out, "");
    EXPECT_THAT(ended.err, HasSubstr(fmt::format("{}: byte {}: ", other, chunk.chunk_offset)));
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
  }
}

TEST_F(Altered, TheToolSaysWhatItCannotAlter) {
  EXPECT_EQ(run_program({kAlter, file, other}, 30.0).exit_code, 2);
  EXPECT_EQ(run_program({kAlter, file, other, "999999999", "4", "1"}, 30.0).exit_code, 2);
  EXPECT_EQ(run_program({kAlter, file, other, "0", "999999999", "1"}, 30.0).exit_code, 2);
  EXPECT_EQ(run_program({kAlter, out.path() + "/none", other, "0", "4", "1"}, 30.0).exit_code, 2);
  EXPECT_EQ(run_program({kAlter, file, other, "0", "4", "0"}, 30.0).exit_code, 0);
  EXPECT_EQ(verify_other().exit_code, 0);
}

}  // namespace
}  // namespace skein::e2e
