// What an observer knows of a running swarm at one moment, as plain values: all that monitor, status and topics show.
//
// An observer reads best effort and may come late: what it has not heard is absent (std::optional, empty lists), never
// guessed. SI units, world frame.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "groundstation/watch/rate_meter.hpp"
#include "idl/bus/topics.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein::watch {

/// What happened, with the word that says why.
enum class EventKind : std::uint8_t {
  Phase,      ///< of the run
  Mode,       ///< of an agent; a failed plan with its constraint
  Safety,     ///< an agent's run-time monitor, with its reason
  Roster,     ///< an agent is live, lost, back
  Refused,    ///< a process was turned away, with the reason
  NearMiss,   ///< two vehicles are nearer than their safety radii
  Collision,  ///< or than their bodies
  Outcome,    ///< what the run came to
  Command,    ///< the swarm was told something
};

struct Event {
  double time_s = 0.0;  ///< simulated
  std::uint32_t step = 0;
  std::uint32_t round = 0;
  AgentId agent = kWorldId;  ///< kWorldId: of the whole run
  EventKind kind = EventKind::Phase;
  std::string what;    ///< a code: "flying", "lost", "controlled"
  std::string reason;  ///< a code, or empty

  bool operator==(const Event&) const = default;
};

/// A point of the search's history.
struct CostPoint {
  std::uint32_t generation = 0;
  double cost = 0.0;

  bool operator==(const CostPoint&) const = default;
};

/// How a distance to go is known.
enum class ToGoBy : std::uint8_t {
  Straight,  ///< straight line to slot or goal
  Plan,      ///< along the plan, or as the agent itself says
};

struct AgentView {
  AgentId id = 0;
  bool heard = false;  ///< a beacon of it was read; without one only id, position and goal say anything
  bool live = false;   ///< the last tick names it
  std::uint32_t incarnation = 0;
  AgentMode mode = AgentMode::Waiting;
  Constraint constraint = Constraint::None;
  SafetyMode safety_mode = SafetyMode::Autonomous;
  SafetyReason safety_reason = SafetyReason::None;
  std::uint32_t step = 0;
  std::uint32_t round = 0;
  std::optional<Vec3> position_m;
  std::optional<Vec3> goal_m;  ///< slot or goal
  double speed_mps = 0.0;
  std::optional<double> to_go_m;
  ToGoBy to_go_by = ToGoBy::Straight;
  std::optional<double> separation_m;      ///< now, to the nearest other vehicle in flight
  std::optional<double> min_separation_m;  ///< least seen in flight
  double planned_length_m = 0.0;
  std::optional<double> cost;    ///< of the best particle of `generation`; by cells the way to go
  std::uint32_t generation = 0;  ///< of the search; by cells the step
  std::size_t map_tiles = 0;     ///< that it contributed to the swarm's map, as far as seen
  Rate rate;                     ///< of its beacons, representatives and obstacle maps
  std::optional<double> age_s;
  std::uint32_t late_steps = 0;  ///< answered more than a usual period later than its best (agent_watch.hpp)
  std::vector<Vec3> planned_m;
  std::vector<Vec3> flown_m;
  std::vector<CostPoint> costs;
};

struct TopicView {
  bus::TopicId id = bus::TopicId::Mission;
  bool read = true;  ///< false: it is not read here, so rates say nothing
  Rate rate;
  std::uint64_t samples = 0;
  std::uint64_t bytes = 0;
  std::uint32_t writers = 0;
  std::uint32_t readers = 0;
};

/// The cells that the swarm has told each other, as a grid of the mission's area.
struct MappedCells {
  CellGrid grid;
  std::vector<CellState> states;  ///< by index of the grid; empty: no map
  std::size_t known = 0;
};

struct SwarmView {
  std::optional<Mission> mission;
  std::uint64_t run = 0;
  bool heard_tick = false;
  Phase phase = Phase::Waiting;
  std::uint32_t step = 0;
  std::uint32_t round = 0;
  double time_s = 0.0;
  std::uint64_t world_hash = 0;
  std::size_t live = 0;
  std::optional<double> tick_age_s;
  std::optional<double> times_real_time;  ///< simulated by the world's wall time, by its stamps, lately
  std::optional<Outcome> outcome;
  std::uint64_t refused_samples = 0;  ///< that were no valid sample
  std::vector<AgentView> agents;      ///< by ascending id
  std::vector<Event> events;          ///< oldest first
  std::array<TopicView, bus::kTopics.size()> topics{};
  MappedCells cells;
  std::vector<std::array<AgentId, 2>> links;  ///< who is in reach of whom by radio; none if the radio is ideal
};

}  // namespace skein::watch
