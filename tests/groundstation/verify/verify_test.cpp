// Two runs of one seed are equal; what differs is named by round, agent and field.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "groundstation/record/tap.hpp"
#include "groundstation/schema/topics.hpp"
#include "groundstation/verify/compare.hpp"
#include "groundstation/verify/rerun.hpp"
#include "idl/convert/convert.hpp"
#include "tests/groundstation/record/recorded.hpp"

namespace skein {
namespace {

using bus::TopicId;
using tests::record;
using tests::RecordedBytes;
using tests::small_scenario;

using Change = std::function<void(TopicId, Bytes&)>;

/// The file written anew, with checksums that match, and payloads that `change` may alter.
mcap::Bytes rewritten(const mcap::Bytes& file, const Change& change) {
  const mcap::Reader reader(file);
  mcap::Bytes out;
  mcap::Writer writer([&](mcap::ByteView bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); });
  for (const auto& [id, schema] : reader.contents().schemas)
    (void)writer.add_schema(schema.name, "omgidl", schema.data);
  for (const auto& [id, channel] : reader.contents().channels) {
    (void)writer.add_channel(channel.schema_id, channel.topic, "cdr", channel.metadata);
  }
  reader.for_each([&](mcap::Message message) {
    Bytes payload(message.data.begin(), message.data.end());
    change(schema::topic_named(reader.contents().channels.at(message.channel_id).topic)->id, payload);
    message.data = payload;
    writer.write(message);
  });
  writer.finish();
  return out;
}

template <typename Wire>
Change on(TopicId topic, std::uint32_t round, const std::function<void(Wire&)>& change) {
  return [=](TopicId of, Bytes& payload) {
    if (of != topic) return;
    auto sample = from_cdr<Wire>(payload).value();
    if (sample.round() != round) return;
    change(sample);
    payload = to_cdr(sample);
  };
}

Comparison compare_files(const mcap::Bytes& a, const mcap::Bytes& b) {
  return compare(run_of(mcap::Reader(a)), run_of(mcap::Reader(b)));
}

TEST(Verify, TwoRunsOfASeedAreEqualAndOfAnotherAreNot) {
  const RecordedBytes a = record(small_scenario("small", 7), {});
  const Comparison same = compare_files(a.file, record(small_scenario("small", 7), {}).file);
  EXPECT_FALSE(same.difference);
  EXPECT_GT(same.samples, 4U * same.rounds);  // tick, two sense, two beacons
  EXPECT_THAT(text_of(same), ::testing::StartsWith("equal: "));
  const Comparison other = compare_files(a.file, record(small_scenario("small", 8), {}).file);
  ASSERT_TRUE(other.difference);
  EXPECT_EQ(text_of(other), "different: round 0, the world, skein/mission, field seed: A \"7\", B \"8\"");
}

TEST(Verify, NamesRoundAgentAndFieldOfAChangedValue) {
  const mcap::Bytes a = record(small_scenario("small", 7), {}).file;
  const mcap::Bytes b = rewritten(a, on<wire::Beacon>(TopicId::Beacon, 30, [](wire::Beacon& beacon) {
                                    if (beacon.agent() == 2) beacon.commanded_velocity_mps().y(0.25);
                                  }));
  const Comparison found = compare_files(a, b);
  ASSERT_TRUE(found.difference);
  EXPECT_EQ(found.difference->where.round, 30U);
  EXPECT_EQ(found.difference->where.agent, 2U);
  EXPECT_EQ(found.difference->where.topic, TopicId::Beacon);
  EXPECT_EQ(found.difference->field, "commanded_velocity_mps.y");
  EXPECT_EQ(found.difference->b, 0.25);
  EXPECT_EQ(json_of(found)["difference"]["agent"], 2);
}

TEST(Verify, NamesWhatARosterSaysOtherwise) {
  const mcap::Bytes a = record(small_scenario("small", 7), {}).file;
  const mcap::Bytes b =
      rewritten(a, on<wire::Tick>(TopicId::Tick, 20, [](wire::Tick& tick) { tick.roster()[1].incarnation(5); }));
  const Comparison found = compare_files(a, b);
  ASSERT_TRUE(found.difference);
  EXPECT_THAT(text_of(found), ::testing::HasSubstr("round 20, the world, skein/tick, field roster[1].incarnation"));
}

TEST(Verify, NamesASampleThatOneRunAloneHas) {
  const mcap::Bytes a = record(small_scenario("small", 7), {}).file;
  const mcap::Bytes b =
      rewritten(a, on<wire::Sense>(TopicId::Sense, 70, [](wire::Sense& sense) { sense.round(9999); }));
  EXPECT_EQ(text_of(compare_files(a, b)), "different: round 70, agent 1, skein/sense: the sample is only in A");
}

TEST(Verify, DoesNotCompareWhatDiffersBetweenRuns) {
  const mcap::Bytes a = record(small_scenario("small", 7), {}).file;
  const mcap::Bytes b = rewritten(a, [](TopicId topic, Bytes& payload) {
    const auto other = [](auto sample) {
      sample.head().run(77);
      sample.head().stamp_ns(sample.head().stamp_ns() + 5);
      return sample;
    };
    if (topic == TopicId::Tick) {
      auto tick = other(from_cdr<wire::Tick>(payload).value());
      for (auto& entry : tick.roster()) entry.nonce(entry.nonce() + 1);
      payload = to_cdr(tick);
    } else if (topic == TopicId::Beacon) {
      auto beacon = other(from_cdr<wire::Beacon>(payload).value());
      beacon.nonce(beacon.nonce() + 1);
      payload = to_cdr(beacon);
    } else if (topic == TopicId::Mission) {
      payload = to_cdr(other(from_cdr<wire::Mission>(payload).value()));
    } else if (topic == TopicId::Sense) {
      payload = to_cdr(other(from_cdr<wire::Sense>(payload).value()));
    } else {
      payload = to_cdr(other(from_cdr<wire::Representative>(payload).value()));
    }
  });
  EXPECT_EQ(text_of(compare_files(a, b)), text_of(compare_files(a, a)));
}

TEST(Verify, ARecordedRunWithLossesAndReturnsRunsAgain) {
  for (const bool with_report : {true, false}) {
    InProcessOptions options;
    for (const char* fault : {"restart:2@plan:6", "kill:1@fly:40", "restart:2@fly:60"}) {
      options.faults.push_back(*parse_fault(fault).fault);
    }
    const Scenario scenario = small_scenario("small", 7);
    mcap::Bytes file = record(scenario, options).file;
    if (!with_report) file.resize(file.size() - 6000);  // cut: no report, no summary
    const mcap::Reader reader(file);
    const RecordedRun run = run_of(reader);
    EXPECT_EQ(reader.missing().empty(), with_report);
    ASSERT_GE(run.roster_changes().size(), 3U);
    EXPECT_EQ(scenario_of(reader).scenario_hash, scenario.scenario_hash);
    const RecordedRun again = rerun(reader, run, {});
    const Comparison comparison = compare(run, again, with_report ? UINT32_MAX : run.last_round());
    EXPECT_FALSE(comparison.difference) << text_of(comparison);
    EXPECT_GT(comparison.rounds, 80U);
  }
}

/// As a recorder of a swarm over DDS has it: what was injected is a sample, and ticks answer it for some time.
mcap::Bytes with_inject(const Scenario& scenario, const InjectedAt& injected) {
  mcap::Bytes file;
  Recording recording([&](mcap::ByteView bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); },
                      {"attached", "geese", &scenario, false});
  InProcessOptions options;
  options.injections = {injected};
  options.tap = tap_into([&](const TakenSample& sample) {
    auto tick = sample.topic == TopicId::Tick ? from_cdr<wire::Tick>(sample.payload) : std::nullopt;
    if (!tick || tick->round() < injected.round || tick->round() > injected.round + 20) return recording.add(sample);
    const std::uint64_t run = tick->head().run();
    const Bytes inject = to_cdr(to_wire(Inject{run, injected.injection, 1.0}, Stamp{}));
    recording.add({TopicId::Inject, false, 0, inject});
    recording.add(
        {TopicId::Inject, false, 0, to_cdr(to_wire(Inject{run + 1, {.id = 3, .radius_m = 9.0}, 1.0}, Stamp{}))});
    for (const std::uint64_t id : {injected.injection.id, std::uint64_t{3}, std::uint64_t{4}}) {
      wire::Answered answer;
      answer.id(id);
      answer.result(static_cast<std::uint8_t>(OrderResult::Accepted));
      answer.round(injected.round);
      tick->answers().push_back(answer);
    }
    recording.add({TopicId::Tick, true, 0, to_cdr(*tick)});
  });
  (void)run_in_process(scenario, options);
  recording.finish({});
  return file;
}

