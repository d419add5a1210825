#include <algorithm>
#include <deque>
#include <iterator>
#include <stdexcept>

#include "idl/bus/dds_endpoint.hpp"
#include "idl/bus/dds_port.hpp"
#include "idl/bus/memory_bus.hpp"

namespace skein::bus {
namespace {

PeerInfo self(const DdsConfig& config, std::span<const AgentId> ids) {
  if (ids.empty()) throw std::invalid_argument("a process of agents needs one at least");
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const bool asks_for_id = ids[i] == kWorldId && ids.size() == 1;
    if (!asks_for_id && (ids[i] < 1 || ids[i] > kMaxAgents)) {
      throw std::invalid_argument("agent id " + std::to_string(ids[i]) + " is not in 1 to " +
                                  std::to_string(kMaxAgents));
    }
    if (i > 0 && ids[i] <= ids[i - 1]) throw std::invalid_argument("the agents' ids must ascend, each once");
  }
  PeerInfo info{Role::Agent, config.swarm, ids.front(), config.nonce, config.wire_version, config.start_stamp_ns};
  info.members = static_cast<std::uint32_t>(ids.size());
  return info;
}

std::vector<std::string> sense_partitions(const std::string& swarm, std::span<const AgentId> ids) {
  std::vector<std::string> partitions;
  for (const AgentId id : ids) partitions.push_back(sense_partition(swarm, id));
  return partitions;
}

std::vector<std::string> partitions_of(const std::string& swarm, std::span<const AgentId> ids) {
  std::vector<std::string> partitions = sense_partitions(swarm, ids);
  partitions.push_back(swarm);
  return partitions;
}

// Members end in the opposite order: endpoints, then the participant.
struct Endpoints {
  Endpoints(const DdsConfig& config, std::span<const AgentId> ids, PeerBook& book, const Wake& wake,
            Inbox<AgentInbound>& inbox)
      : participant(config, partitions_of(config.swarm, ids), book, wake),
        publisher(participant.publisher(config.swarm)),
        subscriber(participant.subscriber({config.swarm})),
        own_subscriber(participant.subscriber(sense_partitions(config.swarm, ids))),
        mission(participant, subscriber, book, wake, inbox, Ring::Now),
        tick(participant, subscriber, book, wake, inbox, Ring::Now),
        sense(participant, own_subscriber, book, wake, inbox, Ring::Counted),
        representative_in(participant, subscriber, book, wake, inbox, Ring::Counted),
        representative_out(participant, publisher, book, wake),
        map_in(participant, subscriber, book, wake, inbox, Ring::Counted),
        map_out(participant, publisher, book, wake),
        beacon(participant, publisher, book, wake) {}

  Participant participant;
  fdds::Publisher* publisher;
  fdds::Subscriber* subscriber;
  fdds::Subscriber* own_subscriber;
  Reader<wire::Mission, AgentInbound> mission;
  Reader<wire::Tick, AgentInbound> tick;
  Reader<wire::Sense, AgentInbound> sense;
  Reader<wire::Representative, AgentInbound> representative_in;
  Writer<wire::Representative> representative_out;
  Reader<wire::ObstacleMap, AgentInbound> map_in;
  Writer<wire::ObstacleMap> map_out;
  Writer<wire::Beacon> beacon;
};

}  // namespace

// Members end in the opposite order: what is on the bus, then what its listeners use.
struct DdsAgentGroup::Impl {
  /// One agent's port.
  class Member final : public AgentPort {
   public:
    Member(Impl& group, AgentId id, std::uint64_t nonce) : id_(id), nonce_(nonce), group_(group) {}

    void publish(const AgentOutbound& sample) override { group_.publish(*this, sample); }
    void take(std::vector<AgentInbound>& into) override { group_.take(*this, into); }
    void wake_after(std::size_t samples) override { group_.wake_after(*this, samples); }
    [[nodiscard]] std::vector<std::uint64_t> matched() const override { return group_.matched(*this); }

   private:
    friend struct Impl;
    AgentId id_;
    std::uint64_t nonce_;
    Impl& group_;
    std::deque<AgentInbound> pending_;  ///< handed over, not taken yet
    std::size_t wake_after_ = 0;
  };

