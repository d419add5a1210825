#include "tests/agent/controller/closed_loop.hpp"

#include "planner/core/geometry/distance.hpp"
#include "planner/core/math/det_math.hpp"

namespace skein::test {
namespace {

Vec3 level(const Vec3& v, bool column) {
  return column ? Vec3(v.x(), v.y(), 0.0) : v;
}

double least_between(const Motion& a, const Vec3& from_m, const Vec3& to_m, bool column) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < kMotionPoints; ++i) {
    const double f0 = static_cast<double>(i - 1) / (kMotionPoints - 1);
    const double f1 = static_cast<double>(i) / (kMotionPoints - 1);
    const Vec3 b0 = from_m + f0 * (to_m - from_m);
    const Vec3 b1 = from_m + f1 * (to_m - from_m);
    least = std::min(least, closest_approach(level(a.points_m[i - 1], column), level(a.points_m[i], column),
                                             level(b0, column), level(b1, column))
                                .distance_m);
  }
  return least;
}

}  // namespace

/// New velocities of an obstacle at the beginning of a step.
void Loop::turn(std::size_t n, std::uint64_t step) {
  Obstacle& o = obstacles[n];
  const double speed_mps = o.track.velocity_mps.norm();
  if (speed_mps <= 0.0) return;
  if (o.moves == Moves::Loop) {
    const Vec3 to_m = o.waypoints_m[o.next] - o.track.position_m;
    if (to_m.norm() <= speed_mps * step_s) o.next = (o.next + 1) % o.waypoints_m.size();
    const Vec3 ahead_m = o.waypoints_m[o.next] - o.track.position_m;
    if (ahead_m.norm() > 1e-6) o.track.velocity_mps = speed_mps * ahead_m.normalized();
    return;
  }
  RandomStream random(seed, static_cast<std::uint32_t>(n), Purpose::Test, step + 1000);
  if (o.moves == Moves::Walk && random.uniform() < o.turn_probability) {
    const double angle_rad = random.uniform(0.0, math::kTwoPi);
    const double up = high_m.z() > low_m.z() ? random.uniform(-1.0, 1.0) : 0.0;
    const double flat = std::sqrt(1.0 - up * up);
    o.track.velocity_mps = speed_mps * Vec3(flat * math::cos(angle_rad), flat * math::sin(angle_rad), up);
  }
  for (Eigen::Index d = 0; d < 3; ++d) {
    if (o.track.position_m[d] < low_m[d]) o.track.velocity_mps[d] = std::abs(o.track.velocity_mps[d]);
    if (o.track.position_m[d] > high_m[d]) o.track.velocity_mps[d] = -std::abs(o.track.velocity_mps[d]);
  }
}

std::vector<Neighbour> Loop::neighbours_of(std::size_t n) const {
  std::vector<Neighbour> found;
  const Vec3& here_m = flyers[n].state.position_m;
  for (std::size_t k = 0; k < flyers.size(); ++k) {
    const Flyer& f = flyers[k];
    if (k == n || (f.state.position_m - here_m).norm() > peer_range_m) continue;
    found.push_back(
        {f.spec.id, f.state.position_m, f.state.velocity_mps, f.spec.radius_m, f.spec.max_acceleration_mps2});
  }
  return found;
}

Steering Loop::command(std::size_t n) const {
  const Flyer& flyer = flyers[n];
  std::vector<Track> tracks;
  for (const Obstacle& o : obstacles) {
    const Vec3 apart_m = level(o.track.position_m - flyer.state.position_m, o.track.column);
    if (apart_m.norm() - o.track.radius_m <= options.sensor_range_m) tracks.push_back(o.track);
  }
  const std::vector<Neighbour> neighbours = neighbours_of(n);
  const Scene scene{flyer.state.position_m, flyer.state.velocity_mps, neighbours, tracks, zones};
  const VelocityController controller(options, flyer.spec, step_s, peer_range_m);
  return controller.command(
      scene, attraction(flyer.goal_m - flyer.state.position_m, flyer.spec.speed_mps, flyer.spec.max_acceleration_mps2));
}

