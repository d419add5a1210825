// A recorder hears every topic as bytes: those that the types would write, numbered by their writers.
#include "idl/bus/dds_recorder_port.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "idl/convert/cdr.hpp"
#include "tests/idl/bus/waiting.hpp"

namespace skein::bus {
namespace {

using testing::eventually;

constexpr std::array<AgentId, 2> kTwo{1, 2};
constexpr std::uint32_t kReliable = 21;  ///< domains
constexpr std::uint32_t kBestEffort = 22;

DdsConfig config(std::uint32_t domain, AgentId id) {
  DdsConfig c;
  c.domain = domain;
  c.swarm = testing::unique_swarm("recorded");
  c.id = id;
  c.nonce = 2000 + id;
  c.start_stamp_ns = 500;
  return c;
}

struct Swarm {
  explicit Swarm(std::uint32_t domain, RecorderReads reads)
      : world(config(domain, 0), kTwo), agent(config(domain, 2)), recorder(config(domain, 99), reads) {}

  /// Takes until `holds`.
  template <typename Condition>
  bool takes_until(Condition holds) {
    return eventually({recorder.wake_fd(), world.wake_fd(), agent.wake_fd()}, [&] {
      recorder.take(taken);
      return holds();
    });
  }
  [[nodiscard]] std::vector<RawSample> of(TopicId topic) const {
    std::vector<RawSample> found;
    std::ranges::copy_if(taken, std::back_inserter(found), [&](const auto& sample) { return sample.topic == topic; });
    return found;
  }
  /// Publishes until the recorder hears all writers, but the mission's: its readers are known to them then.
  bool is_heard() {
    std::uint32_t round = 1000;
    return takes_until([&] {
      world.publish(testing::tick(++round));
      world.publish(testing::sense(2));
      world.publish(testing::representative(1));
      agent.publish(testing::beacon(2, round));
      agent.publish(testing::representative(2));
      agent.publish(testing::obstacle_map(2));
      std::set<std::pair<TopicId, WriterKey>> heard;
      for (const RawSample& sample : taken) {
        if (sample.topic != TopicId::Mission) heard.emplace(sample.topic, sample.writer);
      }
      return heard.size() == 6;
    });
  }

  DdsWorldPort world;
  DdsAgentPort agent;
  DdsRecorderPort recorder;
  std::vector<RawSample> taken;
};

TEST(DdsRecorder, HearsAllTopicsAsTheBytesThatTheTypesWrite) {
  Swarm swarm(kReliable, {true});
  swarm.world.publish(to_wire(examples::mission(), examples::kStamp));  // before it is there: latched
  ASSERT_TRUE(swarm.is_heard());
  EXPECT_TRUE(swarm.recorder.has_world());
  ASSERT_TRUE(swarm.takes_until([&] { return !swarm.of(TopicId::Mission).empty(); }));
  EXPECT_EQ(swarm.of(TopicId::Mission)[0].payload, to_cdr(to_wire(examples::mission(), examples::kStamp)));
  EXPECT_EQ(swarm.of(TopicId::Sense)[0].payload, to_cdr(testing::sense(2)));
  EXPECT_EQ(swarm.of(TopicId::ObstacleMap)[0].payload, to_cdr(testing::obstacle_map(2)));
  std::vector<Bytes> representatives;
  for (const RawSample& sample : swarm.of(TopicId::Representative)) representatives.push_back(sample.payload);
  EXPECT_THAT(representatives, ::testing::Contains(to_cdr(testing::representative(1))));
  EXPECT_THAT(representatives, ::testing::Contains(to_cdr(testing::representative(2))));
  const std::uint32_t round = from_cdr<wire::Tick>(swarm.of(TopicId::Tick)[0].payload).value().round();
  EXPECT_EQ(swarm.of(TopicId::Tick)[0].payload, to_cdr(testing::tick(round)));
}

TEST(DdsRecorder, NumbersAWritersSamplesOneByOne) {
  Swarm swarm(kReliable, {true});
  ASSERT_TRUE(swarm.is_heard());
  for (std::uint32_t round = 1; round <= 10; ++round) swarm.agent.publish(testing::beacon(2, round));
  ASSERT_TRUE(swarm.takes_until([&] {
    const auto beacons = swarm.of(TopicId::Beacon);
    return !beacons.empty() && beacons.back().payload == to_cdr(testing::beacon(2, 10));
  }));
  std::uint64_t last = 0;
  for (const RawSample& beacon : swarm.of(TopicId::Beacon)) {
    EXPECT_EQ(beacon.sequence, last == 0 ? beacon.sequence : last + 1);
    last = beacon.sequence;
  }
}

TEST(DdsRecorder, AFullInboxLosesTheOldestAndTheNumbersTell) {
  Swarm swarm(kBestEffort, {false, 6});
  ASSERT_TRUE(swarm.is_heard());
  const std::uint64_t before = swarm.of(TopicId::Beacon).back().sequence;
  for (std::uint32_t round = 1; round <= 50; ++round) swarm.agent.publish(testing::beacon(2, round));
  swarm.taken.clear();
  ASSERT_TRUE(swarm.takes_until([&] {
    const auto beacons = swarm.of(TopicId::Beacon);
    return !beacons.empty() && beacons.back().payload == to_cdr(testing::beacon(2, 50));
  }));
  const auto beacons = swarm.of(TopicId::Beacon);
  EXPECT_GE(beacons.back().sequence - before, 50U);
  EXPECT_LT(beacons.size(), 50U);
}

TEST(DdsRecorder, MadeAnewKeepsWhatHadArrivedAndHearsOn) {
  Swarm swarm(kReliable, {true});
  ASSERT_TRUE(swarm.is_heard());
  swarm.agent.publish(testing::beacon(2, 1));
  ASSERT_TRUE(swarm.agent.flush(std::chrono::seconds(10)));
  swarm.recorder.renew();
  swarm.recorder.take(swarm.taken);
  const RawSample before = swarm.of(TopicId::Beacon).back();
  EXPECT_EQ(before.payload, to_cdr(testing::beacon(2, 1)));
  swarm.taken.clear();
  ASSERT_TRUE(swarm.is_heard());
  EXPECT_TRUE(swarm.recorder.has_world());
  const RawSample after = swarm.of(TopicId::Beacon).front();
  EXPECT_EQ(after.writer, before.writer);
  EXPECT_GT(after.sequence, before.sequence);
}

}  // namespace
}  // namespace skein::bus
