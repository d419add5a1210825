// From the topic table to the QoS of Fast DDS, and the QoS of a participant. Internal to idl/bus.
//
// Heartbeats by period (idl/bus/topics.hpp) instead of one with each sample, and bounds from kMaxAgents (the stock 10
// instances silently stop a reader at ten agents). Data sharing is off everywhere: it would leave files in /dev/shm.
#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>

#include "idl/bus/dds_port.hpp"
#include "idl/bus/peer_info.hpp"

namespace skein::bus {

namespace fdds = eprosima::fastdds::dds;

/// Overrides what the protocol relies on; the rest stays as the loaded profiles say.
void apply(const DdsConfig& config, const PeerInfo& own, fdds::DomainParticipantQos& qos);
void apply(const TopicSpec& spec, fdds::DataWriterQos& qos);
void apply(const TopicSpec& spec, fdds::DataReaderQos& qos);

}  // namespace skein::bus
