#include "idl/bus/dds_qos.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>

#include <cmath>
#include <memory>

namespace skein::bus {
namespace {

namespace frtps = eprosima::fastdds::rtps;
using eprosima::fastrtps::Duration_t;

constexpr std::uint32_t kSocketBuffer = 4U << 20;  // bytes
constexpr std::int32_t kInstances = static_cast<std::int32_t>(kMaxAgents) + 2;

void set_transports(Profile profile, fdds::DomainParticipantQos& qos) {
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.clear();
  const auto udp = std::make_shared<frtps::UDPv4TransportDescriptor>();
  udp->sendBufferSize = kSocketBuffer;
  udp->receiveBufferSize = kSocketBuffer;
  if (profile == Profile::Shm) {
    qos.transport().user_transports.push_back(std::make_shared<frtps::SharedMemTransportDescriptor>());
  }
  qos.transport().user_transports.push_back(udp);
  qos.transport().send_socket_buffer_size = kSocketBuffer;
  qos.transport().listen_socket_buffer_size = kSocketBuffer;
}

void set_bounds(const TopicSpec& spec, fdds::HistoryQosPolicy& history, fdds::ResourceLimitsQosPolicy& limits) {
  history.kind = fdds::KEEP_LAST_HISTORY_QOS;
  history.depth = spec.depth;
  limits.max_instances = kInstances;
  limits.max_samples_per_instance = spec.depth;
  limits.max_samples = (spec.keyed ? kInstances : 1) * spec.depth;
  limits.allocated_samples = spec.depth;
}

}  // namespace

void apply(const DdsConfig& config, const PeerInfo& own, fdds::DomainParticipantQos& qos) {
  const std::string text = to_text(own);
  qos.user_data().setValue({text.begin(), text.end()});
  qos.name(own.role == Role::World   ? "skein world"
           : own.role == Role::Agent ? "skein agent " + std::to_string(own.id)
                                     : "skein observer");
  auto& builtin = qos.wire_protocol().builtin;
  builtin.mutation_tries = 250;  // a swarm needs more ports than the stock 100 tries find
  auto& discovery = builtin.discovery_config;
  const double whole_s = std::floor(config.lease_s);
  discovery.leaseDuration =
      Duration_t(static_cast<std::int32_t>(whole_s), static_cast<std::uint32_t>((config.lease_s - whole_s) * 1e9));
  discovery.leaseDuration_announcementperiod = Duration_t(config.lease_s < 3.0 ? 0.25 : 1.0);
  discovery.initial_announcements.count = 10;
  discovery.initial_announcements.period = Duration_t(0.05);
  set_transports(config.profile, qos);
}

void apply(const TopicSpec& spec, fdds::DataWriterQos& qos) {
  qos.reliability().kind = fdds::RELIABLE_RELIABILITY_QOS;
  qos.reliability().max_blocking_time = Duration_t(5, 0);  // for a lock on a busy machine; KEEP_LAST never waits else
  qos.durability().kind = spec.latched ? fdds::TRANSIENT_LOCAL_DURABILITY_QOS : fdds::VOLATILE_DURABILITY_QOS;
  set_bounds(spec, qos.history(), qos.resource_limits());
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  qos.publish_mode().kind = fdds::SYNCHRONOUS_PUBLISH_MODE;
  qos.data_sharing().off();
  qos.reliable_writer_qos().disable_heartbeat_piggyback = true;
  qos.reliable_writer_qos().times.heartbeatPeriod = Duration_t(spec.heartbeat_s);
}

void apply(const TopicSpec& spec, fdds::DataReaderQos& qos) {
  qos.reliability().kind = fdds::RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = spec.latched ? fdds::TRANSIENT_LOCAL_DURABILITY_QOS : fdds::VOLATILE_DURABILITY_QOS;
  set_bounds(spec, qos.history(), qos.resource_limits());
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  qos.data_sharing().off();
}

}  // namespace skein::bus
