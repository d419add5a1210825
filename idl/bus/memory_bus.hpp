// The bus within one process: the same wire structs, the same port interfaces, no thread and no clock.
//
// A sample is in its receivers' inboxes when publish() returns, in the order of publication; a receiver sees it at its
// next take(). As over DDS: the mission is latched for late joiners, sense reaches its agent alone, a representative or
// obstacle map that the world publishes reaches all agents, nobody hears itself, and what a detached port had not taken
// is lost. Inboxes are bounded; when one is full its oldest sample goes and is counted. One thread at a time may use a
// bus and its ports. Complexity: publish O(receivers), take O(samples).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "idl/bus/port.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein::bus {

/// Samples an inbox holds at most, as the readers of the DDS bus do: depth 16 of kMaxAgents + 2 instances.
inline constexpr std::size_t kInboxBound = std::size_t{16} * (kMaxAgents + 2);

/// One sample on its way to one receiver. Ids: kWorldId is the world.
struct Transit {
  AgentId from = kWorldId;
  AgentId to = kWorldId;
  wire::Sample sample;
  std::uint32_t held_takes = 0;  ///< how many of the receiver's next takes it misses
};

/// Sees every sample in transit and returns what arrives instead: nothing drops it, two duplicate it, a changed sample
/// alters it, held_takes delays it past later ones. `to` of what it returns is ignored.
using Tamper = std::function<std::vector<Transit>(Transit)>;

/// Sees every sample once, as it is published, before it is in transit. `from`: kWorldId is the world.
using Tap = std::function<void(AgentId from, const wire::Sample& sample)>;

class MemoryBus {
 public:
  /// The world's port exists from the start, under this nonce.
  explicit MemoryBus(std::uint64_t world_nonce);
  ~MemoryBus();
  MemoryBus(const MemoryBus&) = delete;
  MemoryBus& operator=(const MemoryBus&) = delete;

  [[nodiscard]] WorldPort& world();

  /// A port for agent `id`, 1 to kMaxAgents; destroying it detaches the agent, at any time. The bus must outlive it.
  /// Two ports may have one id, as two processes may; not one nonce.
  /// @throws std::invalid_argument for an id out of range or a nonce in use.
  [[nodiscard]] std::unique_ptr<AgentPort> attach(AgentId id, std::uint64_t nonce);

  /// From now on; an empty function ends it.
  void set_tamper(Tamper tamper);
  void set_tap(Tap tap);

  /// Samples lost because an inbox was full.
  [[nodiscard]] std::uint64_t overflowed() const;

 private:
  class Hub;
  std::unique_ptr<Hub> hub_;
};

}  // namespace skein::bus
