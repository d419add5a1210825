// The samples of the lockstep protocol as plain values: what world and agents say to each other in a round.
//
// The world opens a round with a Tick; an agent answers with the samples it composed and closes with its Beacon
// (docs/architecture.md, 'Steps and rounds'). The wire structs of idl/ carry the same content; idl/convert maps and
// checks. Rounds count from 1 over the whole run; round 0 is the waiting phase, outside rounds and hash.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "planner/core/cells/cell_window.hpp"
#include "planner/core/geometry/types.hpp"
#include "planner/core/lockstep/orders.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

enum class Phase : std::uint8_t { Waiting = 0, Planning = 1, Flying = 2, Finished = 3 };

/// What an agent does, as its beacon says.
enum class AgentMode : std::uint8_t {
  Waiting = 0,      ///< not admitted yet
  Planning = 1,     ///< in planning rounds
  Ready = 2,        ///< the whole swarm has a feasible set of paths
  Failed = 3,       ///< planning ended without a feasible set; the beacon's constraint says which one fails
  Flying = 4,       ///< follows its path
  Arrived = 5,      ///< its path is flown to the end
  Leaving = 6,      ///< says goodbye: it was asked to end
  Rejoined = 7,     ///< came back after a loss: takes part from the next planning on
  Unreachable = 8,  ///< knows no way to its goal; hovers, and gives way
  Deadlock = 9,     ///< finds no way past the others, and has given up
  Replanning = 10,  ///< in flight: calls for a new plan, or takes part in making one
  Holding = 11,     ///< by command: waits where it is (constant speed: circles)
  GoingTo = 12,     ///< by command: flies to a point, and waits there
  Landing = 13,     ///< by command: descends
  Landed = 14,      ///< by command: is down; its mission is over
};

/// Who decides where a UAV flies, as its run-time monitor says (papers/000, section 2).
enum class SafetyMode : std::uint8_t {
  Autonomous = 0,  ///< its plan
  Controlled = 1,  ///< its controller, off the plan: something is in the way, or a zone is not confirmed
  Hold = 2,        ///< nobody: it waits where it is (constant speed: circles)
};

/// Why the monitor's mode is what it is, and why a new plan is called for.
enum class SafetyReason : std::uint8_t {
  None = 0,
  Obstacle = 1,     ///< something sensed is in the way
  Peer = 2,         ///< a peer will come too close
  Unconfirmed = 3,  ///< a zone ahead is announced to be occupied, and not confirmed to be clear
  Deviation = 4,    ///< too far from where the plan says
  Blocked = 5,      ///< something sensed lies on the path to come, and stays
  StalePeer = 6,    ///< a live peer is no longer heard
  Replanning = 7,   ///< waits for a plan that the swarm is making
  NoPlan = 8,       ///< has none that the swarm accepted: it came back, or planning failed
};

/// What the world, as its traffic control, says of an announced zone.
enum class ZoneState : std::uint8_t {
  Ahead = 0,        ///< the announced time is far enough away
  Unconfirmed = 1,  ///< may be occupied at any time
  Occupied = 2,
  Clear = 3,  ///< the occupation is confirmed to be over
};

/// The constraint that a plan violates, in the order in which they are named.
enum class Constraint : std::uint8_t {
  None = 0,
  Curvature = 1,   ///< Eq. 12
  Obstacle = 2,    ///< J_obsc of Eq. 11
  NoFly = 3,       ///< J_nofly of Eq. 11
  Separation = 4,  ///< Eq. 15, 17
  Length = 5,      ///< Eq. 16: the common length cannot be reached
  Torsion = 6,     ///< Eq. 12, in space
  Terrain = 7,     ///< J_terr of Eq. 11
};

/// RunStarted is no longer said: who comes back after a loss is admitted.
enum class RefusalReason : std::uint8_t { IdInUse = 1, UnknownId = 2, RunStarted = 3 };

/// Why an agent left the roster; in a RosterChange also that one came back: Rejoined.
enum class LossReason : std::uint8_t { None = 0, ProcessEnded = 1, Deadline = 2, Left = 3, Rejoined = 4 };

