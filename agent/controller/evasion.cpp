#include "agent/controller/evasion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory_resource>
#include <vector>

#include "agent/controller/manoeuvre.hpp"
#include "agent/controller/scratch.hpp"

namespace skein {
namespace {

// Times in v / a, the time in which the vehicle stops; speeds in u, lengths in u v / a.
constexpr double kWary = 0.6;       ///< a mover's standoff, of its speed
constexpr double kStandoff = 0.16;  ///< the standoff of one that stands
constexpr double kReturn = 0.2;     ///< in which what is too near of a standoff is made good
constexpr double kHorizon = 2.0;
constexpr double kGrowth = 0.2;
constexpr double kReach = 0.56;
constexpr double kReachStanding = 0.2;  ///< part of the reach that one has which stands
constexpr double kLeast = 0.4;          ///< of the vehicle's speed: too slow to get out of the way is no safer
constexpr double kWeight = 10.0;        ///< of the vehicle's speed
constexpr double kStopsAtOnce_s = 2.5;  ///< what stands for v / a of a vehicle without inertia
constexpr double kUnknownSpeed = 0.5;   ///< of the vehicle's speed: stands for u if it is 0
constexpr int kSweeps = 2;              ///< over all movers: a bound may break an earlier one
constexpr int kLooks = 8;               ///< within the horizon
constexpr double kEndless_m = 1e9;
constexpr double kSpeeds = 3.0;                   ///< of a direction of the fan
constexpr double kDiagonal = 0.7071067811865476;  // sqrt(1/2)
constexpr double kCosine = 0.9238795325112867;    // of 22.5 degrees
constexpr double kSine = 0.3826834323650898;

/// In what the constants count.
struct Scale {
  double stop_s;        ///< v / a
  double obstacle_mps;  ///< u

