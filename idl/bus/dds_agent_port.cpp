#include <stdexcept>

#include "idl/bus/dds_endpoint.hpp"
#include "idl/bus/dds_port.hpp"
#include "idl/bus/memory_bus.hpp"

namespace skein::bus {
namespace {

PeerInfo self(const DdsConfig& config) {
  if (config.id < 1 || config.id > kMaxAgents) {
    throw std::invalid_argument("agent id " + std::to_string(config.id) + " is not in 1 to " +
                                std::to_string(kMaxAgents));
  }
  return {Role::Agent, config.swarm, config.id, config.nonce, config.wire_version, config.start_stamp_ns};
}

}  // namespace

// Members end in the opposite order: endpoints, then the participant, then what its listeners use.
struct DdsAgentPort::Impl {
  explicit Impl(const DdsConfig& config)
      : book(self(config)),
        participant(config, {config.swarm, sense_partition(config.swarm, config.id)}, book, wake),
        publisher(participant.publisher(config.swarm)),
        subscriber(participant.subscriber(config.swarm)),
        own_subscriber(participant.subscriber(sense_partition(config.swarm, config.id))),
        mission(participant, subscriber, book, wake, inbox),
        tick(participant, subscriber, book, wake, inbox),
        sense(participant, own_subscriber, book, wake, inbox),
        representative_in(participant, subscriber, book, wake, inbox),
        representative_out(participant, publisher, book, wake),
        beacon(participant, publisher, book, wake) {}

  Wake wake;
  PeerBook book;
  Inbox<AgentInbound> inbox{kInboxBound, wake};
  std::uint64_t refused_by_dds = 0;
  Participant participant;
  fdds::Publisher* publisher;
  fdds::Subscriber* subscriber;
  fdds::Subscriber* own_subscriber;
  Reader<wire::Mission, AgentInbound> mission;
  Reader<wire::Tick, AgentInbound> tick;
  Reader<wire::Sense, AgentInbound> sense;
  Reader<wire::Representative, AgentInbound> representative_in;
  Writer<wire::Representative> representative_out;
  Writer<wire::Beacon> beacon;
};

DdsAgentPort::DdsAgentPort(const DdsConfig& config) : impl_(std::make_unique<Impl>(config)) {}
DdsAgentPort::~DdsAgentPort() = default;

void DdsAgentPort::publish(const AgentOutbound& sample) {
  const auto* beacon = std::get_if<wire::Beacon>(&sample);
  const bool accepted = beacon != nullptr ? impl_->beacon.write(*beacon)
                                          : impl_->representative_out.write(std::get<wire::Representative>(sample));
  if (!accepted) ++impl_->refused_by_dds;
}

void DdsAgentPort::take(std::vector<AgentInbound>& into) {
  impl_->inbox.drain(into);
}

std::vector<std::uint64_t> DdsAgentPort::matched() const {
  return impl_->book.matched_nonces(monotonic_s());
}

int DdsAgentPort::wake_fd() const {
  return impl_->wake.fd();
}

bool DdsAgentPort::flush(std::chrono::milliseconds limit) {
  const Deadline deadline(limit);
  return impl_->representative_out.flush(deadline.left_s()) && impl_->beacon.flush(deadline.left_s());
}

std::optional<std::string> DdsAgentPort::conflict() const {
  return impl_->book.conflict();
}

std::uint64_t DdsAgentPort::lost() const {
  return impl_->inbox.lost() + impl_->refused_by_dds;
}

}  // namespace skein::bus
