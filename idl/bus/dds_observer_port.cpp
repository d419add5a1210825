#include "idl/bus/dds_observer_port.hpp"

#include <algorithm>

#include "idl/bus/dds_endpoint.hpp"
#include "idl/bus/memory_bus.hpp"

namespace skein::bus {
namespace {

PeerInfo self(const DdsConfig& config) {
  return {Role::Observer, config.swarm, kWorldId, config.nonce, config.wire_version, config.start_stamp_ns};
}

/// Where the topics of a swarm are, those of each agent among them.
std::vector<std::string> partitions_of(const std::string& swarm) {
  std::vector<std::string> partitions{swarm};
  for (AgentId agent = 1; agent <= kMaxAgents; ++agent) partitions.push_back(sense_partition(swarm, agent));
  return partitions;
}

DdsConfig as_anybody(DdsConfig config) {
  config.swarm = "skein";  // in no partition: any legal name will do
  return config;
}

// Members end in the opposite order: endpoints, then the participant.
struct Endpoints {
  Endpoints(const DdsConfig& config, Observed what, PeerBook& book, const Wake& wake, Inbox<ObserverInbound>& inbox)
      : participant(config, partitions_of(config.swarm), book, wake),
        subscriber(participant.subscriber({config.swarm})),
        mission(participant, subscriber, book, wake, inbox, Ring::Now),
        tick(participant, subscriber, book, wake, inbox, Ring::Now),
        beacon(participant, subscriber, book, wake, inbox, Ring::Silent) {
    if (what == Observed::Progress) return;
    representative.emplace(participant, subscriber, book, wake, inbox, Ring::Silent);
    obstacle_map.emplace(participant, subscriber, book, wake, inbox, Ring::Silent);
  }

  Participant participant;
  fdds::Subscriber* subscriber;
  Reader<wire::Mission, ObserverInbound> mission;
  Reader<wire::Tick, ObserverInbound> tick;
  Reader<wire::Beacon, ObserverInbound> beacon;
  std::optional<Reader<wire::Representative, ObserverInbound>> representative;
  std::optional<Reader<wire::ObstacleMap, ObserverInbound>> obstacle_map;
};

}  // namespace

// Members end in the opposite order: what is on the bus, then what its listeners use.
struct DdsObserverPort::Impl {
  Impl(const DdsConfig& own_config, Observed own_what) : config(own_config), what(own_what), book(self(config)) {
    bus.emplace(config, what, book, wake, inbox);
  }

  const DdsConfig config;
  const Observed what;
  Wake wake;
  PeerBook book;
  Inbox<ObserverInbound> inbox{kInboxBound, wake};
  std::optional<Endpoints> bus;
};

DdsObserverPort::DdsObserverPort(const DdsConfig& config, Observed what)
    : impl_(std::make_unique<Impl>(config, what)) {}
DdsObserverPort::~DdsObserverPort() = default;

void DdsObserverPort::take(std::vector<ObserverInbound>& into) {
  impl_->inbox.drain(into);
}

void DdsObserverPort::renew() {
  impl_->bus.reset();
  impl_->book.renew();
  impl_->bus.emplace(impl_->config, impl_->what, impl_->book, impl_->wake, impl_->inbox);
  impl_->wake.ring();
}

int DdsObserverPort::wake_fd() const {
  return impl_->wake.fd();
}

bool DdsObserverPort::has_world() const {
  return std::ranges::binary_search(impl_->book.swarms(true), impl_->book.own().swarm);
}

std::optional<std::string> DdsObserverPort::conflict() const {
  return impl_->book.conflict();
}

std::array<TopicEndpoints, kTopics.size()> DdsObserverPort::endpoints() const {
  std::array<TopicEndpoints, kTopics.size()> endpoints{};
  if (!impl_->bus) return endpoints;
  const auto there = impl_->book.endpoints(impl_->bus->participant.key());
  // a counterpart of what would be an own reader is a writer
  for (std::size_t i = 0; i < endpoints.size(); ++i) endpoints[i] = {there[2 * i], there[2 * i + 1]};
  return endpoints;
}

std::uint64_t DdsObserverPort::lost() const {
  return impl_->inbox.lost();
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
