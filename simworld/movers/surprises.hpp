// All that a world holds and agents are not told of, but for hidden obstacles of maps.
#pragma once

#include <vector>

#include "simworld/movers/mover.hpp"
#include "simworld/movers/traffic.hpp"

namespace skein {

/// A vehicle whose real top speed is less than its spec says, or more.
struct SlowVehicle {
  AgentId id = 0;
  double factor = 1.0;  ///< of the speed that the mission says
  double from_s = 0.0;

  bool operator==(const SlowVehicle&) const = default;
};

struct Surprises {
  std::vector<Mover> movers;     ///< in order of the scenario
  std::vector<Traffic> traffic;  ///< by announcement; none: everybody is on time
  std::vector<SlowVehicle> slow;

  bool operator==(const Surprises&) const = default;
};

}  // namespace skein
