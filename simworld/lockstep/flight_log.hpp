// What agents said under way of safety and of new plans: each change is an event; each attempt to plan anew is kept.
//
// An attempt begins when an agent's mode becomes Replanning while nobody else's is; by whom and why it was called for
// stands in the representatives of that round or of the next ones (Revision), else in the beacons. It ends when nobody
// is in that mode any more: switched if none of those that took part says that it has no plan. A later attempt that
// somebody calls for meanwhile takes its place.
// Source, Departs from source: none. Complexity of a round: O(agents).
#pragma once

#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "simworld/lockstep/answers.hpp"

namespace skein {

/// A change of what an agent's run-time monitor says, or of its part in planning anew.
struct FlightEvent {
  std::uint32_t step = 0;
  std::uint32_t round = 0;
  AgentId agent = 0;
  SafetyMode mode = SafetyMode::Autonomous;
  SafetyReason reason = SafetyReason::None;
  bool replanning = false;
  double deviation_m = 0.0;
  double predicted_separation_m = 0.0;
};

enum class ReplanOutcome : std::uint8_t {
  Open = 0,      ///< still under way as the run ended
  Switched = 1,  ///< all who took part fly the new plan
  NoPlan = 2,    ///< somebody who took part has none
  Replaced = 3,  ///< another attempt took its place
};

[[nodiscard]] std::string_view name_of(ReplanOutcome outcome);

struct Replan {
  std::uint32_t step = 0;  ///< in which it was called for
  std::uint32_t round = 0;
  AgentId agent = 0;  ///< who called
  SafetyReason reason = SafetyReason::None;
  std::uint32_t switch_step = 0;  ///< in which all were to turn to the new plan; 0: nobody said
  std::uint32_t ended_step = 0;   ///< 0: it is open
  ReplanOutcome outcome = ReplanOutcome::Open;
};

class FlightLog {
 public:
  /// The answers of a round of the flight. @param roster those of it who are live
  void add(std::uint32_t step, std::uint32_t round, const Barrier& answers, std::span<const RosterEntry> roster);

  [[nodiscard]] const std::vector<FlightEvent>& events() const { return events_; }
  /// Events beyond those that are kept.
  [[nodiscard]] std::uint64_t events_left_out() const { return left_out_; }
  [[nodiscard]] const std::vector<Replan>& replans() const { return replans_; }

 private:
  struct Said {
    SafetyMode mode = SafetyMode::Autonomous;
    SafetyReason reason = SafetyReason::None;
    bool replanning = false;

    bool operator==(const Said&) const = default;
  };
  void note_event(std::uint32_t step, const Beacon& beacon, std::uint32_t round);
  void note_revision(std::uint32_t step, const Revision& revision, AgentId agent);
  void note_replan(std::uint32_t step, std::uint32_t round, const Barrier& answers,
                   std::span<const RosterEntry> roster);

  std::map<AgentId, Said> said_;
  std::vector<FlightEvent> events_;
  std::uint64_t left_out_ = 0;
  std::vector<Replan> replans_;
  std::vector<AgentId> taking_part_;
  std::uint32_t attempt_ = 0;  ///< of the open one; 0: not known
};

}  // namespace skein
