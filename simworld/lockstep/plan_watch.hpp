// Whether nobody flies a plan that its live peers did not accept, as the world reckons it from beacons and samples.
//
// The representatives of a round, of all whom the next tick names, may be a plan from the next round on: the world
// keeps their digest (plan_view.hpp) and whose they are. In a flight round an agent whose beacon says that it flies a
// plan (plan_view not 0) must
//   - say one that was published so, by all who were live then: else it heard something else than its peers said,
//   - be one of those whose plan it is, in this incarnation,
//   - say the newest that anybody says who is on the way; who arrived keeps the one that it arrived by.
// So all that are on the way fly the same plan, made of the final representative of each of them.
// Source: own. Departs from source: none. Complexity of a round: O(N log rounds); memory: N entries a planning round.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "simworld/lockstep/barrier.hpp"

namespace skein {

/// An agent that flew a plan which its peers did not accept.
struct UnacceptedPlan {
  AgentId agent = 0;
  std::uint32_t step = 0;
};

/// A round that is decided.
struct Opened {
  Phase phase = Phase::Planning;
  std::uint32_t step = 0;
  std::uint32_t round = 0;
};

class PlanWatch {
 public:
  /// Once a round. @param roster its agents without those that are lost with it
  void add(const Opened& open, const Barrier& answers, std::span<const RosterEntry> roster);

  /// Agents in all flight rounds that flew a plan which was not accepted.
  [[nodiscard]] std::uint64_t unaccepted() const { return unaccepted_; }
  /// The first of them, if any.
  [[nodiscard]] const std::optional<UnacceptedPlan>& first() const { return first_; }

 private:
  struct Plan {
    std::uint32_t round = 0;  ///< in which it was last published
    std::vector<RosterEntry> crew = {};
  };
  void check(std::uint32_t step, const Barrier& answers, std::span<const RosterEntry> roster);
  [[nodiscard]] const Plan* accepted_plan(const RosterEntry& entry, std::uint64_t view) const;

  std::map<std::uint64_t, Plan> plans_;  ///< by view
  std::uint64_t unaccepted_ = 0;
  std::optional<UnacceptedPlan> first_;
};

}  // namespace skein