void Loop::check(std::size_t n, const Motion& motion, bool still, Tally& tally) {
  for (std::size_t k = 0; k < obstacles.size(); ++k) {
    const Track& t = obstacles[k].track;
    const double gap_m = least_between(motion, t.position_m, t.position_m + step_s * t.velocity_mps, t.column) -
                         t.radius_m - flyers[n].spec.radius_m;
    tally.least_m = std::min(tally.least_m, gap_m);
    const bool touches = gap_m < 0.0;
    if (touches && !touching_[n][k]) ++(still ? tally.rammed_at_rest : tally.collisions);
    touching_[n][k] = touches;
  }
  for (const ZoneShape& zone : zones) {
    double gap_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < kMotionPoints; ++i) {
      gap_m = std::min(gap_m, std::visit(
                                  [&](const auto& shape) {
                                    return signed_distance(motion.points_m[i - 1], motion.points_m[i], shape);
                                  },
                                  zone));
    }
    tally.collisions += gap_m < flyers[n].spec.radius_m ? 1 : 0;
    tally.least_m = std::min(tally.least_m, gap_m - flyers[n].spec.radius_m);
  }
}

Tally Loop::run(double limit_s) {
  Tally tally;
  touching_.assign(flyers.size(), std::vector<bool>(obstacles.size() + flyers.size(), false));
  std::vector<Steering> commands(flyers.size());
  std::vector<VehicleStep> next(flyers.size());
  for (std::uint64_t step = 0; static_cast<double>(step) * step_s < limit_s; ++step) {
    for (std::size_t k = 0; k < obstacles.size(); ++k) turn(k, step);
    for (std::size_t n = 0; n < flyers.size(); ++n) commands[n] = flyers[n].last = command(n);
    for (std::size_t n = 0; n < flyers.size(); ++n) {
      Flyer& f = flyers[n];
      next[n] = advance_multirotor(f.spec, f.state, commands[n].velocity_mps, step_s);
      f.way_m += next[n].motion.length_m;
      tally.overruled += commands[n].overruled ? 1 : 0;
      tally.braking += commands[n].braking ? 1 : 0;
      ++tally.steps;
      check(n, next[n].motion, f.state.velocity_mps.isZero(0.0) && next[n].after.velocity_mps.isZero(0.0), tally);
    }
    for (std::size_t n = 0; n < flyers.size(); ++n) {
      for (std::size_t k = n + 1; k < flyers.size(); ++k) {
        double least = std::numeric_limits<double>::infinity();
        const auto& a = next[n].motion.points_m;
        const auto& b = next[k].motion.points_m;
        for (std::size_t i = 1; i < kMotionPoints; ++i)
          least = std::min(least, closest_approach(a[i - 1], a[i], b[i - 1], b[i]).distance_m);
        least -= flyers[n].spec.radius_m + flyers[k].spec.radius_m;
        tally.least_peer_m = std::min(tally.least_peer_m, least);
        const bool touches = least < 0.0;
        if (touches && !touching_[n][obstacles.size() + k]) ++tally.peer_collisions;
        touching_[n][obstacles.size() + k] = touches;
      }
    }
    bool all = true;
    for (std::size_t n = 0; n < flyers.size(); ++n) {
      Flyer& f = flyers[n];
      f.state = next[n].after;
      const bool here = (f.goal_m - f.state.position_m).norm() <= arrival_m;
      if (here && f.arrival_s < 0.0) f.arrival_s = static_cast<double>(step + 1) * step_s, ++tally.arrived;
      all = all && f.arrival_s >= 0.0;
    }
    for (Obstacle& o : obstacles) o.track.position_m += step_s * o.track.velocity_mps;
    if (all) break;
  }
  return tally;
}

}  // namespace skein::test
