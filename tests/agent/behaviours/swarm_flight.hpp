// A swarm of behaviours in one process whose world is played by the test: ticks, roster, senses, vehicles. Planning
// rounds under way are as the world makes them.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "agent/behaviours/behaviour.hpp"
#include "simworld/vehicles/multirotor.hpp"

namespace skein::test {

struct Flyer {
  VehicleSpec spec;
  std::unique_ptr<Behaviour> behaviour;  ///< null while its agent is lost
  VehicleState state;
  RoundOutput out;
  std::optional<Representative> sample;  ///< of the last round
  std::uint32_t arrival_step = 0;        ///< 0: not arrived
  std::uint32_t incarnation = 1;
  double speed_factor = 1.0;  ///< of its speed, what it really reaches
  bool obeyed = true;
};

/// Three multirotors, 10 m/s and 4 m/s2, that meet 300 m ahead; sensors of 30 m, planner.replan 1.
[[nodiscard]] Mission surprise_mission(std::uint64_t seed);

class SwarmFlight {
 public:
  explicit SwarmFlight(const Mission& mission);

  /// Plans on the ground. @return whether all are Ready
  bool plan(int max_rounds = 300);
  /// One round; in flight the steps and their planning rounds take their course.
  void round();
  /// Until the end of a step in which `done`, or of `max_step`.
  void fly_until(std::uint32_t max_step, const std::function<bool()>& done = {});

  void lose(AgentId id);
  /// A fresh agent for a lost one.
  void bring_back(AgentId id);
  /// Is there from now on, seen within the sensor's range.
  void put_obstacle(const Vec3& place_m, double radius_m);

  [[nodiscard]] Flyer& flyer(AgentId id) { return flyers_.at(id); }
  [[nodiscard]] std::map<AgentId, Flyer>& flyers() { return flyers_; }
  [[nodiscard]] std::uint32_t step() const { return step_; }
  [[nodiscard]] std::uint32_t rounds() const { return round_; }
  [[nodiscard]] bool all_arrived() const;
  [[nodiscard]] bool arrived_together() const;
  [[nodiscard]] bool anyone(AgentMode mode) const;
  [[nodiscard]] std::uint64_t hash() const { return hash_; }
  [[nodiscard]] double least_separation_m() const { return least_separation_m_; }
  [[nodiscard]] double least_clearance_m() const { return least_clearance_m_; }
  /// Called with the flight round's outputs before vehicles move.
  std::function<void()> on_step;

 private:
  [[nodiscard]] Sense sense_of(AgentId id) const;
  void move();

  Mission mission_;
  std::map<AgentId, Flyer> flyers_;
  std::vector<Track> obstacles_;
  std::uint32_t round_ = 0;
  std::uint32_t step_ = 0;
  std::int32_t rounds_left_ = 0;  ///< of the step, before it is flown
  std::uint64_t hash_ = 0;
  double least_separation_m_ = 1e9;
  double least_clearance_m_ = 1e9;
};

}  // namespace skein::test
