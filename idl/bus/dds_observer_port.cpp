#include "idl/bus/dds_observer_port.hpp"

#include <algorithm>

#include "idl/bus/dds_endpoint.hpp"
#include "idl/bus/memory_bus.hpp"

namespace skein::bus {
namespace {

PeerInfo self(const DdsConfig& config) {
  return {Role::Observer, config.swarm, kWorldId, config.nonce, config.wire_version, config.start_stamp_ns};
}

DdsConfig as_anybody(DdsConfig config) {
  config.swarm = "skein";  // in no partition: any legal name will do
  return config;
}

// Members end in the opposite order: endpoints, then the participant.
struct Endpoints {
  Endpoints(const DdsConfig& config, PeerBook& book, const Wake& wake, Inbox<ObserverInbound>& inbox)
      : participant(config, {config.swarm}, book, wake),
        subscriber(participant.subscriber({config.swarm})),
        mission(participant, subscriber, book, wake, inbox, Ring::Now),
        tick(participant, subscriber, book, wake, inbox, Ring::Now),
        beacon(participant, subscriber, book, wake, inbox, Ring::Silent) {}

  Participant participant;
  fdds::Subscriber* subscriber;
  Reader<wire::Mission, ObserverInbound> mission;
  Reader<wire::Tick, ObserverInbound> tick;
  Reader<wire::Beacon, ObserverInbound> beacon;
};

}  // namespace

// Members end in the opposite order: what is on the bus, then what its listeners use.
struct DdsObserverPort::Impl {
  explicit Impl(const DdsConfig& own_config) : config(own_config), book(self(config)) {
    bus.emplace(config, book, wake, inbox);
  }

  const DdsConfig config;
  Wake wake;
  PeerBook book;
  Inbox<ObserverInbound> inbox{kInboxBound, wake};
  std::optional<Endpoints> bus;
};

DdsObserverPort::DdsObserverPort(const DdsConfig& config) : impl_(std::make_unique<Impl>(config)) {}
DdsObserverPort::~DdsObserverPort() = default;

void DdsObserverPort::take(std::vector<ObserverInbound>& into) {
  impl_->inbox.drain(into);
}

void DdsObserverPort::renew() {
  impl_->bus.reset();
  impl_->book.renew();
  impl_->bus.emplace(impl_->config, impl_->book, impl_->wake, impl_->inbox);
  impl_->wake.ring();
}

int DdsObserverPort::wake_fd() const {
  return impl_->wake.fd();
}

bool DdsObserverPort::has_world() const {
  return std::ranges::binary_search(impl_->book.swarms(true), impl_->book.own().swarm);
}

struct DdsSwarmFinder::Impl {
  explicit Impl(const DdsConfig& own_config) : config(own_config), book(self(config)) { join(); }
  void join() { participant.emplace(config, std::vector<std::string>(), book, wake); }

  const DdsConfig config;
  Wake wake;
  PeerBook book;
  std::optional<Participant> participant;
};

DdsSwarmFinder::DdsSwarmFinder(DdsConfig config) : impl_(std::make_unique<Impl>(as_anybody(std::move(config)))) {}
DdsSwarmFinder::~DdsSwarmFinder() = default;

std::vector<std::string> DdsSwarmFinder::swarms() const {
  impl_->wake.clear();
  return impl_->book.swarms(false);
}

void DdsSwarmFinder::renew() {
  impl_->participant.reset();
  impl_->book.renew();
  impl_->join();
}

int DdsSwarmFinder::wake_fd() const {
  return impl_->wake.fd();
}

}  // namespace skein::bus
