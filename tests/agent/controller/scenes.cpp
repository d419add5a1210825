#include "tests/agent/controller/scenes.hpp"

#include <cmath>

#include "planner/core/math/det_math.hpp"

namespace skein::test {
namespace {

/// What hardly moves may stand in a goal for as long as it likes.
constexpr double kSlowest_mps = 0.5;

Vec3 direction(RandomStream& random, bool planar) {
  const double angle_rad = random.uniform(0.0, math::kTwoPi);
  const double up = planar ? 0.0 : random.uniform(-1.0, 1.0);
  const double flat = std::sqrt(1.0 - up * up);
  return {flat * math::cos(angle_rad), flat * math::sin(angle_rad), up};
}

Vec3 place(RandomStream& random, const Vec3& low, const Vec3& high) {
  const double x = random.uniform(low.x(), high.x());
  const double y = random.uniform(low.y(), high.y());
  return {x, y, random.uniform(low.z(), high.z())};
}

Obstacle random_obstacle(RandomStream& random, const Loop& loop, std::uint32_t id, double speed_mps, double clear_m) {
  Obstacle o;
  const bool planar = loop.high_m.z() <= loop.low_m.z();
  o.track.id = id;
  o.track.radius_m = random.uniform(0.5, 2.0);
  o.track.column = planar && random.uniform() < 0.3;
  bool clear = false;
  while (!clear) {
    o.track.position_m = place(random, loop.low_m, loop.high_m);
    clear = true;
    for (const Flyer& f : loop.flyers) {
      const double gap_m = (f.state.position_m - o.track.position_m).norm() - f.spec.radius_m - o.track.radius_m;
      clear = clear && gap_m > clear_m;
    }
  }
  const double speed = random.uniform(kSlowest_mps, speed_mps);
  o.moves = static_cast<Moves>(random.below(3));
  o.turn_probability = loop.step_s / random.uniform(1.0, 6.0);
  const std::uint64_t points = 3 + random.below(3);
  for (std::uint64_t n = 0; n < points; ++n) o.waypoints_m.push_back(place(random, loop.low_m, loop.high_m));
  o.track.velocity_mps = speed * direction(random, planar);
  return o;
}

void add_flyer(Loop& loop, const Vec3& start_m, const Vec3& goal_m) {
  Flyer f;
  f.spec = multirotor_spec(static_cast<AgentId>(loop.flyers.size() + 1));
  f.state.position_m = start_m;
  f.goal_m = goal_m;
  loop.flyers.push_back(f);
}

/// UAVs that cross the area, starts and goals apart.
void add_crossing(RandomStream& random, Loop& loop, std::uint64_t uavs) {
  while (loop.flyers.size() < uavs) {
    const Vec3 start_m = place(random, loop.low_m, loop.high_m);
    const Vec3 goal_m = place(random, loop.low_m, loop.high_m);
    if ((goal_m - start_m).norm() < 60.0) continue;
    const bool clear = std::ranges::all_of(loop.flyers, [&](const Flyer& f) {
      return (f.state.position_m - start_m).norm() > 6.0 && (f.goal_m - goal_m).norm() > 6.0;
    });
    if (clear) add_flyer(loop, start_m, goal_m);
  }
}

}  // namespace

Loop random_scene(std::uint64_t seed, double speed_mps, double sensor_m) {
  RandomStream random(seed, 0, Purpose::Test, 1);
  Loop loop;
  loop.seed = seed;
  loop.options.sensor_range_m = sensor_m;
  loop.options.obstacle_speed_mps = speed_mps;
  if (seed % 2 == 1) loop.high_m.z() = 30.0;
  add_crossing(random, loop, 1 + random.below(8));
  for (std::uint32_t n = 1; n <= 10; ++n) loop.obstacles.push_back(random_obstacle(random, loop, n, speed_mps, 10.0));
  return loop;
}

Loop static_scene(std::uint64_t seed) {
  RandomStream random(seed, 0, Purpose::Test, 3);
  Loop loop;
  loop.seed = seed;
  loop.options.sensor_range_m = 24.0;
  add_crossing(random, loop, 6);
  const auto clear = [&](const Vec3& place_m) {
    return std::ranges::all_of(loop.flyers, [&](const Flyer& f) {
      return (f.state.position_m - place_m).norm() > 8.0 && (f.goal_m - place_m).norm() > 8.0;
    });
  };
  while (loop.obstacles.size() + loop.zones.size() < 10) {
    const Vec3 place_m = place(random, loop.low_m, loop.high_m);
    const double size_m = random.uniform(1.0, 4.0);
    if (!clear(place_m)) continue;
    const std::uint64_t kind = random.below(4);
    if (kind == 0) {
      loop.zones.emplace_back(Cylinder{place_m.head<2>(), size_m});
    } else if (kind == 1) {
      const Vec3 half_m(size_m, random.uniform(1.0, 4.0), 50.0);
      loop.zones.emplace_back(Box{place_m - half_m, place_m + half_m});
    } else {
      Obstacle o;
      o.track.id = static_cast<std::uint32_t>(loop.obstacles.size() + 1);
      o.track.position_m = place_m;
      o.track.radius_m = size_m;
      o.track.column = kind == 2;
      o.track.fixed = true;
      loop.obstacles.push_back(o);
    }
  }
  return loop;
}

Loop sphere_swap(std::uint64_t seed, std::size_t uavs) {
  RandomStream random(seed, 0, Purpose::Test, 2);
  Loop loop;
  loop.seed = seed;
  loop.options.sensor_range_m = 24.0;
  loop.options.obstacle_speed_mps = 5.0;
  const double radius_m = 40.0;
  const Vec3 centre_m(50.0, 50.0, 50.0);
  loop.high_m = Vec3(100.0, 100.0, 100.0);
  const double turn_rad = random.uniform(0.0, math::kTwoPi);
  for (std::size_t n = 0; n < uavs; ++n) {  // a spiral from pole to pole, so that no two are near
    const double up = 1.0 - (2.0 * static_cast<double>(n) + 1.0) / static_cast<double>(uavs);
    const double flat = std::sqrt(1.0 - up * up);
    const double angle_rad = turn_rad + 2.399963229728653 * static_cast<double>(n);
    const Vec3 offset_m = radius_m * Vec3(flat * math::cos(angle_rad), flat * math::sin(angle_rad), up);
    add_flyer(loop, centre_m + offset_m, centre_m - offset_m);
  }
  const auto obstacles = static_cast<std::uint32_t>(uavs / 4 + 4);
  for (std::uint32_t n = 1; n <= obstacles; ++n) {
    loop.obstacles.push_back(random_obstacle(random, loop, n, 5.0, 10.0));
  }
  return loop;
}

}  // namespace skein::test
