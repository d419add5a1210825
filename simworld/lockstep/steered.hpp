// What a swarm was told and what was done to its world, and from which round on.
//
// Source: docs/steering.md. Departs from source: none.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planner/core/lockstep/orders.hpp"

namespace skein {

/// What takes effect with a tick. An injection is of an obstacle: faults act on processes, not on the run.
struct Steered {
  std::vector<Order> orders;
  std::vector<Injection> injections;
};

/// Why an order or an injection cannot be done.
struct Objection {
  OrderResult result = OrderResult::Refused;
  std::string text;  ///< one line
};

struct OrderRecord {
  std::uint32_t step = 0;
  std::uint32_t round = 0;  ///< the first in which it has effect
  Order order;
  std::vector<AgentId> acknowledged;  ///< ascending
};

struct InjectionRecord {
  std::uint32_t step = 0;
  std::uint32_t round = 0;
  Injection injection;
};

}  // namespace skein
