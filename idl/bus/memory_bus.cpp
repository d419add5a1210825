#include "idl/bus/memory_bus.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace skein::bus {
namespace {

/// `sample` as one of `Inbound`'s alternatives. @throws std::invalid_argument if it is none of them.
template <typename Inbound>
Inbound narrow(wire::Sample sample) {
  return std::visit(
      [](auto& held) -> Inbound {
        if constexpr (std::is_constructible_v<Inbound, decltype(std::move(held))>) {
          return Inbound(std::move(held));
        } else {
          throw std::invalid_argument("a tampered sample is of a kind that its receiver does not read");
        }
      },
      sample);
}

template <typename Inbound>
class Inbox {
 public:
  template <typename Sample>
  void put(Sample&& sample, std::uint32_t held_takes) {
    if (held_takes == 0) {
      bound(ready_);
      ready_.emplace_back(std::forward<Sample>(sample));
    } else {
      bound(held_);
      held_.push_back({Inbound(std::forward<Sample>(sample)), held_takes});
    }
  }

  void take(std::vector<Inbound>& into) {
    into.insert(into.end(), std::make_move_iterator(ready_.begin()), std::make_move_iterator(ready_.end()));
    ready_.clear();
    if (held_.empty()) return;
    for (Held& held : held_) {
      if (held.takes-- == 0) into.push_back(std::move(held.sample));
    }
    std::erase_if(held_, [](const Held& held) { return held.takes == kGone; });
  }

  [[nodiscard]] std::uint64_t overflowed() const { return overflowed_; }

 private:
  struct Held {
    Inbound sample;
    std::uint32_t takes;
  };
  static constexpr std::uint32_t kGone = UINT32_MAX;  // 0 - 1: what a delivered sample is left with

  template <typename Queue>
  void bound(Queue& queue) {
    if (queue.size() < kInboxBound) return;
    queue.erase(queue.begin());
    ++overflowed_;
  }

  std::vector<Inbound> ready_;
  std::vector<Held> held_;
  std::uint64_t overflowed_ = 0;
};

}  // namespace

class MemoryBus::Hub {
 public:
  class Agent;
  class World;

  explicit Hub(std::uint64_t world_nonce);

  void attach(Agent& agent);
  void detach(Agent& agent);

  template <typename Port, typename Sample>
  void deliver(AgentId from, AgentId to, Port& port, const Sample& sample) {
    if (!tamper_) {
      port.inbox.put(sample, 0);
      return;
    }
    using Inbound = typename Port::Inbound;
    for (Transit& arrived : tamper_(Transit{from, to, sample, 0})) {
      port.inbox.put(narrow<Inbound>(std::move(arrived.sample)), arrived.held_takes);
    }
  }

  template <typename Published>
  void tap(AgentId from, const Published& published) const {
    if (tap_) std::visit([&](const auto& sample) { tap_(from, wire::Sample(sample)); }, published);
  }

  std::vector<std::uint64_t> all_but(std::uint64_t nonce) const {
    std::vector<std::uint64_t> others;
    others.reserve(nonces_.size());
    std::ranges::copy_if(nonces_, std::back_inserter(others), [&](std::uint64_t other) { return other != nonce; });
    return others;
  }

  std::unique_ptr<World> world_;
  std::vector<Agent*> agents_;         // in order of attachment
  std::vector<std::uint64_t> nonces_;  // ascending, the world's included
  std::unique_ptr<wire::Mission> latched_;
  Tamper tamper_;
  Tap tap_;
  std::uint64_t overflowed_ = 0;  // of ports that are gone
};

class MemoryBus::Hub::Agent final : public AgentPort {
 public:
  using Inbound = AgentInbound;

  Agent(Hub& hub, AgentId own_id, std::uint64_t own_nonce) : id(own_id), nonce(own_nonce), hub_(hub) {
    hub_.attach(*this);
  }
  ~Agent() override { hub_.detach(*this); }
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;

  void publish(const AgentOutbound& sample) override;
  void take(std::vector<AgentInbound>& into) override { inbox.take(into); }
  [[nodiscard]] std::vector<std::uint64_t> matched() const override { return hub_.all_but(nonce); }

