// What a recording says of a run, in the one order that does not depend on when what arrived.
//
// A sample is named by (round, topic, agent, incarnation); repeats of it are the same sample. Left out of what it says,
// since it differs between runs of one seed: head.run and head.stamp_ns, nonces (of beacons, rosters), matched, needs,
// refused and given, the ids of commands, and the answers to them; and the last tick's exit code and reason, which tell
// of signals and of faults on purpose that never took place as well. Left out whole: waiting ticks, introductions, open
// beacons, and samples of another run. Which samples of round k count, its next tick says (docs/architecture.md): what
// an agent sent and then was lost is no part of the run. Source: docs/wire.md. Departs from source: none. Complexity:
// O(samples log samples).
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "groundstation/mcap/reader.hpp"
#include "idl/bus/topics.hpp"
#include "idl/convert/cdr.hpp"
#include "simworld/lockstep/run.hpp"

namespace skein {

struct SampleName {
  std::uint32_t round = 0;  ///< 0 of the mission
  bus::TopicId topic = bus::TopicId::Mission;
  AgentId agent = kWorldId;
  std::uint32_t incarnation = 0;
  auto operator<=>(const SampleName&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm of clang-tidy 14
};

class RecordedRun {
 public:
  /// Takes a sample as it was on the wire; the first tick of a round names the run.
  void add(bus::TopicId topic, std::span<const std::uint8_t> payload);

  /// What is compared: CDR bytes without what differs between runs.
  [[nodiscard]] const std::map<SampleName, Bytes>& samples() const { return samples_; }
  /// Whether the run's ticks count it; without a next tick the last round's do.
  [[nodiscard]] bool counts(const SampleName& name) const;
  /// Losses and returns, as the rosters say; the reason of a loss is not told: the end of a process.
  [[nodiscard]] std::vector<RosterChange> roster_changes() const;
  /// Commands, by the ticks that say them.
  [[nodiscard]] const std::vector<OrderedAt>& orders() const { return orders_; }
  /// Obstacles that were put in its way, from the round that ticks say of each, in the order of those; of one whose
  /// sample or answer is not there nothing is known.
  [[nodiscard]] std::vector<InjectedAt> injections() const;
  [[nodiscard]] std::uint32_t last_round() const { return ticks_.empty() ? 0 : ticks_.rbegin()->first; }
  /// What the run came to, if its last tick is there.
  [[nodiscard]] std::optional<Outcome> outcome() const;
  /// Bytes that are no sample of their type, by the sample that they say they are.
  [[nodiscard]] const std::map<SampleName, Bytes>& broken() const { return broken_; }
  /// How many there were.
  [[nodiscard]] std::uint64_t unreadable() const { return unreadable_; }

 private:
  void add_typed(const wire::Mission& sample);
  void add_typed(const wire::Tick& sample);
  void add_typed(const wire::Beacon& sample);
  void add_typed(const wire::Sense& sample);
  void add_typed(const wire::Representative& sample);
  void add_typed(const wire::ObstacleMap& sample);
  void add_orders(const wire::Tick& sample);
  template <typename Wire>
  void take(bus::TopicId topic, std::span<const std::uint8_t> payload);
  void note_broken(bus::TopicId topic, std::span<const std::uint8_t> payload);
  template <typename Wire>
  void keep(const SampleName& name, Wire sample);
  [[nodiscard]] bool is_other(std::uint64_t run);

  std::optional<std::uint64_t> run_;
  std::map<SampleName, Bytes> samples_;
  std::map<SampleName, Bytes> broken_;
  std::map<std::uint32_t, wire::Tick> ticks_;  ///< by round, without what is not compared
  std::vector<OrderedAt> orders_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> accepted_;  ///< ids that ticks answer, with their rounds
  std::map<std::uint64_t, wire::Inject> injects_;                  ///< by id, of any run
  std::uint64_t unreadable_ = 0;
};

/// All samples of a file. @throws mcap::Damaged
[[nodiscard]] RecordedRun run_of(const mcap::Reader& file);

}  // namespace skein
