// The navigator of one UAV in a transit: where it flies in this decision, and what it says of the next.
//
// Values in, values out: cells that changed, own place, neighbours with the intents heard. In each decision the UAV
//   1. takes the changes into its map,
//   2. flies the intent that it sent in the decision before, if the swept cells are now seen and free and right of way
//      permits it (traffic/right_of_way.hpp: no two bodies touch, whatever is lost), else stays,
//   3. plans from where that ends (steer/) and announces the next motion (traffic/negotiate.hpp).
// Statuses. Arrived: within goal_radius_m. Unreachable: no way through cells not known to be blocked; the UAV hovers
// and gives way, and flies again when the map changes so. Deadlock: kRotations + neighbours times in a row `patience`
// decisions without coming nearer to the goal than ever on this map, while nobody with right of way held it up; each
// time it goes to the back of the order. It still gives way, and flies again as soon as it comes nearer.
// Held: by command (errand.hpp). It gives way to nobody; the others keep off its cell where a way leads around, else
// come up and wait, and lose no patience. It is remembered where it was heard, out of range too, while there is a way.
// Promise of peach3d: one UAV, see steer/peach3d.hpp. Several: whoever is first in the order is asked for nothing and
// held up only by others that are asked; where every two neighbouring cells lie on a cycle it gets through, and in a
// corridor if the others find a bay, or room to back off, within the cells they have seen. Limits: layouts in which the
// first must itself give way for a solution may end as Deadlock; with samples lost everything takes longer;
// a vehicle that hovers without an agent says nothing, so that others keep clear of all that it could reach, for good.
// Precondition: the radio reaches beyond twice the way of a decision and two radii, and sum of radii and margin fit
// into a cell edge. Source: papers/004, section III. Departs from source: see steer/ and traffic/.
// Complexity: of the planner; else O(neighbours).
#pragma once

#include <array>
#include <map>
#include <optional>

#include "planner/gridnav/errand.hpp"
#include "planner/gridnav/steer/guide.hpp"

namespace skein::gridnav {

inline constexpr std::uint32_t kRotations = 2;

struct NavInput {
  std::uint32_t decision = 0;  ///< from 1
  Vec3 position_m = Vec3::Zero();
  std::span<const CellChange> changed;    ///< cells whose state, maps merged, changed since the last decision
  std::span<const Neighbour> neighbours;  ///< within radio range and not landed, by id
};

struct NavDecision {
  Vec3 target_m = Vec3::Zero();  ///< fly there straight, at constant speed, within this decision
  NavStatus status = NavStatus::Flying;
  Intent next;                       ///< to be sent now: for the next decision
  std::vector<CellIndex> revisited;  ///< cells to mark as such in the shared map
};

class Navigator {
 public:
  /// @throws std::invalid_argument if the mission is no transit, lacks the UAV, or start or goal lie in no cell
  Navigator(const Mission& mission, AgentId self);

  /// Once a decision, in order. @throws std::invalid_argument if a changed cell is not in the grid
  [[nodiscard]] NavDecision decide(const NavInput& input);
  /// By command, from the next decision on: it stays where it is then; flies to a point (m) in the grid, at most so
  /// fast (m/s), and stays there; goes on with its mission from where it is.
  void hold();
  void go_to(const Vec3& point_m, double speed_mps);
  void resume();
  /// That one has landed: where it was held is free.
  void forget_held(AgentId id) { held_.erase(id); }
  /// What it does by command, if anything.
  [[nodiscard]] std::optional<ErrandState> errand() const;
  /// Along the planner's way (m); negative: no way.
  [[nodiscard]] double to_go_m() const { return to_go_m_; }
  [[nodiscard]] NavStatus status() const { return status_; }
  [[nodiscard]] const KnownMap& map() const { return map_; }
  void add_to(StateHash& hash) const;

 private:
  struct Heard {
    std::uint32_t decision = 0;
    Intent intent;
  };

  struct Standing {
    Vec3 at_m;
    double apart_m;  ///< to be kept from it
  };

  void learn(std::span<const CellChange> changed);
  [[nodiscard]] bool fly(const NavInput& input) const;
  [[nodiscard]] bool will_fly(const NavInput& input, const Neighbour& neighbour) const;
  [[nodiscard]] std::vector<Other> expect(const NavInput& input);
  [[nodiscard]] Steering& steering() const { return errand_ ? errand_->steering() : guide_.steering(); }
  void note_held(const Neighbour& neighbour);
  [[nodiscard]] std::vector<CellIndex> held_cells(const Vec3& own_m) const;
  void begin(std::optional<Errand> errand);
  [[nodiscard]] Announcement travel(NavDecision& decision, bool flies, const NavInput& input,
                                    std::span<const Other> others);
  void judge_progress(double to_go_m, bool yielding, std::size_t neighbours);

  Task task_;
  Body body_;
  std::map<AgentId, double> reaches_m_;
  KnownMap map_;
  Guide guide_;
  std::optional<Errand> errand_;
  Intent next_;  ///< as sent last
  NavStatus status_ = NavStatus::Flying;
  double to_go_m_ = 0.0;
  double best_m_ = -1.0;  ///< least to go so far; negative: to be taken anew
  std::uint32_t waited_ = 0;
  std::uint32_t rotations_ = 0;
  std::map<AgentId, Heard> heard_;
  std::map<AgentId, Standing> held_;  ///< where others are held, as they said last
  std::uint64_t map_hash_ = 0;
};

}  // namespace skein::gridnav
