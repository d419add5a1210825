// What a UAV took its plan to be when the swarm accepted it: a digest that all who fly that plan share.
//
//   view = hash of (agent, particle, path length) of the representatives that the plan was accepted upon, by agent
// Those are the ones of the round before it: each peer's as it was heard, and the own one. Whoever heard another
// representative, or of another set of peers, has another view; the world, which heard all of them, reckons the same.
// Source: own. Departs from source: none. Complexity: O(n log n) for n representatives.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein {

/// @param accepted of one round, in any order, one of each agent. @return 0 for none, else another number
[[nodiscard]] inline std::uint64_t plan_view_of(std::vector<const Representative*> accepted) {
  if (accepted.empty()) return 0;
  std::ranges::sort(accepted, {}, &Representative::agent);
  StateHash hash(0x766965777eULL);
  for (const Representative* one : accepted) {
    hash.add(one->agent).add(std::span<const double>(one->particle)).add(one->path_length_m);
  }
  return std::max<std::uint64_t>(hash.value(), 1);
}

/// The same of what was heard, and what was said, if anything was.
[[nodiscard]] inline std::uint64_t plan_view_of(std::span<const Representative> heard,
                                                const std::optional<Representative>& said) {
  std::vector<const Representative*> accepted;
  for (const Representative& one : heard) accepted.push_back(&one);
  if (said) accepted.push_back(&*said);
  return plan_view_of(std::move(accepted));
}

}  // namespace skein
