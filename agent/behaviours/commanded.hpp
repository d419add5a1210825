// A behaviour that also obeys the operator: around that of the mission, from an agent's first command on.
//
//   doing    mode                    flies                                                        until
//   mission  that of the mission     what the mission's behaviour says                            a command
//   hold     Holding                 multirotor: brakes with half of what it can, and hovers;     a command
//                                    constant speed: circles (circle.hpp)
//   goto     GoingTo, then Holding   straight to the point, and holds there                       a command
//   return   GoingTo, or Holding     back to where it left the mission: multirotor straight;      it is there: the
//                                    constant speed on its circle if it only held, else by        mission goes on
//                                    way_back.hpp; where the mission goes on anywhere, at once
//   land     Landing                 down: multirotor straight, constant speed in circles         it is down
//   landed   Landed                  nothing: its mission is over                                 -
// While it obeys, the mission's behaviour stands still: no round, no samples; it goes on as it was left. So a swarm
// that is held and resumed as a whole arrives as it would have, later. What can hover and senses is kept clear by the
// mission's velocity controller throughout. Ground is the mission's terrain, without one the height 0. Source: own.
// Departs from source: none. Complexity: a step of the controller.
#pragma once

#include <memory>
#include <optional>

#include "agent/behaviours/behaviour.hpp"
#include "agent/behaviours/circle.hpp"
#include "agent/behaviours/surroundings.hpp"
#include "agent/behaviours/way_back.hpp"
#include "agent/controller/moving_reference.hpp"
#include "agent/controller/velocity_controller.hpp"

namespace skein {

class CommandedBehaviour final : public Behaviour {
 public:
  /// @throws std::invalid_argument if the mission has no such vehicle
  CommandedBehaviour(const Mission& mission, AgentId self, std::unique_ptr<Behaviour> mission_behaviour);

  /// From the next flight step on. Of several before it the last one stands.
  bool obey(const Order& order) override;

  [[nodiscard]] bool can_use(const Representative& peer) const override { return inner_->can_use(peer); }
  RoundOutput on_round(const RoundInput& input) override;
  void add_to(StateHash& hash) const override;

 private:
  enum class Doing : std::uint8_t { Mission = 0, Hold = 1, Goto = 2, Return = 3, Land = 4, Landed = 5 };

  [[nodiscard]] bool hovers() const { return spec_.type != VehicleType::ConstantSpeed; }
  [[nodiscard]] double braking_mps2() const;
  [[nodiscard]] Vec3 rest_m(const Sense& sense) const;
  [[nodiscard]] double ground_height_m(const Vec3& place_m) const;
  [[nodiscard]] double side_of_circle(const Pose& pose) const;
  void begin(const Order& order, const Sense& sense);
  void leave(const Order& order, const Sense& sense);
  RoundOutput run_mission(const RoundInput& input);
  [[nodiscard]] bool is_back(const Sense& sense) const;
  [[nodiscard]] Vec3 wish(const Sense& sense);
  [[nodiscard]] Vec3 hovering_wish(const Sense& sense);
  [[nodiscard]] Vec3 circling_wish(const Sense& sense);
  [[nodiscard]] Vec3 turning_to(const Sense& sense, const Vec3& to_m) const;
  [[nodiscard]] Vec3 circling_down(const Sense& sense) const;
  [[nodiscard]] bool is_down(const Sense& sense) const;
  void fly(const Tick& tick, const Sense& sense);

  Mission mission_;
  VehicleSpec spec_;
  std::unique_ptr<Behaviour> inner_;
  std::optional<Surroundings> surroundings_;  ///< of a vehicle that hovers and senses
  VelocityController controller_;
  MovingReference brake_;
  Doing doing_ = Doing::Mission;
  std::optional<Order> next_;
  Pose left_;                        ///< where it left its mission
  Vec3 left_rest_m_ = Vec3::Zero();  ///< and where it came to rest, if it can
  bool stale_ = false;               ///< its peers may have planned without it since
  bool on_left_circle_ = false;      ///< the circle began where it left
  bool there_ = false;               ///< at the point that it was sent to
  Vec3 to_m_ = Vec3::Zero();
  double speed_mps_ = 0.0;
  Circle circle_;
  WayBack way_back_;  ///< of a constant-speed vehicle that was sent away
  RoundOutput last_;
};

}  // namespace skein
