// Which samples of the open round a recorder has: what the world waits for before it opens the next one.
//
// Of round k a recorder has agent a's part when it has the sense sample that tick k announces, a beacon that closes the
// round, and what that beacon says was sent along. Whoever the world drops has no part in it.
// Source: docs/architecture.md, 'Steps and rounds'. Departs from source: none. Complexity: O(log agents) a sample,
// O(agents) a question; memory for the last three rounds.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "idl/bus/topics.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

class RoundBook {
 public:
  void note(bus::TopicId topic, std::span<const std::uint8_t> payload);

  /// The newest round whose tick is here; 0: none.
  [[nodiscard]] std::uint32_t round() const { return round_; }
  /// Whose part of that round is not whole, ascending.
  [[nodiscard]] std::vector<AgentId> lacking() const;
  /// Whether that round's tick is the run's last.
  [[nodiscard]] bool finished() const { return finished_; }

 private:
  struct Part {
    bool sense = false;
    bool beacon = false;
    bool representative = false;
    bool obstacle_map = false;
    bool needs_representative = false;
    bool needs_obstacle_map = false;
  };
  struct Expected {
    AgentId agent = 0;
    std::uint32_t incarnation = 0;
    bool sense = false;
  };
  using PartName = std::pair<AgentId, std::uint32_t>;  ///< agent and incarnation

  void note_tick(std::span<const std::uint8_t> payload);

  std::uint64_t run_ = 0;
  std::uint32_t round_ = 0;
  bool finished_ = false;
  std::vector<Expected> roster_;  ///< of that round's tick
  std::map<std::uint32_t, std::map<PartName, Part>> parts_;
};

}  // namespace skein
