#include "idl/bus/dds_participant.hpp"

#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#include <algorithm>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <stdexcept>

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__  // as g++ says it
#endif
#endif
#ifdef __SANITIZE_ADDRESS__
// Fast DDS 2.9.1 deletes its own writers' statistics through a base without a virtual destructor; nothing of ours does.
extern "C" const char* __asan_default_options() {
  return "new_delete_type_mismatch=0";
}
#endif
#ifdef __SANITIZE_THREAD__
// It also unlocks what was destroyed and orders its locks both ways; data races are reported wherever they are.
extern "C" const char* __tsan_default_suppressions() {
  return "mutex:libfastrtps.so\ndeadlock:libfastrtps.so\n";
}
#endif

namespace skein::bus {
namespace {

using eprosima::fastrtps::rtps::ParticipantDiscoveryInfo;
using eprosima::fastrtps::rtps::ReaderDiscoveryInfo;
using eprosima::fastrtps::rtps::WriterDiscoveryInfo;

constexpr std::uint32_t kMaxDomain = 232;  // the ports of higher ones do not fit 16 bits
constexpr std::size_t kMaxSwarmName = 64;

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

void require_legal(const DdsConfig& config) {
  if (config.domain > kMaxDomain) {
    throw std::invalid_argument("domain is " + std::to_string(config.domain) + "; allowed: 0 to 232");
  }
  // partitions expand wildcards: a swarm called '*' would hear everybody
  if (config.swarm.empty() || config.swarm.size() > kMaxSwarmName ||
      !std::ranges::all_of(config.swarm, is_name_character)) {
    throw std::invalid_argument("swarm is '" + config.swarm + "'; allowed: 1 to 64 letters, digits, - and _");
  }
  if (!(config.lease_s >= 1.0 && config.lease_s <= 3600.0)) {
    throw std::invalid_argument("lease_s is " + std::to_string(config.lease_s) + "; allowed: 1 to 3600 s");
  }
}

template <typename Entity>
Entity* require_made(Entity* entity, const char* what) {
  if (entity == nullptr) throw std::runtime_error(std::string("DDS cannot make ") + what);
  return entity;
}

}  // namespace

double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ProcessKey process_key(const eprosima::fastrtps::rtps::GUID_t& guid) {
  ProcessKey key;
  std::copy_n(guid.guidPrefix.value, key.size(), key.begin());
  return key;
}

std::string sense_partition(const std::string& swarm, AgentId agent) {
  return swarm + "/sense/" + std::to_string(agent);
}

void Participant::Listener::on_participant_discovery(fdds::DomainParticipant*, ParticipantDiscoveryInfo&& info) {
  const ProcessKey process = process_key(info.info.m_guid);
  const bool lost = info.status == ParticipantDiscoveryInfo::REMOVED_PARTICIPANT ||
                    info.status == ParticipantDiscoveryInfo::DROPPED_PARTICIPANT;
  if (lost) {
    book_.gone(process);
  } else {
    const auto& data = info.info.m_userData;
    book_.discovered(process, peer_info_from(std::string(data.begin(), data.end())));
  }
  wake_.ring();
}

template <typename Endpoint>
void Participant::Listener::note(const Endpoint& endpoint, bool own_writes, bool is_there) {
  const auto spec = std::ranges::find_if(kTopics, [&](const TopicSpec& known) {
    return endpoint.topicName() == known.name.data() && endpoint.typeName() == known.type.data();
  });
  if (spec == kTopics.end()) return;
  const auto is_own = [&](const std::string& name) {
    return std::ranges::find(partitions_, name) != partitions_.end();
  };
  if (std::ranges::none_of(endpoint.m_qos.m_partition.getNames(), is_own)) return;
  book_.found(process_key(endpoint.guid()), endpoint.guid().entityId.to_uint32(), endpoint_bit(spec->id, own_writes),
              is_there, monotonic_s());
  wake_.ring();
}

void Participant::Listener::on_subscriber_discovery(fdds::DomainParticipant*, ReaderDiscoveryInfo&& info) {
  note(info.info, true, info.status != ReaderDiscoveryInfo::REMOVED_READER);
}

void Participant::Listener::on_publisher_discovery(fdds::DomainParticipant*, WriterDiscoveryInfo&& info) {
  note(info.info, false, info.status != WriterDiscoveryInfo::REMOVED_WRITER);
}

Participant::Participant(const DdsConfig& config, std::vector<std::string> partitions, PeerBook& book, const Wake& wake)
    : listener_(std::move(partitions), book, wake) {
  require_legal(config);
  auto* factory = fdds::DomainParticipantFactory::get_instance();
  factory->load_profiles();  // before the defaults are read, or they would overwrite what apply() sets
  fdds::DomainParticipantQos qos = factory->get_default_participant_qos();
  apply(config, book.own(), qos);
  participant_ = require_made(factory->create_participant(config.domain, qos, &listener_, fdds::StatusMask::none()),
                              "a participant");
}

Participant::~Participant() {
  participant_->set_listener(nullptr);
  participant_->delete_contained_entities();
  fdds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

fdds::Topic* Participant::topic(const TopicSpec& spec, const fdds::TypeSupport& type) {
  const std::string name(spec.name);
  if (fdds::TopicDescription* known = participant_->lookup_topicdescription(name)) {
    return dynamic_cast<fdds::Topic*>(known);
  }
  if (type.get_type_name() != spec.type) throw std::logic_error("the topic table names another type for " + name);
  type.register_type(participant_);
  return require_made(participant_->create_topic(name, std::string(spec.type), fdds::TOPIC_QOS_DEFAULT), "a topic");
}

fdds::Publisher* Participant::publisher(const std::string& partition) {
  fdds::PublisherQos qos = participant_->get_default_publisher_qos();
  qos.partition().clear();
  qos.partition().push_back(partition.c_str());
  return require_made(participant_->create_publisher(qos), "a publisher");
}

fdds::Subscriber* Participant::subscriber(const std::vector<std::string>& partitions) {
  fdds::SubscriberQos qos = participant_->get_default_subscriber_qos();
  qos.partition().clear();
  for (const std::string& partition : partitions) qos.partition().push_back(partition.c_str());
  return require_made(participant_->create_subscriber(qos), "a subscriber");
}

}  // namespace skein::bus
