// What a UAV that can hover knows of its surroundings in a step: the scene of its controller and the situation of its
// monitor, from what it senses.
//
// An announced zone is closed from clear_s before it is unconfirmed (less the time that braking takes) until the world
// says that it is clear; for a UAV whose braking distance already reaches into it, it is not: it goes through, and has
// clear_s to be out. A live peer is stale if it was heard within the last horizon_s, and is not now.
// Source: papers/000, section 2.3 (controlled mode). Departs from source: zones of any size, with a time to leave.
// Complexity: O(peers + tracks + zones) a step.
#pragma once

#include <span>
#include <vector>

#include "agent/controller/scene.hpp"
#include "agent/monitor/monitor.hpp"

namespace skein {

class Surroundings {
 public:
  /// @throws std::invalid_argument if the mission has no such vehicle.
  Surroundings(const Mission& mission, AgentId self);

  /// Takes in what is sensed as a flight step opens.
  void look(const Tick& tick, const Sense& sense);

  /// Valid until the next look.
  [[nodiscard]] Scene scene() const;
  /// The part of a situation that is sensed; plan and steering are left open. Valid until the next look.
  /// @param wish_mps where the plan leads: a closed zone on the way of the next horizon_s keeps it waiting
  [[nodiscard]] Situation situation(const Vec3& wish_mps) const;

  /// Announced zones that must not be entered now. Valid until the next look.
  [[nodiscard]] std::span<const ZoneShape> closed_zones() const {
    return std::span<const ZoneShape>(shapes_).subspan(known_zones_);
  }

  void add_to(StateHash& hash) const;

 private:
  struct Heard {
    AgentId id = 0;
    std::uint32_t step = 0;
  };

  void hear(const Tick& tick, const Sense& sense);
  void close_zones(const Tick& tick, const Sense& sense);
  [[nodiscard]] bool reaches_into(const ZoneShape& zone) const;

  Mission mission_;
  VehicleSpec own_;
  std::vector<ZoneShape> shapes_;  ///< of the mission's zones, then of the announced ones that are closed
  std::size_t known_zones_;
  std::vector<Neighbour> neighbours_;
  std::vector<double> safe_m_;
  std::vector<Track> tracks_;
  std::vector<Heard> heard_;  ///< peers and when they were heard last, by ascending id
  Vec3 position_m_ = Vec3::Zero();
  Vec3 velocity_mps_ = Vec3::Zero();
  bool stale_ = false;
};

}  // namespace skein
