#include <map>
#include <stdexcept>

#include "idl/bus/dds_endpoint.hpp"
#include "idl/bus/dds_port.hpp"
#include "idl/bus/memory_bus.hpp"

namespace skein::bus {
namespace {

PeerInfo self(const DdsConfig& config) {
  PeerInfo info{Role::World, config.swarm, kWorldId, config.nonce, config.wire_version, config.start_stamp_ns};
  info.run = config.run;
  return info;
}

std::vector<std::string> partitions_of(const DdsConfig& config, std::span<const AgentId> agents) {
  std::vector<std::string> partitions{config.swarm};
  for (const AgentId agent : agents) partitions.push_back(sense_partition(config.swarm, agent));
  return partitions;
}

// Members end in the opposite order: endpoints, then the participant.
struct Endpoints {
  Endpoints(const DdsConfig& config, std::span<const AgentId> agents, PeerBook& book, const Wake& wake,
            Inbox<WorldInbound>& inbox)
      : participant(config, partitions_of(config, agents), book, wake),
        publisher(participant.publisher(config.swarm)),
        subscriber(participant.subscriber({config.swarm})),
        beacon(participant, subscriber, book, wake, inbox, Ring::Counted),
        representative_in(participant, subscriber, book, wake, inbox, Ring::Silent),
        representative_out(participant, publisher, book, wake),
        map_in(participant, subscriber, book, wake, inbox, Ring::Silent),
        map_out(participant, publisher, book, wake),
        command(participant, subscriber, book, wake, inbox, Ring::Now),
        inject(participant, subscriber, book, wake, inbox, Ring::Now),
        mission(participant, publisher, book, wake),
        tick(participant, publisher, book, wake) {
    for (const AgentId agent : agents) {
      if (agent < 1 || agent > kMaxAgents || sense.contains(agent)) {
        throw std::invalid_argument("agent id " + std::to_string(agent) + " is out of range or listed twice");
      }
      fdds::Publisher* own = participant.publisher(sense_partition(config.swarm, agent));
      sense.try_emplace(agent, participant, own, book, wake);
    }
  }

  Participant participant;
  fdds::Publisher* publisher;
  fdds::Subscriber* subscriber;
  Reader<wire::Beacon, WorldInbound> beacon;
  Reader<wire::Representative, WorldInbound> representative_in;
  Writer<wire::Representative> representative_out;
  Reader<wire::ObstacleMap, WorldInbound> map_in;
  Writer<wire::ObstacleMap> map_out;
  Reader<wire::Command, WorldInbound> command;
  Reader<wire::Inject, WorldInbound> inject;
  Writer<wire::Mission> mission;
  Writer<wire::Tick> tick;
  std::map<AgentId, Writer<wire::Sense>> sense;
};

}  // namespace

// Members end in the opposite order: what is on the bus, then what its listeners use.
struct DdsWorldPort::Impl {
  Impl(const DdsConfig& own_config, std::span<const AgentId> own_agents, Delivery delivery)
      : config(own_config),
        agents(own_agents.begin(), own_agents.end()),
        wake(std::move(delivery)),
        book(self(config)) {
    bus.emplace(config, agents, book, wake, inbox);
  }

  void renew() {
    bus.reset();
    book.renew();
    bus.emplace(config, agents, book, wake, inbox);
    if (latched && !bus->mission.write(*latched)) ++refused_by_dds;
    wake.ring();
  }

  bool write(const wire::Mission& sample) {
    latched = sample;
    return bus && bus->mission.write(sample);
  }
  bool write(const wire::Tick& sample) { return bus && bus->tick.write(sample); }
  bool write(const wire::Representative& sample) { return bus && bus->representative_out.write(sample); }
  bool write(const wire::ObstacleMap& sample) { return bus && bus->map_out.write(sample); }
  bool write(const wire::Sense& sample) {
    if (!bus) return false;
    const auto writer = bus->sense.find(sample.agent());
    return writer != bus->sense.end() && writer->second.write(sample);
  }

  const DdsConfig config;
  const std::vector<AgentId> agents;
  Wake wake;
  PeerBook book;
  Inbox<WorldInbound> inbox{kInboxBound, wake};
  std::uint64_t refused_by_dds = 0;
  std::optional<wire::Mission> latched;  ///< as published last
  std::optional<Endpoints> bus;
};

DdsWorldPort::DdsWorldPort(const DdsConfig& config, std::span<const AgentId> agents, std::function<bool()> delivery)
    : impl_(std::make_unique<Impl>(config, agents, std::move(delivery))) {}
DdsWorldPort::~DdsWorldPort() = default;

void DdsWorldPort::publish(const WorldOutbound& sample) {
  const bool accepted = std::visit([this](const auto& held) { return impl_->write(held); }, sample);
  if (!accepted) ++impl_->refused_by_dds;
}

void DdsWorldPort::take(std::vector<WorldInbound>& into) {
  impl_->inbox.drain(into);
}

void DdsWorldPort::wake_after(std::size_t beacons) {
  impl_->inbox.wake_after(beacons);
}

std::vector<std::uint64_t> DdsWorldPort::matched() const {
  return impl_->book.matched_nonces(monotonic_s());
}

void DdsWorldPort::renew() {
  impl_->renew();
}

int DdsWorldPort::wake_fd() const {
  return impl_->wake.fd();
}

bool DdsWorldPort::flush(std::chrono::milliseconds limit) {
  const Deadline deadline(limit);
  if (!impl_->bus) return false;
  Endpoints& bus = *impl_->bus;
  for (auto& [agent, writer] : bus.sense) {
    if (!writer.flush(deadline.left_s())) return false;
  }
  return bus.mission.flush(deadline.left_s()) && bus.tick.flush(deadline.left_s()) &&
         bus.representative_out.flush(deadline.left_s()) && bus.map_out.flush(deadline.left_s());
}

bool DdsWorldPort::observed() const {
  return impl_->book.observed();
}

std::optional<std::string> DdsWorldPort::conflict() const {
  return impl_->book.conflict();
}

std::uint64_t DdsWorldPort::lost() const {
  return impl_->inbox.lost() + impl_->refused_by_dds;
}

}  // namespace skein::bus
