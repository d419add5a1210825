// The ports over DDS: one process owns one, or a group of agents' ports, and with it one DDS participant.
//
// A port is ready when constructed and leaves the bus when destroyed. Threads of DDS queue what arrives and ring an
// eventfd; the owner waits on wake_fd() and calls take(), which quietens it. With a `delivery` such a thread first
// tries to serve in the owner's place (idl/process/turn.hpp). Samples are published at once, in the calling thread. UDP
// alone by default, with nothing in /dev/shm; Profile::Shm adds shared memory. Block the signals that a process handles
// before it makes a port: the threads of DDS inherit the mask. A port is used by one thread at a time; conflict(),
// matched() and wake_fd() may be asked from any.
//
// A participant of Fast DDS 2.9.1 whose network was disconnected and connected again is deaf: its memberships in the
// multicast groups went with the interface, its locators may be another's. renew() makes it anew under the same port:
// what had arrived stays, nonce and run stay, endpoints are new, and USER_DATA says how often that was
// (PeerInfo::renewals), so that the others take the new participant for the same process. What was under way is lost,
// for the lockstep to repeat; what is latched is published again.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idl/bus/port.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein::bus {

enum class Profile : std::uint8_t { Udp, Shm };

struct DdsConfig {
  std::uint32_t domain = 0;     ///< 0 to 232
  std::string swarm = "skein";  ///< 1 to 64 letters, digits, - and _; the partition
  Profile profile = Profile::Udp;
  AgentId id = kWorldId;            ///< of the agent; not used by a world
  std::uint64_t nonce = 0;          ///< random, one a process
  std::int64_t start_stamp_ns = 0;  ///< when the process started: of two worlds in a swarm the earlier stays
  double lease_s = 20.0;            ///< after which a silent process counts as gone from the bus; 1 or more
  std::uint64_t run = 0;            ///< of a world: its run, so that it may take a dead one's place; 0: not said
  std::uint32_t wire_version = wire::kWireVersion;  ///< what USER_DATA says; other values are for tests
};

/// The ports of the agents of one process: one participant, and one set of endpoints for all of them.
///
/// DDS delivers a sample once to the process; it is handed to each port that it is for: mission, tick, peers'
/// representatives and obstacle maps to all, sense to its agent. An agent's own go to the agents of the same process
/// directly, as the same wire struct, and to all others over DDS. Discovery costs (participants x endpoints)^2, so that
/// 64 agents in 8 processes are found as fast as 8.
class DdsAgentGroup {
 public:
  /// Agent i of `ids` (ascending, each once) has nonce `config.nonce` + i; `config.id` is not used.
  /// A single id may be 0: of a process that asks for one, to which no sense sample goes.
  /// @throws std::invalid_argument for a config out of range (ids 1 to kMaxAgents), std::runtime_error if DDS cannot
  /// make the participant or an endpoint.
  /// @param delivery called by the thread of DDS that brings what the ports wait for, not only their owner's thread;
  /// everything that it uses must outlive the group (idl/process/turn.hpp)
  DdsAgentGroup(const DdsConfig& config, std::span<const AgentId> ids, std::function<bool()> delivery = {});
  ~DdsAgentGroup();
  DdsAgentGroup(const DdsAgentGroup&) = delete;
  DdsAgentGroup& operator=(const DdsAgentGroup&) = delete;

  /// The port of agent `ids[index]`; it lives as long as the group.
  [[nodiscard]] AgentPort& port(std::size_t index) const;

  /// Hands what arrived to the ports, which is then theirs to take(): call it once before all of them take.
  void receive();
  /// Leaves the bus and joins it with a new participant (above); nobody is matched yet. @throws std::runtime_error if
  /// DDS cannot make one: then the group is on no bus, and what it publishes is lost, until another renew() succeeds.
  void renew();
  /// Readable when something arrived for any port or a match changed since the last receive().
  [[nodiscard]] int wake_fd() const;
  /// Waits until every matched reader has acknowledged everything; false if that took longer than `limit`.
  [[nodiscard]] bool flush(std::chrono::milliseconds limit);
  /// Why this process must end with exit code 3, in one line: a world of the swarm with another wire version.
  [[nodiscard]] std::optional<std::string> conflict() const;
  /// Samples lost on this side: inbox full, or not accepted by DDS.
  [[nodiscard]] std::uint64_t lost() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A group of one.
class DdsAgentPort final : public AgentPort {
 public:
  /// For agent `config.id`. Throws as DdsAgentGroup does.
  explicit DdsAgentPort(const DdsConfig& config);
  ~DdsAgentPort() override;

  void publish(const AgentOutbound& sample) override;
  void take(std::vector<AgentInbound>& into) override;
  void wake_after(std::size_t samples) override;
  [[nodiscard]] std::vector<std::uint64_t> matched() const override;

  void renew() { group_.renew(); }
  [[nodiscard]] int wake_fd() const { return group_.wake_fd(); }
  [[nodiscard]] bool flush(std::chrono::milliseconds limit) { return group_.flush(limit); }
  [[nodiscard]] std::optional<std::string> conflict() const { return group_.conflict(); }
  [[nodiscard]] std::uint64_t lost() const { return group_.lost(); }

 private:
  DdsAgentGroup group_;
};

class DdsWorldPort final : public WorldPort {
 public:
  /// `agents`: the ids that get a sense topic, each once. Throws as DdsAgentPort does.
  /// @param delivery as that of DdsAgentGroup
  DdsWorldPort(const DdsConfig& config, std::span<const AgentId> agents, std::function<bool()> delivery = {});
  ~DdsWorldPort() override;

  void publish(const WorldOutbound& sample) override;
  void take(std::vector<WorldInbound>& into) override;
  void wake_after(std::size_t beacons) override;
  [[nodiscard]] std::vector<std::uint64_t> matched() const override;

  /// As DdsAgentGroup::renew(); the mission that was published last is published again.
  void renew();
  [[nodiscard]] int wake_fd() const;
  [[nodiscard]] bool flush(std::chrono::milliseconds limit);
  /// Whether an observer reads the ticks: best effort, so that it may miss one.
  [[nodiscard]] bool observed() const;
  /// Why this process must end with exit code 3, in one line: another world of the swarm that started earlier.
  [[nodiscard]] std::optional<std::string> conflict() const;
  [[nodiscard]] std::uint64_t lost() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::bus
