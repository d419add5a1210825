// One agent as an observer follows it, from its beacons, representatives and obstacle maps.
//
// late: delay(k) = stamp of the answer to round k - stamp of the world's tick k; the least delay so far takes out what
// clocks differ by and what the way takes. A step is late when delay(k) - least > the run's usual period: no paced run
// can have been in time then, and one that runs as fast as it can took twice as long as usual.
// Source: none needed. Departs from source: none. Complexity: O(1) a sample, O(points) a view.
#pragma once

#include <optional>

#include "groundstation/watch/history.hpp"
#include "groundstation/watch/step_clock.hpp"
#include "groundstation/watch/view.hpp"
#include "planner/core/lockstep/map_sample.hpp"

namespace skein::watch {

/// How a sample came: the observer's time, the sender's stamp, its bytes on the wire.
struct Arrival {
  double now_s = 0.0;
  std::int64_t stamp_ns = 0;
  std::size_t bytes = 0;
};

class AgentWatch {
 public:
  explicit AgentWatch(AgentId id) : id_(id) {}

  /// @param mission nothing while it is not known
  /// @return whether the beacon tells something new
  bool take(const Beacon& beacon, const Arrival& arrival, const StepClock& clock, const Mission* mission);
  void take(const Representative& representative, const Arrival& arrival);
  void take(const ObstacleMapSample& sample, const Arrival& arrival);
  /// The distance to another vehicle in a round of the flight.
  void note_separation(double distance_m, std::uint32_t round);
  /// To the nearest of all in one round; nothing before it.
  [[nodiscard]] std::optional<double> separation_m() const;

  [[nodiscard]] AgentId id() const { return id_; }
  [[nodiscard]] const std::optional<Beacon>& beacon() const { return beacon_; }
  /// In flight, if its last beacon says where it is.
  [[nodiscard]] std::optional<Vec3> flying_at() const;
  /// All but what depends on the others: live, separation_m, map_tiles. Makes the line of a new plan.
  [[nodiscard]] AgentView view(const Mission* mission, double now_s);

 private:
  struct Nearest {
    std::uint32_t round = 0;
    std::size_t peers = 0;  ///< heard in it
    double distance_m = 0.0;
  };
  void arrived(const Arrival& arrival);
  void count_late(const Beacon& beacon, std::int64_t stamp_ns, const StepClock& clock);
  void note_cost(const Beacon& beacon, const Mission* mission);
  void note_motion(const Beacon& beacon, const Mission* mission);
  void set_way(AgentView& view, const Mission* mission);

  AgentId id_;
  std::optional<Beacon> beacon_;  ///< the newest
  std::optional<Representative> plan_;
  std::optional<Pose> replanned_from_;
  std::optional<Intent> intent_;
  bool plan_changed_ = false;
  std::vector<Vec3> line_m_;  ///< of plan_
  std::optional<double> speed_mps_;
  std::optional<double> min_separation_m_;
  Nearest nearest_;
  Nearest before_;  ///< of the round before
  std::optional<double> last_s_;
  std::optional<std::int64_t> least_delay_ns_;
  std::uint32_t late_ = 0;
  RateMeter rate_;
  History<Vec3> flown_{512};
  History<CostPoint> costs_{1024};
};

}  // namespace skein::watch
