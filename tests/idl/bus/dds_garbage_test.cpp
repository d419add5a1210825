// Bytes that are no sample, sent by a foreign DDS program under our names, end nobody and hide nothing.
#include <gtest/gtest.h>

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <array>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <memory>

#include "idl/bus/topics.hpp"
#include "idl/convert/cdr.hpp"
#include "tests/idl/bus/waiting.hpp"

namespace skein::bus {
namespace {

namespace fdds = eprosima::fastdds::dds;
using eprosima::fastrtps::rtps::InstanceHandle_t;
using eprosima::fastrtps::rtps::SerializedPayload_t;

/// Writes bytes as they are.
class RawType final : public fdds::TopicDataType {
 public:
  explicit RawType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = 4096;
    m_isGetKeyDefined = name != "skein::v7::Tick";
  }
  bool serialize(void* data, SerializedPayload_t* payload) override {
    const auto& bytes = *static_cast<Bytes*>(data);
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    return true;
  }
  bool deserialize(SerializedPayload_t*, void*) override { return false; }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<Bytes*>(data)->size()); };
  }
  void* createData() override { return new Bytes(); }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void*, InstanceHandle_t* handle, bool) override {
    handle->value[3] = 1;
    return m_isGetKeyDefined;
  }
};

/// A foreign participant with one raw writer.
class Vandal {
 public:
  Vandal(const std::string& swarm, const TopicSpec& spec) {
    fdds::DomainParticipantQos participant_qos;
    participant_qos.transport().use_builtin_transports = false;
    participant_qos.transport().user_transports.push_back(
        std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>());
    participant_ =
        fdds::DomainParticipantFactory::get_instance()->create_participant(testing::kDomain, participant_qos);
    const std::string type(spec.type);
    fdds::TypeSupport(new RawType(type)).register_type(participant_);
    fdds::PublisherQos group;
    group.partition().push_back(swarm.c_str());
    auto* topic = participant_->create_topic(std::string(spec.name), type, fdds::TOPIC_QOS_DEFAULT);
    auto* publisher = participant_->create_publisher(group);
    fdds::DataWriterQos qos;
    qos.reliability().kind = fdds::RELIABLE_RELIABILITY_QOS;
    qos.data_sharing().off();
    writer_ = publisher->create_datawriter(topic, qos);
  }
  ~Vandal() {
    participant_->delete_contained_entities();
    fdds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  Vandal(const Vandal&) = delete;
  Vandal& operator=(const Vandal&) = delete;

  bool is_heard() const {
    fdds::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return status.current_count > 0;
  }
  void write(Bytes bytes) { EXPECT_TRUE(writer_->write(&bytes)); }
  void flush() { writer_->wait_for_acknowledgments(eprosima::fastrtps::Duration_t(10, 0)); }

 private:
  fdds::DomainParticipant* participant_;
  fdds::DataWriter* writer_;
};

/// Each valid prefix, a wrong encapsulation, and the sample with every byte set to 0xff in turn.
std::vector<Bytes> vandalised(const Bytes& valid) {
  std::vector<Bytes> all;
  for (std::size_t size = 1; size < valid.size(); size += 7)
    all.emplace_back(valid.begin(), valid.begin() + long(size));
  for (std::size_t i = 0; i < valid.size(); ++i) {
    all.push_back(valid);
    all.back()[i] = 0xff;
  }
  return all;
}

DdsConfig config(const std::string& swarm, AgentId id) {
  DdsConfig c;
  c.domain = testing::kDomain;
  c.swarm = swarm;
  c.id = id;
  c.nonce = 1000 + id;
  return c;
}

constexpr std::array<AgentId, 1> kOne{1};

TEST(Garbage, TicksThatAreNoneDoNotStopTheTrueOnes) {
  const std::string swarm = testing::unique_swarm("GarbageTicks");
  DdsWorldPort world(config(swarm, 0), kOne);
  DdsAgentPort agent(config(swarm, 1));
  Vandal vandal(swarm, topic(TopicId::Tick));
  testing::AtAgent at{agent};
  ASSERT_TRUE(testing::eventually({agent.wake_fd()}, [&] {
    return vandal.is_heard() && world.matched().size() == 1 && agent.matched().size() == 1;
  }));
  for (const Bytes& bytes : vandalised(to_cdr(testing::tick(1)))) vandal.write(bytes);
  vandal.flush();
  world.publish(testing::tick(123456));
  EXPECT_TRUE(testing::eventually({agent.wake_fd()}, [&] {
    const auto ticks = at.all<wire::Tick>();
    return !ticks.empty() && ticks.back().round() == 123456;
  }));
}

TEST(Garbage, BeaconsWithBadBooleansAndLengthsDoNotStopTheTrueOnes) {
  const std::string swarm = testing::unique_swarm("GarbageBeacons");
  DdsWorldPort world(config(swarm, 0), kOne);
  DdsAgentPort agent(config(swarm, 1));
  Vandal vandal(swarm, topic(TopicId::Beacon));
  testing::AtWorld at{world};
  ASSERT_TRUE(testing::eventually({world.wake_fd()}, [&] {
    return vandal.is_heard() && world.matched().size() == 1 && agent.matched().size() == 1;
  }));
  for (const Bytes& bytes : vandalised(to_cdr(testing::beacon(1, 1)))) vandal.write(bytes);
  vandal.flush();
  agent.publish(testing::beacon(1, 123456));
  EXPECT_TRUE(testing::eventually({world.wake_fd()}, [&] {
    const auto beacons = at.all<wire::Beacon>();
    return std::ranges::any_of(beacons, [](const wire::Beacon& beacon) { return beacon.round() == 123456; });
  }));
}

}  // namespace
}  // namespace skein::bus
