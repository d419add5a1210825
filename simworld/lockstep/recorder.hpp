// What decides a run, round by round, for a record of it: with it the run is repeated up to the round that was open.
//
// Run::decide is deterministic, so that its inputs are all there is to keep: who takes part, who is lost, who comes
// back, and what was answered. The figures of the session go along, since a repeated run takes no samples of its own.
// Source: event sourcing. Departs from source: none. Complexity: linear in the answers.
#pragma once

#include <vector>

#include "simworld/lockstep/faults.hpp"
#include "simworld/lockstep/run.hpp"

namespace skein {

/// Samples and CDR payload bytes of one topic, as the world sent or took them.
struct TopicCount {
  std::uint64_t samples = 0;
  std::uint64_t bytes = 0;
};

struct TopicCounts {
  TopicCount mission, tick, sense, beacon, representative, obstacle_map;
};

/// Times at which the run changed phase, in the caller's clock; negative until then.
struct PhaseTimes {
  double created_s = -1.0;
  double started_s = -1.0;  ///< the first round opened
  double flying_s = -1.0;
  double finished_s = -1.0;
};

/// What a session has counted so far, for the report alone.
struct SessionFigures {
  double now_s = 0.0;  ///< when, in the clock of `times`
  PhaseTimes times;
  TopicCounts topics;
  std::uint32_t late_steps = 0;
};

/// What decided a round, or the start.
struct RoundInputs {
  std::uint32_t round = 0;          ///< that was open; 0: the start
  std::uint64_t world_hash = 0;     ///< H before it was decided
  std::vector<RosterEntry> roster;  ///< of the start: who takes part
  std::vector<Loss> lost;           ///< with the next tick
  std::vector<RosterEntry> back;    ///< with the next tick
  Steered steered;                  ///< what takes effect with the next tick
  std::vector<Answer> answers;      ///< those with a beacon, by ascending agent
  SessionFigures figures;
};

/// Keeps what it is told before anybody can hear of it.
class Recorder {
 public:
  virtual ~Recorder() = default;
  /// The round is about to be decided.
  virtual void round(const RoundInputs& inputs) = 0;
  /// The fault on purpose is about to be carried out.
  virtual void fault(const Fault& fault) = 0;
};

}  // namespace skein