  Impl(const DdsConfig& own_config, std::span<const AgentId> own_ids, Delivery delivery)
      : config(own_config), ids(own_ids.begin(), own_ids.end()), wake(std::move(delivery)), book(self(config, ids)) {
    bus.emplace(config, ids, book, wake, inbox);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      members.push_back(std::make_unique<Member>(*this, ids[i], config.nonce + i));
    }
  }

  void renew() {
    bus.reset();
    book.renew();
    bus.emplace(config, ids, book, wake, inbox);
    wake.ring();
  }

  bool write(const wire::Beacon& sample) { return bus && bus->beacon.write(sample); }
  bool write(const wire::Representative& sample) { return bus && bus->representative_out.write(sample); }
  bool write(const wire::ObstacleMap& sample) { return bus && bus->map_out.write(sample); }

  void publish(const Member& from, const AgentOutbound& sample) {
    const bool accepted = std::visit([this](const auto& held) { return write(held); }, sample);
    if (!accepted) ++refused_by_dds;
    if (members.size() == 1) return;
    if (const auto* representative = std::get_if<wire::Representative>(&sample)) share(from, *representative);
    if (const auto* map = std::get_if<wire::ObstacleMap>(&sample)) share(from, *map);
  }

  /// With the other agents of this process, directly.
  template <typename Shared>
  void share(const Member& from, const Shared& sample) {
    bool awaited = false;
    for (const auto& member : members) {
      if (member.get() == &from) continue;
      hand_over(*member, sample);
      awaited = awaited || member->wake_after_ != kOnTick;
    }
    if (awaited) wake.ring();
  }

  /// The process is woken for the agent that lacks the fewest samples.
  void wake_after(Member& of, std::size_t samples) {
    if (of.wake_after_ == samples) return;
    of.wake_after_ = samples;
    std::size_t least = samples;
    for (const auto& member : members) least = std::min(least, member->wake_after_);
    inbox.wake_after(least);
  }

  void receive() {
    arrived.clear();
    inbox.drain(arrived);
    for (const AgentInbound& sample : arrived) {
      const auto* own = std::get_if<wire::Sense>(&sample);
      for (const auto& member : members) {
        if (own == nullptr || own->agent() == member->id_) hand_over(*member, sample);
      }
    }
  }

  void take(Member& to, std::vector<AgentInbound>& into) {
    if (members.size() == 1) return inbox.drain(into);
    into.insert(into.end(), std::make_move_iterator(to.pending_.begin()), std::make_move_iterator(to.pending_.end()));
    to.pending_.clear();
  }

  template <typename Sample>
  void hand_over(Member& member, const Sample& sample) {
    if (member.pending_.size() == kInboxBound) {
      member.pending_.pop_front();
      ++overflowed;
    }
    member.pending_.emplace_back(sample);
  }

  [[nodiscard]] std::vector<std::uint64_t> matched(const Member& of) const {
    std::vector<std::uint64_t> nonces = book.matched_nonces(monotonic_s());
    for (const auto& member : members) {
      if (member.get() != &of) nonces.push_back(member->nonce_);
    }
    std::ranges::sort(nonces);
    return nonces;
  }

  const DdsConfig config;
  const std::vector<AgentId> ids;
  Wake wake;
  PeerBook book;
  Inbox<AgentInbound> inbox{kInboxBound, wake};
  std::uint64_t refused_by_dds = 0;
  std::uint64_t overflowed = 0;  ///< of a port whose owner does not take
  std::vector<std::unique_ptr<Member>> members;
  std::vector<AgentInbound> arrived;
  std::optional<Endpoints> bus;
};

DdsAgentGroup::DdsAgentGroup(const DdsConfig& config, std::span<const AgentId> ids, std::function<bool()> delivery)
    : impl_(std::make_unique<Impl>(config, ids, std::move(delivery))) {}
DdsAgentGroup::~DdsAgentGroup() = default;

AgentPort& DdsAgentGroup::port(std::size_t index) const {
  return *impl_->members.at(index);
}

void DdsAgentGroup::receive() {
  if (impl_->members.size() > 1) impl_->receive();
}

void DdsAgentGroup::renew() {
  impl_->renew();
}

int DdsAgentGroup::wake_fd() const {
  return impl_->wake.fd();
}

bool DdsAgentGroup::flush(std::chrono::milliseconds limit) {
  const Deadline deadline(limit);
  return impl_->bus && impl_->bus->representative_out.flush(deadline.left_s()) &&
         impl_->bus->map_out.flush(deadline.left_s()) && impl_->bus->beacon.flush(deadline.left_s());
}

std::optional<std::string> DdsAgentGroup::conflict() const {
  return impl_->book.conflict();
}

std::uint64_t DdsAgentGroup::lost() const {
  return impl_->inbox.lost() + impl_->refused_by_dds + impl_->overflowed;
}

}  // namespace skein::bus
