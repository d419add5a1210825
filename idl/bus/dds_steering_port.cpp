#include "idl/bus/dds_steering_port.hpp"

#include <algorithm>
#include <bit>

#include "idl/bus/dds_endpoint.hpp"
#include "idl/bus/memory_bus.hpp"

namespace skein::bus {
namespace {

PeerInfo self(const DdsConfig& config) {
  return {Role::Observer, config.swarm, kWorldId, config.nonce, config.wire_version, config.start_stamp_ns};
}

}  // namespace

// Members end in the opposite order: what is on the bus, then what its listeners use.
struct DdsSteeringPort::Impl {
  explicit Impl(const DdsConfig& config)
      : book(self(config)),
        participant(config, {config.swarm}, book, wake),
        subscriber(participant.subscriber({config.swarm})),
        publisher(participant.publisher(config.swarm)),
        mission(participant, subscriber, book, wake, inbox, Ring::Now),
        tick(participant, subscriber, book, wake, inbox, Ring::Now),
        beacon(participant, subscriber, book, wake, inbox, Ring::Now),
        command(participant, publisher, book, wake),
        inject(participant, publisher, book, wake) {}

  [[nodiscard]] bool is_read(TopicId topic) const {
    const auto bit = static_cast<std::size_t>(std::countr_zero(endpoint_bit(topic, true)));
    return book.endpoints(participant.key())[bit] > 0;
  }

  Wake wake;
  PeerBook book;
  Inbox<ObserverInbound> inbox{kInboxBound, wake};
  Participant participant;
  fdds::Subscriber* subscriber;
  fdds::Publisher* publisher;
  Reader<wire::Mission, ObserverInbound> mission;
  Reader<wire::Tick, ObserverInbound> tick;
  Reader<wire::Beacon, ObserverInbound> beacon;
  Writer<wire::Command> command;
  Writer<wire::Inject> inject;
};

DdsSteeringPort::DdsSteeringPort(const DdsConfig& config) : impl_(std::make_unique<Impl>(config)) {}
DdsSteeringPort::~DdsSteeringPort() = default;

bool DdsSteeringPort::publish(const wire::Command& sample) {
  return impl_->command.write(sample);
}

bool DdsSteeringPort::publish(const wire::Inject& sample) {
  return impl_->inject.write(sample);
}

void DdsSteeringPort::take(std::vector<ObserverInbound>& into) {
  impl_->inbox.drain(into);
}

int DdsSteeringPort::wake_fd() const {
  return impl_->wake.fd();
}

bool DdsSteeringPort::ready() const {
  const bool has_world = std::ranges::binary_search(impl_->book.swarms(true), impl_->book.own().swarm);
  return has_world && impl_->is_read(TopicId::Command) && impl_->is_read(TopicId::Inject);
}

std::optional<std::string> DdsSteeringPort::conflict() const {
  return impl_->book.conflict();
}

}  // namespace skein::bus
