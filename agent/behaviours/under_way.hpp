// A rendezvous in flight that looks about itself: it keeps to the plan, evades what comes, and plans anew with its
// peers when the plan does not hold.
//
//   plan -> moving reference -> wish -> velocity controller -> monitor -> command
//
//   it has       and                            flies                                             mode
//   a plan       it holds                       along its path                                    Flying, Arrived
//   a plan       an attempt is under way        multirotor: brakes to rest where it promised;     Replanning
//                                               constant speed: on along its path
//   no plan      -                              multirotor: stays where it waits; constant        Replanning; Flying
//                                               speed: circles                                    between attempts
// Its plan does not hold if it is blocked or late (plan_check.hpp), or if it has none: then it calls for a new one
// (replanning.hpp). What moves never becomes an obstacle of a plan: the controller evades it, and the reference leaves
// a tenth of the speed to catch up. Only the new plan says how late all are; nobody's own.
//
// Source: papers/000, section 2; papers/001, section 5. Departs from source: own. Complexity: that of its parts.
#pragma once

#include <optional>
#include <vector>

#include "agent/behaviours/behaviour.hpp"
#include "agent/behaviours/plan_check.hpp"
#include "agent/behaviours/replanning.hpp"
#include "agent/behaviours/surroundings.hpp"
#include "agent/behaviours/waiting_place.hpp"
#include "agent/controller/path_follower.hpp"
#include "agent/controller/velocity_controller.hpp"
#include "agent/monitor/monitor.hpp"

namespace skein {

class UnderWay {
 public:
  UnderWay(const Mission& mission, AgentId self);

  /// Takes the plan made on the ground. @param view its digest (plan_view.hpp). @pre it is Ready
  void take_off(const rendezvous::Planner& planner, std::uint64_t view);
  /// A round in flight: a step, or a planning round between two. Sets all but the samples' signatures.
  void on_round(const RoundInput& input, RoundOutput& out);

  /// It has no plan any more, wherever it is, and calls for one.
  void drop_plan() {
    plan_.reset();
    waiting_.reset();
    reference_m_.reset();
    accepted_ = arrived_ = false;
  }

  void add_to(StateHash& hash) const;

 private:
  struct Plan {
    FlightPath path;
    MovingReference reference;  ///< of a multirotor
    PathFollower follower;      ///< of a constant-speed vehicle
    std::uint64_t view = 0;     ///< its digest
  };
  /// A fixed obstacle, and whether the present plan is known to be clear of it.
  struct Known {
    Track track;
    bool settled = false;
  };

  [[nodiscard]] bool hovers() const { return spec_.type == VehicleType::Multirotor; }
  void set_plan(const rendezvous::Planner& planner, double speed_mps, std::span<const Track> avoided);
  void sense(const Tick& tick, const Sense& sense);
  void learn(std::span<const Representative> peers);
  void note_known(const Track& track, bool settled);
  [[nodiscard]] bool takes_part() const;
  [[nodiscard]] std::optional<SafetyReason> wants();
  [[nodiscard]] Revision revision(const Tick& tick, SafetyReason reason) const;
  [[nodiscard]] double to_come_m() const;
  [[nodiscard]] std::vector<Track> obstacles() const;
  void stop(const Tick& tick);
  void aim(const Tick& tick);
  void wait_hovering();
  [[nodiscard]] bool on_path() const { return plan_ && (waiting_ ? waiting_->stop.has_value() : accepted_); }
  void brake_at_once();
  void draw_back();
  void wait_circling(const Tick& tick);
  [[nodiscard]] double circle_room_m(std::span<const Track> obstacles, double side) const;
  [[nodiscard]] Pose pose_at_switch(const Tick& tick) const;
  [[nodiscard]] Vec3 wish();
  void fly(RoundOutput& out);
  void watch_over(RoundOutput& out) const;
  [[nodiscard]] bool leads_into(std::span<const ZoneShape> zones) const;

  Mission mission_;            ///< with the reserve of plans
  Surroundings surroundings_;  ///< with the safety radii of the mission as told
  AgentId self_;
  VehicleSpec spec_;
  VelocityController controller_;
  double top_mps_;  ///< what it may fly: its speed, or what its sensor carries if that is less
  Replanning replanning_;
  SpeedWatch speed_;
  LateWatch late_;
  std::optional<Plan> plan_;
  bool accepted_ = false;                ///< plan_ is flown; else it is only the way that it came
  std::optional<WaitingPlace> waiting_;  ///< where it stops for a new plan; nothing while it flies one
  MovingReference hold_;                 ///< of a multirotor that waits off its path
  double turn_rad_ = 0.0;                ///< of a step in which a constant-speed vehicle circles, to the left
  std::optional<SafetyReason> wanted_;
  std::vector<Known> known_;  ///< by ascending id
  Sense sense_;               ///< of the last step
  bool sensed_ = false;
  bool arrived_ = false;
  Steering steering_;
  std::optional<Vec3> reference_m_;  ///< where the plan says that it is, as the last step began
};

}  // namespace skein
