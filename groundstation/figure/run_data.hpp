// What figures show of a run, as plain values: where everybody was, what was planned, how costs fell.
//
// Taken from the samples of the bus, whether a recording holds them or a run in this process publishes them:
//   flown    position at the beginning of each flight step k, time (k - 1) step_s: the sense sample of the round, or,
//            where nobody recorded it, the beacon's own pose
//   planned  the path of the last representative before the flight, 201 points at equal arc distances
//   costs    cost of the best particle, of each generation's first beacon, in the mission's length units
// separation() is the least distance of two vehicles in the air at the beginning of each step: never less than the
// report's min_separation_m, which is continuous between steps.
// Source: papers/001, Eq. 2-6 and its figures. Departs from source: none. Complexity: O(samples log samples).
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "idl/bus/topics.hpp"
#include "planner/core/lockstep/samples.hpp"
#include "planner/rendezvous/path_profile.hpp"

namespace skein::figure {

struct TracePoint {
  std::uint32_t step = 0;  ///< at whose beginning it was there
  Vec3 position_m = Vec3::Zero();
  bool in_the_air = true;  ///< not arrived, nor back from a loss
};

struct CostPoint {
  std::uint32_t generation = 0;
  double cost = 0.0;  ///< in length units
};

struct VehicleTrace {
  VehicleSpec spec;
  std::vector<TracePoint> flown;  ///< by step
  std::vector<rendezvous::ProfilePoint> planned;
  std::vector<CostPoint> costs;  ///< by generation
  double planned_length_m = 0.0;
};

/// Something that was in nobody's plan, where sensors saw it.
struct SeenObstacle {
  std::uint32_t id = 0;
  double radius_m = 0.0;
  bool fixed = false;
  std::vector<Vec3> places_m;  ///< one a round in which anybody saw it; of a fixed one the first
};

struct RunData {
  Mission mission;
  std::vector<VehicleTrace> vehicles;  ///< as the mission's
  std::vector<SeenObstacle> seen;      ///< by id
};

struct SeparationPoint {
  double time_s = 0.0;
  double least_m = 0.0;
  AgentId a = 0;  ///< the two that are nearest
  AgentId b = 0;
  double safety_m = 0.0;   ///< the sum of their safety radii
  double contact_m = 0.0;  ///< the sum of their bodies' radii
};

/// By time; steps with less than two vehicles in the air are left out. O(steps x vehicles^2).
[[nodiscard]] std::vector<SeparationPoint> separation(const RunData& run);

/// Where the vehicle at that place of the mission's list is to be at the end: its slot, or its goal.
[[nodiscard]] Vec3 end_m(const Mission& mission, std::size_t vehicle);

/// Whether all is in one horizontal plane.
[[nodiscard]] bool is_planar(const RunData& run);

/// Collects a run's samples.
class RunCollector {
 public:
  /// A DDS payload; the first mission names the run, and what is of another run, or comes before it, is left out.
  void add(bus::TopicId topic, std::span<const std::uint8_t> payload);
  [[nodiscard]] bool has_mission() const { return run_.has_value(); }
  /// Samples that are none of their type, or say what none may say.
  [[nodiscard]] std::uint64_t unreadable() const { return unreadable_; }
  /// The run so far. @pre has_mission()
  [[nodiscard]] RunData data() const;

 private:
  struct Key {
    AgentId agent = 0;
    std::uint32_t round = 0;
    auto operator<=>(const Key&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm of clang-tidy 14
  };
  template <typename Wire, typename Use>
  void take(std::span<const std::uint8_t> payload, const Use& use);
  void add_beacon(const Beacon& beacon);
  void add_sense(const Sense& sense);
  [[nodiscard]] std::vector<TracePoint> flown_by(AgentId agent) const;
  [[nodiscard]] std::vector<rendezvous::ProfilePoint> planned_by(AgentId agent) const;

  std::optional<std::uint64_t> run_;
  Mission mission_;
  std::vector<AgentId> ids_;
  std::map<std::uint32_t, std::uint32_t> steps_;  ///< of flight rounds
  std::map<Key, Vec3> sensed_;
  std::map<Key, Beacon> beacons_;
  std::map<std::uint32_t, SeenObstacle> seen_;
  std::map<std::uint32_t, std::uint32_t> seen_in_;  ///< the last round in which it was
  std::map<Key, std::vector<double>> particles_;
  std::uint64_t unreadable_ = 0;
};

}  // namespace skein::figure