  const AgentId id;
  const std::uint64_t nonce;
  Inbox<AgentInbound> inbox;

 private:
  Hub& hub_;
};

class MemoryBus::Hub::World final : public WorldPort {
 public:
  using Inbound = WorldInbound;

  World(Hub& hub, std::uint64_t own_nonce) : nonce(own_nonce), hub_(hub) {}

  void publish(const WorldOutbound& sample) override;
  void take(std::vector<WorldInbound>& into) override { inbox.take(into); }
  [[nodiscard]] std::vector<std::uint64_t> matched() const override { return hub_.all_but(nonce); }

  const std::uint64_t nonce;
  Inbox<WorldInbound> inbox;

 private:
  Hub& hub_;
};

MemoryBus::Hub::Hub(std::uint64_t world_nonce)
    : world_(std::make_unique<World>(*this, world_nonce)), nonces_{world_nonce} {}

void MemoryBus::Hub::attach(Agent& agent) {
  const auto place = std::ranges::lower_bound(nonces_, agent.nonce);
  if (place != nonces_.end() && *place == agent.nonce) throw std::invalid_argument("the nonce is attached already");
  nonces_.insert(place, agent.nonce);
  agents_.push_back(&agent);
  if (latched_) deliver(kWorldId, agent.id, agent, *latched_);
}

void MemoryBus::Hub::detach(Agent& agent) {
  std::erase(nonces_, agent.nonce);
  std::erase(agents_, &agent);
  overflowed_ += agent.inbox.overflowed();
}

void MemoryBus::Hub::Agent::publish(const AgentOutbound& sample) {
  hub_.tap(id, sample);
  if (const auto* beacon = std::get_if<wire::Beacon>(&sample)) {
    hub_.deliver(id, kWorldId, *hub_.world_, *beacon);
    return;
  }
  const auto share = [this](const auto& shared) {
    for (Agent* peer : hub_.agents_) {
      if (peer != this) hub_.deliver(id, peer->id, *peer, shared);
    }
    hub_.deliver(id, kWorldId, *hub_.world_, shared);
  };
  if (const auto* representative = std::get_if<wire::Representative>(&sample)) {
    share(*representative);
  } else {
    share(std::get<wire::ObstacleMap>(sample));
  }
}

void MemoryBus::Hub::World::publish(const WorldOutbound& sample) {
  hub_.tap(kWorldId, sample);
  if (const auto* mission = std::get_if<wire::Mission>(&sample)) {
    hub_.latched_ = std::make_unique<wire::Mission>(*mission);
  }
  std::visit(
      [this](const auto& held) {
        for (Agent* agent : hub_.agents_) {
          if constexpr (std::is_same_v<std::decay_t<decltype(held)>, wire::Sense>) {
            if (agent->id != held.agent()) continue;
          }
          hub_.deliver(kWorldId, agent->id, *agent, held);
        }
      },
      sample);
}

MemoryBus::MemoryBus(std::uint64_t world_nonce) : hub_(std::make_unique<Hub>(world_nonce)) {}
MemoryBus::~MemoryBus() = default;

WorldPort& MemoryBus::world() {
  return *hub_->world_;
}

std::unique_ptr<AgentPort> MemoryBus::attach(AgentId id, std::uint64_t nonce) {
  if (id < 1 || id > kMaxAgents) {
    throw std::invalid_argument("agent id " + std::to_string(id) + " is not in 1 to " + std::to_string(kMaxAgents));
  }
  return std::make_unique<Hub::Agent>(*hub_, id, nonce);
}

void MemoryBus::set_tamper(Tamper tamper) {
  hub_->tamper_ = std::move(tamper);
}

void MemoryBus::set_tap(Tap tap) {
  hub_->tap_ = std::move(tap);
}

std::uint64_t MemoryBus::overflowed() const {
  std::uint64_t sum = hub_->overflowed_ + hub_->world_->inbox.overflowed();
  for (const Hub::Agent* agent : hub_->agents_) sum += agent->inbox.overflowed();
  return sum;
}

}  // namespace skein::bus
