// Tells the world of a swarm that somebody else started what to do, and waits for what becomes of it.
//
// Source: docs/steering.md. Departs from source: none.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "idl/process/common_flags.hpp"
#include "planner/core/lockstep/orders.hpp"

namespace skein {

/// @pre ids are 0: each is given one of its own
struct SteerRequest {
  std::variant<Order, Injection> what;
  double deadline_s = 5.0;  ///< from when the world is found
};

struct SteerResult {
  int exit_code = 0;            ///< 1 refused or not acknowledged; 2 no swarm to choose; 3 no world; 128 + a signal
  std::string reason;           ///< in one line, if it is not 0
  nlohmann::ordered_json json;  ///< null if nothing was sent
};

/// @throws std::runtime_error if DDS cannot be had
[[nodiscard]] SteerResult steer(const CommonFlags& flags, const SteerRequest& request);

}  // namespace skein