/// A live agent, and how many samples (0 or 1 a topic) of the round before count.
struct RosterEntry {
  AgentId agent = 0;
  std::uint32_t incarnation = 0;
  std::uint64_t nonce = 0;
  bool representative = false;  ///< its representative of the round before counts
  bool sense = false;           ///< the world sends it a sense sample with this tick
  bool obstacle_map = false;    ///< its obstacle map sample of the round before counts

  bool operator==(const RosterEntry&) const = default;
};

struct Refusal {
  std::uint64_t nonce = 0;
  RefusalReason reason = RefusalReason::IdInUse;

  bool operator==(const Refusal&) const = default;
};

/// The id that the world holds for a process that introduced itself without one (agent 0).
struct Assignment {
  std::uint64_t nonce = 0;
  AgentId agent = 0;

  bool operator==(const Assignment&) const = default;
};

/// What a run came to, as the world's last tick says.
struct Outcome {
  std::uint8_t exit_code = 0;  ///< of the world's process (docs/architecture.md)
  std::string reason;          ///< one line

  bool operator==(const Outcome&) const = default;
};

struct Tick {
  std::uint64_t run = 0;
  std::uint32_t step = 0;  ///< the flight step that this tick opens, from 1; 0 while the swarm plans on the ground
  std::uint32_t round = 0;
  Phase phase = Phase::Waiting;
  double time_s = 0.0;
  std::vector<RosterEntry> roster;  ///< by ascending id
  std::vector<Refusal> refused;
  std::vector<Assignment> assigned;
  std::uint64_t world_hash = 0;      ///< H of the round before
  std::optional<Outcome> outcome;    ///< given with phase Finished
  std::vector<Order> orders;         ///< that take effect in this round
  std::vector<OrderAnswer> answers;  ///< what became of the newest commands; of no run

  bool operator==(const Tick&) const = default;
};

/// A peer within radio range.
struct HeardPeer {
  AgentId agent = 0;
  Vec3 position_m = Vec3::Zero();
  Vec3 velocity_mps = Vec3::Zero();
  bool landed = false;  ///< it is no obstacle any more

  bool operator==(const HeardPeer&) const = default;
};

/// Something near that is no cell of a map and no vehicle of the swarm: it moves, or was suddenly there.
struct Track {
  std::uint32_t id = 0;  ///< the obstacle's, from 1: the same for all who see it
  Vec3 position_m = Vec3::Zero();
  Vec3 velocity_mps = Vec3::Zero();
  double radius_m = 0.0;
  bool column = false;  ///< an upright cylinder without ends instead of a sphere: only horizontal distance counts
  bool fixed = false;   ///< it never moves

  bool operator==(const Track&) const = default;
};

/// What one agent's own sensors tell it.
struct Sense {
  std::uint64_t run = 0;
  AgentId agent = 0;
  std::uint32_t incarnation = 0;
  std::uint32_t round = 0;
  Pose pose;
  Vec3 velocity_mps = Vec3::Zero();
  std::vector<HeardPeer> heard;  ///< by ascending id
  CellWindow sight;              ///< the cells that its sensor saw as Free or Occupied
  std::vector<Track> tracks;     ///< within the sensor's range, by ascending id
  std::vector<ZoneState> zones;  ///< by announcement, as in Mission::announced
  bool obeyed = true;            ///< its vehicle does what it commands

  bool operator==(const Sense&) const = default;
};

/// How far a sub-swarm's plan is.
enum class PlanStage : std::uint8_t {
  Searching = 1,  ///< generations of the sub-swarm
  Aligning = 2,   ///< moving to the common length
  Settled = 3,    ///< at the common length, clear of every peer
};

/// What a UAV brings into a new plan under way: where it will be, how fast it is and what it has seen.
struct Revision {
  std::uint32_t attempt = 0;                 ///< the round in which it was called for; a later one takes its place
  std::uint32_t switch_step = 0;             ///< the flight step in which all turn to the new plan
  SafetyReason reason = SafetyReason::None;  ///< None: it takes part because a peer called
  Pose pose;                                 ///< at the beginning of switch_step
  double speed_mps = 0.0;                    ///< that it can keep
  std::vector<Track> obstacles;              ///< fixed ones that it knows of, by ascending id

