// Up to where a recorder heard each writer: what its numbers alone cannot tell, for nobody counts what comes after the
// last sample that was heard.
//
// Ticks tell of it. Tick k+1 names an agent that tick j <= k named: it has sent its beacons of rounds j to k. Tick k
// says to whom a sense sample goes with it, tick k+1 what else of round k counts. So, when the last tick (round K) has
// come, a writer whose newest sample is of round r was heard to its end if nothing that was announced is newer, and
// every tick from r+1 to K was heard; of what was announced and is newer it sent at least one sample each:
//   tail = |{ announced rounds > r }|.
// A recorder that never heard the last tick knows nobody's end. What ticks say nothing of (ground stations, what a
// world repeats of an agent) has no end that could be known. Repeats of a sample are not told apart.
// Source: docs/architecture.md, 'Steps and rounds'. Departs from source: none. Complexity: O(agents log rounds) a tick,
// O(log writers) another sample; memory for announced rounds that were not heard.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "idl/bus/dds_recorder_port.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

struct Tail {
  std::optional<bool> heard;  ///< whether the writer's end was; nothing: no tick tells
  std::uint64_t lost = 0;     ///< samples after the last one that was heard, at least
};

class HeardEnds {
 public:
  void note(const bus::RawSample& sample, bool from_world);

  /// Of a writer of which a sample was noted.
  [[nodiscard]] Tail of(const bus::WriterKey& writer) const;

 private:
  /// What an agent says, or is told, on a topic.
  using Voice = std::tuple<bus::TopicId, AgentId, std::uint32_t>;  ///< with its incarnation
  struct Heard {
    std::uint32_t newest = 0;           ///< round
    std::set<std::uint32_t> announced;  ///< rounds, those after `newest`
  };
  struct Listed {
    AgentId agent = 0;
    std::uint32_t incarnation = 0;
    auto operator<=>(const Listed&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm of clang-tidy 14
  };

  void note_tick(const bus::RawSample& sample);
  void announce(bus::TopicId topic, const Listed& agent, std::uint32_t first, std::uint32_t last);

  std::map<bus::WriterKey, std::set<Voice>> writers_;
  std::map<Voice, Heard> voices_;
  std::set<Listed> roster_;       ///< of the newest tick
  std::uint32_t round_ = 0;       ///< of the newest tick
  std::uint32_t whole_from_ = 0;  ///< every tick from this round to the newest was heard
  bool finished_ = false;
};

}  // namespace skein
