// Whether maps become equal once nothing keeps them apart: what a swarm that shares its maps owes after every healing.
//
// A group is a set of live agents that hold maps and that radio links join, directly or over others. While its members
// neither move nor change, there is nothing new to see, and all that anybody holds is on its way to all others: after
// settling_steps() of that their maps are equal. Whoever comes back, comes near, moves or is lost begins that time
// anew.
//   settling = 1 + hops (tile frames + vector frames + patience (N + tries)) steps of a frame, and latency each hop
// with N - 1 hops at most; as many frames as all tiles of all logs need in half a slot, and all entries of a version
// vector in the other half; a patience of 4 frames before each next holder of a tile steps in, and before each try when
// a sample is lost; and so many tries that all are lost with a probability under 1e-9.
// Source: planner/core/obstacle_map. Departs from source: none; the bound is own. Complexity of a step: O(N^2).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "planner/core/mission/mission.hpp"

namespace skein {

/// A live agent that holds a map, at the end of a step.
struct MapHolder {
  AgentId agent = 0;
  std::uint32_t incarnation = 0;
  Vec3 position_m = Vec3::Zero();
  std::uint64_t map_hash = 0;
};

/// In how many flight steps the maps of a group at rest become equal. Nothing if they need not ever: no maps are
/// shared, the radio's slots are too small for a tile and an entry, or it loses everything; nor if the sensor errs,
/// which then sees something new also at rest.
[[nodiscard]] std::optional<std::uint32_t> settling_steps(const Mission& mission);

class MapWatch {
 public:
  /// @pre mission.transit
  explicit MapWatch(const Mission& mission);

  /// Once a flight step. @param holders by ascending id
  void add(std::uint32_t step, std::span<const MapHolder> holders);

  [[nodiscard]] std::optional<std::uint32_t> settling_steps() const { return settling_steps_; }
  /// Agents, at the end of the last step, whose group had the time to make its maps equal.
  [[nodiscard]] std::size_t due() const { return due_; }
  /// Those of them whose group has maps that differ.
  [[nodiscard]] std::size_t differing() const { return differing_; }

 private:
  struct Group {
    std::uint32_t since_step = 0;  ///< at whose end its members were where they are
    std::vector<MapHolder> members = {};
  };
  [[nodiscard]] std::vector<Group> groups_of(std::span<const MapHolder> holders) const;

  double range_m_;
  std::optional<std::uint32_t> settling_steps_;
  std::vector<Group> groups_;
  std::size_t due_ = 0;
  std::size_t differing_ = 0;
};

}  // namespace skein