TEST(Verify, AnInjectedObstacleRunsAgainWithoutAReport) {
  const Scenario scenario = small_scenario("small", 7);
  const InjectedAt injected{60, {.id = 77, .position_m = {4000.0, 0.0, 0.0}, .radius_m = 50.0}};
  const mcap::Bytes file = with_inject(scenario, injected);
  const mcap::Reader reader(file);
  const RecordedRun run = run_of(reader);
  EXPECT_THAT(run.injections(), ::testing::ElementsAre(injected));
  EXPECT_TRUE(compare(run, run_of(mcap::Reader(record(scenario, {}).file))).difference) << "it changes nothing";
  const Comparison comparison = compare(run, rerun(reader, run, {}));
  EXPECT_FALSE(comparison.difference) << text_of(comparison);
  EXPECT_GT(comparison.rounds, 80U);
}

TEST(Verify, ARecordingWithoutScenarioCannotRunAgain) {
  const mcap::Bytes file = rewritten(record(small_scenario("small", 7), {}).file, [](TopicId, Bytes&) {});
  const mcap::Reader reader(file);
  try {
    (void)rerun(reader, run_of(reader), {});
    ADD_FAILURE() << "it ran";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("skein record SCENARIO"));
  }
}

}  // namespace
}  // namespace skein