  bool operator==(const Revision&) const = default;
};

inline void add_to(StateHash& hash, const Track& track) {
  hash.add(track.id).add(track.position_m).add(track.velocity_mps).add(track.radius_m).add(track.column);
  hash.add(track.fixed);
}
inline void add_to(StateHash& hash, const Revision& revision) {
  hash.add(revision.attempt).add(revision.switch_step).add(revision.reason).add(revision.pose).add(revision.speed_mps);
  hash.add(revision.obstacles.size());
  for (const Track& track : revision.obstacles) add_to(hash, track);
}

/// The representative particle of a sub-swarm: the DCPSO exchange (papers/001, section 3.2.4).
struct Representative {
  std::uint64_t run = 0;
  AgentId agent = 0;
  std::uint32_t incarnation = 0;
  std::uint32_t round = 0;
  PlanStage stage = PlanStage::Searching;
  Constraint violated = Constraint::None;  ///< the first own constraint that the particle violates
  std::vector<double> particle;            ///< (m0, m1) in metres; of joined segments with their coefficients
  double cost = 0.0;                       ///< modified cost (1 / f' of Eq. 14), in length units
  double own_length_m = 0.0;               ///< length of the particle that is best by its own fitness (Eq. 11)
  double path_length_m = 0.0;              ///< length of `particle`
  std::optional<Revision> revision;        ///< opens a new plan under way; the rest but run to round then says nothing

  bool operator==(const Representative&) const = default;
};

enum class NeedTopic : std::uint8_t { Answer = 0, ObstacleMap = 1 };

/// A sample that an agent still lacks for the open tick.
struct Need {
  AgentId agent = 0;
  std::uint32_t round = 0;
  NeedTopic topic = NeedTopic::Answer;  ///< Answer: a representative, or the agent's own sense sample

  bool operator==(const Need&) const = default;
};

struct Beacon {
  std::uint64_t run = 0;
  AgentId agent = 0;              ///< 0 in an introduction: asks for an id
  std::uint32_t incarnation = 0;  ///< 0: introduces itself
  std::uint64_t nonce = 0;
  std::uint32_t step = 0;
  std::uint32_t round = 0;      ///< the last one that it answered; in an introduction the newest tick that it heard
  bool closes_round = false;    ///< false: an open beacon, an introduction or a list of needs
  bool representative = false;  ///< a representative of this round goes with it
  bool obstacle_map = false;    ///< an obstacle map sample of this round goes with it
  std::vector<std::uint64_t> matched;  ///< nonces of the processes whose endpoints are matched with its own
  std::vector<Need> needs;
  AgentMode mode = AgentMode::Waiting;
  Constraint constraint = Constraint::None;  ///< with mode Failed: the constraint that fails
  AgentId constraint_peer = 0;               ///< and the peer of a failed separation
  Pose pose;
  Vec3 commanded_velocity_mps = Vec3::Zero();
  double planned_length_m = 0.0;
  double cost = 0.0;             ///< of its best particle, in length units
  std::uint32_t generation = 0;  ///< of its sub-swarm
  std::uint64_t map_hash = 0;    ///< of its obstacle map: equal maps, equal hashes; 0 without one
  std::uint64_t plan_view = 0;   ///< of the plan that it flies (plan_view.hpp); 0: of none that the swarm agreed on
  SafetyMode safety_mode = SafetyMode::Autonomous;
  SafetyReason safety_reason = SafetyReason::None;
  double deviation_m = 0.0;             ///< from where its plan says; 0 without one
  double predicted_separation_m = 1e6;  ///< least to a peer's centre within the horizon; 1e6: nobody is heard
  std::uint64_t state_hash = 0;
  std::vector<std::uint64_t> acknowledged;  ///< the orders of this round's tick that concern it

  bool operator==(const Beacon&) const = default;
};

/// A change of the roster, as the report keeps it.
struct RosterChange {
  std::uint32_t step = 0;
  std::uint32_t round = 0;  ///< the first round whose tick no longer names this incarnation, or names it again
  AgentId agent = 0;
  std::uint32_t incarnation = 0;
  LossReason reason = LossReason::None;

  bool operator==(const RosterChange&) const = default;
};

}  // namespace skein
