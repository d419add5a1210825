// A run as an observer follows it: what its ticks and beacons tell, in the words of the run's own progress.
//
// An observer reads best effort: any sample may be missing, and a run may be met at any moment of it. A tick of another
// run than the last one starts anew. Complexity: O(agents) a sample.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "idl/bus/dds_observer_port.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein {

class ObservedRun {
 public:
  /// Takes a sample; one that is no valid sample is counted and left out.
  void take(const bus::ObserverInbound& sample);

  [[nodiscard]] bool heard_tick() const { return tick_.has_value(); }
  /// What the run came to, once its last tick was heard.
  [[nodiscard]] std::optional<Outcome> outcome() const { return tick_ ? tick_->outcome : std::nullopt; }
  /// As progress_of() of the world describes a run. @pre heard_tick()
  [[nodiscard]] nlohmann::json progress() const;
  /// Outcome, and where the run was when it ended. @pre outcome()
  [[nodiscard]] nlohmann::ordered_json result() const;
  [[nodiscard]] std::uint64_t refused_samples() const { return refused_; }

 private:
  /// The plain value, or nothing and a count if the sample is refused.
  template <typename Plain, typename Wire>
  [[nodiscard]] std::optional<Plain> read(const Wire& sample);
  void on_sample(const wire::Mission& sample);
  void on_sample(const wire::Tick& sample);
  void on_sample(const wire::Beacon& sample);
  template <typename Shared>
  void on_sample(const Shared& /*sample*/) {}  // what agents share tells nothing of a run's course

  std::optional<Mission> mission_;
  std::optional<Tick> tick_;           ///< the newest
  std::map<AgentId, Beacon> beacons_;  ///< the newest of each agent, introductions included
  std::uint64_t refused_ = 0;
};

}  // namespace skein