  Scale(const ControllerOptions& options, const VehicleSpec& spec)
      : stop_s(spec.max_acceleration_mps2 > 0.0 ? spec.speed_mps / spec.max_acceleration_mps2 : kStopsAtOnce_s),
        obstacle_mps(options.obstacle_speed_mps > 0.0 ? options.obstacle_speed_mps : kUnknownSpeed * spec.speed_mps) {}
  [[nodiscard]] double horizon_s() const { return kHorizon * stop_s; }
  [[nodiscard]] double wary_s() const { return kWary * stop_s; }
  [[nodiscard]] double way_m() const { return obstacle_mps * stop_s; }
};

struct Mover {
  Vec3 apart_m;  ///< from it to the own place
  Vec3 velocity_mps;
  double speed_mps;
  double safe_m;
  double reach_m;
  bool column;
};

Vec3 seen(const Vec3& v, bool column) {
  return column ? Vec3(v.x(), v.y(), 0.0) : v;
}

using Movers = std::pmr::vector<Mover>;

Movers movers_of(const ControllerOptions& options, const VehicleSpec& spec, const Scene& scene, Scratch& scratch) {
  const Scale scale(options, spec);
  Movers movers(scratch.memory());
  movers.reserve(scene.tracks.size());
  for (const Track& t : scene.tracks) {
    if (t.fixed) continue;
    const double speed_mps = t.velocity_mps.norm();
    const double part = kReachStanding + (1.0 - kReachStanding) * std::min(1.0, speed_mps / scale.obstacle_mps);
    movers.push_back({seen(scene.position_m - t.position_m, t.column), seen(t.velocity_mps, t.column), speed_mps,
                      spec.radius_m + options.margin_m + t.radius_m, part * kReach * scale.way_m(), t.column});
  }
  return movers;
}

/// What is left of a velocity when it nears no mover too fast.
Vec3 held_off(const ControllerOptions& options, const VehicleSpec& spec, const Movers& movers, Vec3 wanted_mps,
              Scratch& scratch) {
  struct Bound {
    Vec3 towards;
    double most_mps;
  };
  const Scale scale(options, spec);
  std::pmr::vector<Bound> bounds(scratch.memory());
  bounds.reserve(movers.size());
  for (const Mover& mover : movers) {
    const double distance_m = mover.apart_m.norm();
    if (!(distance_m > 0.0)) continue;
    const Vec3 towards = -mover.apart_m / distance_m;
    const double room_m = distance_m - mover.safe_m - kStandoff * scale.way_m() - scale.wary_s() * mover.speed_mps;
    const double fastest_mps = std::max(options.obstacle_speed_mps, mover.speed_mps);
    double most_mps = room_m > 0.0 ? spec.speed_mps : std::max(-fastest_mps, room_m / (kReturn * scale.stop_s));
    if (room_m > 0.0 && spec.max_acceleration_mps2 > 0.0) {
      most_mps = std::sqrt(2.0 * spec.max_acceleration_mps2 * room_m);
    }
    bounds.push_back({towards, most_mps + std::min(0.0, mover.velocity_mps.dot(towards))});
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (const Bound& bound : bounds) {
      const double nearing_mps = wanted_mps.dot(bound.towards);
      if (nearing_mps > bound.most_mps) wanted_mps -= (nearing_mps - bound.most_mps) * bound.towards;
    }
  }
  return wanted_mps;
}

/// How far (m) a wish leads: slower than one second's acceleration it is taken to fade out at a goal (apf.hpp).
double lead_m(const VehicleSpec& spec, const Vec3& wish_mps) {
  const double speed_mps = wish_mps.norm();
  const double a = spec.max_acceleration_mps2;
  return speed_mps < a ? speed_mps / (1.0 - speed_mps / a) : kEndless_m;
}

/// The potential of what lies ahead with a velocity, held for `most_m`: 0 where nothing comes near. Once it is `enough`
/// it is not looked at further.
double threat(const VehicleSpec& spec, const Scale& scale, const Vec3& now_mps, const Movers& movers,
              const Vec3& tried_mps, double most_m, double enough) {
  const Vec3 change_mps = tried_mps - now_mps;
  const double horizon_s = scale.horizon_s();
  const double growth_mps = kGrowth * scale.obstacle_mps;
  const double a = spec.max_acceleration_mps2;
  const double turn_s = a > 0.0 ? change_mps.norm() / a : 0.0;
  std::array<Vec3, kLooks> ways_m;
  for (std::size_t k = 0; k < kLooks; ++k) {
    const double t_s = horizon_s / kLooks * static_cast<double>(k + 1);
    ways_m[k] = t_s < turn_s ? Vec3(t_s * now_mps + t_s * t_s / (2.0 * turn_s) * change_mps)
                             : Vec3(t_s * tried_mps - 0.5 * turn_s * change_mps);
    if (most_m < kEndless_m) ways_m[k] = clipped(ways_m[k], most_m);
  }
  double sum = 0.0;
  for (const Mover& mover : movers) {
    double worst = 0.0;
    for (std::size_t k = 0; k < kLooks; ++k) {
      const double t_s = horizon_s / kLooks * static_cast<double>(k + 1);
      const Vec3 apart_m = mover.apart_m + seen(ways_m[k], mover.column) - t_s * mover.velocity_mps;
      const double due_m = mover.safe_m + growth_mps * t_s;
      const double squared = apart_m.squaredNorm();
      if (squared >= (due_m + mover.reach_m) * (due_m + mover.reach_m)) continue;
      const double near = 1.0 - std::max(0.0, std::sqrt(squared) - due_m) / mover.reach_m;
      worst = std::max(worst, near * near * (1.0 - 0.5 * t_s / horizon_s));
      if (sum + worst >= enough) return sum + worst;
    }
    sum += worst;
    if (sum >= enough) return sum;
  }
  return sum;
}

/// Sixteen level directions, and ten up and down.
std::array<Vec3, 26> make_fan() {
  constexpr std::array<double, 4> quarter{1.0, kCosine, kDiagonal, kSine};
  std::array<Vec3, 26> fan;
  for (std::size_t k = 0; k < 4; ++k) {
    const double x = quarter[k];
    const double y = k == 0 ? 0.0 : quarter[4 - k];
    fan[4 * k] = Vec3(x, y, 0);
    fan[4 * k + 1] = Vec3(-y, x, 0);
    fan[4 * k + 2] = Vec3(-x, -y, 0);
    fan[4 * k + 3] = Vec3(y, -x, 0);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    fan[16 + k] = kDiagonal * (fan[k] + Vec3::UnitZ());
    fan[20 + k] = kDiagonal * (fan[k] - Vec3::UnitZ());
  }
  fan[24] = Vec3::UnitZ();
  fan[25] = -Vec3::UnitZ();
  return fan;
}

}  // namespace

double wary_speed_mps(const ControllerOptions& options, const VehicleSpec& spec) {
  const double u = options.obstacle_speed_mps;
  const double a = spec.max_acceleration_mps2;
  if (options.sensor_range_m <= 0.0 || u <= 0.0 || a <= 0.0) return spec.speed_mps;
  const double way_m = options.sensor_range_m - spec.radius_m - options.margin_m - Scale(options, spec).wary_s() * u;
  return std::clamp(std::sqrt(2.0 * a * std::max(0.0, way_m)) - u, kLeast * spec.speed_mps, spec.speed_mps);
}

Vec3 evading(const ControllerOptions& options, const VehicleSpec& spec, const Scene& scene, const Vec3& wanted_mps,
             bool level) {
  static const std::array<Vec3, 26> kFan = make_fan();
  const double wary_mps = wary_speed_mps(options, spec);
  Scratch scratch;
  const Movers movers = movers_of(options, spec, scene, scratch);
  Vec3 best_mps = wary_mps < spec.speed_mps ? clipped(wanted_mps, wary_mps) : wanted_mps;
  if (movers.empty()) return best_mps;
  best_mps = held_off(options, spec, movers, best_mps, scratch);
  if (level) best_mps.z() = 0.0;
  const Scale scale(options, spec);
  const double weight_mps = kWeight * spec.speed_mps;
  double least =
      weight_mps * threat(spec, scale, scene.velocity_mps, movers, best_mps, lead_m(spec, wanted_mps), kEndless_m);
  if (least <= 0.0) return best_mps;
  const Vec3 held_mps = best_mps;
  const auto consider = [&](const Vec3& tried_mps) {
    const double off = (tried_mps - held_mps).norm();
    if (off >= least) return;
    const double potential = off + weight_mps * threat(spec, scale, scene.velocity_mps, movers, tried_mps, kEndless_m,
                                                       (least - off) / weight_mps);
    if (potential >= least) return;
    least = potential;
    best_mps = tried_mps;
  };
  consider(Vec3::Zero());
  for (std::size_t k = 0; k < (level ? 16U : kFan.size()); ++k) {
    for (double part = 1.0; part <= kSpeeds; ++part) consider(part / kSpeeds * wary_mps * kFan[k]);
  }
  return best_mps;
}

}  // namespace skein
