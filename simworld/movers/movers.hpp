// All movers of a run, advanced step by step: which are there, where they are and how they move.
//
// Before a step opens, those whose moment has come appear; while it lasts, each that is there moves in a straight line
// from its place at the beginning to that at the end (a loop cuts its corners so). A walk turns after it was sensed, so
// that nobody foresees it. A sudden one that may not appear yet waits; one on a UAV's course is placed anew meanwhile,
// and one that is still keeps clear of goals, so that it bars none for good.
// Draws: streams (seed, mover's id, Mover, step); step 0 draws the UAV of `ahead`. Source, Departs from source: as in
// simworld/movers/mover.hpp. Complexity of a step: O(movers * vehicles).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planner/core/hash/state_hash.hpp"
#include "simworld/movers/mover.hpp"

namespace skein {

struct MoverRecord {
  Mover spec;
  std::uint32_t id = 0;  ///< from 1, in order of the scenario
  Vec3 position_m = Vec3::Zero();
  Vec3 velocity_mps = Vec3::Zero();
  Vec3 before_m = Vec3::Zero();     ///< where it was at the beginning of the last step
  std::size_t next_waypoint = 1;    ///< of a loop
  bool armed = false;               ///< a UAV came near
  bool present = false;             ///< from the next step on
  std::uint32_t appeared_step = 0;  ///< the first step in which it is there; 0: it never was
  std::uint32_t gone_step = 0;      ///< the first step in which it is there no more; 0: it stays
};

/// A vehicle, as movers mind it.
struct Bystander {
  VehicleSpec spec;
  Vec3 position_m = Vec3::Zero();
  Vec3 velocity_mps = Vec3::Zero();
  bool in_the_air = true;
};

class Movers {
 public:
  Movers() = default;
  /// @param goals_m where vehicles go: what stays for good keeps clear of these by `goal_clearance_m`
  Movers(std::vector<Mover> movers, std::vector<Vec3> goals_m, double goal_clearance_m, std::uint64_t seed,
         double step_s);

  /// The movers that are there in step `step` (from 1) appear, others go. Call it once a step, before advance.
  void open(std::uint32_t step, std::span<const Bystander> vehicles);
  /// One more, that is there from step `step` on. @param step_s as that of all others
  void add(Mover mover, std::uint32_t step, double step_s);
  /// Moves those that are there through the step.
  void advance(std::uint32_t step);

  [[nodiscard]] const std::vector<MoverRecord>& all() const { return movers_; }
  [[nodiscard]] bool empty() const { return movers_.empty(); }
  void add_to(StateHash& hash) const;

 private:
  [[nodiscard]] bool due(MoverRecord& mover, double time_s, std::span<const Bystander> vehicles) const;
  [[nodiscard]] bool place(MoverRecord& mover, std::span<const Bystander> vehicles) const;
  [[nodiscard]] bool may_appear(const MoverRecord& mover, std::span<const Bystander> vehicles) const;
  void start(MoverRecord& mover, std::uint32_t step) const;
  void walk(MoverRecord& mover, const WalkMotion& motion, std::uint32_t step) const;
  void loop(MoverRecord& mover, const LoopMotion& motion) const;

  std::vector<MoverRecord> movers_;
  std::vector<Vec3> goals_m_;
  double goal_clearance_m_ = 0.0;
  std::uint64_t seed_ = 0;
  double step_s_ = 0.0;
};

/// Between a point and the centre (m): of a column the horizontal distance.
[[nodiscard]] double distance_m(const Vec3& point_m, const Vec3& centre_m, bool column);

}  // namespace skein
