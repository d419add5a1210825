// Sudden obstacles never appear where a vehicle cannot avoid them: the inequality, and braking against what appeared.
#include "simworld/movers/appearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "planner/core/random/random_stream.hpp"
#include "simworld/movers/movers.hpp"

namespace skein {
namespace {

constexpr double kStep_s = 0.1;

VehicleSpec spec_of(VehicleType type) {
  VehicleSpec spec;
  spec.type = type;
  spec.speed_mps = 10.0;
  spec.max_acceleration_mps2 = 4.0;
  spec.max_curvature_per_m = 0.05;
  spec.radius_m = 0.5;
  return spec;
}

TEST(Appearance, NeedsTheWayThatAVehicleNeedsToAvoidIt) {
  EXPECT_DOUBLE_EQ(least_appearance_m(spec_of(VehicleType::Multirotor), 10.0, 0.0, kStep_s), 1.0 + 12.5);
  EXPECT_DOUBLE_EQ(least_appearance_m(spec_of(VehicleType::Multirotor), 10.0, 2.0, kStep_s), 13.5 + 2.0 * 2.6);
  EXPECT_DOUBLE_EQ(least_appearance_m(spec_of(VehicleType::Multirotor), 0.0, 2.0, kStep_s), 0.2);
  // not a whole number of steps: 10.2 m/s is 25 steps of 0.4 m/s, and half of one
  const double last_m = (10.2 * 10.2 - 0.2 * 0.2) / 8.0 + 0.5 * 0.2 * kStep_s;
  EXPECT_DOUBLE_EQ(least_appearance_m(spec_of(VehicleType::Multirotor), 10.2, 0.0, kStep_s), 1.02 + last_m);
  EXPECT_DOUBLE_EQ(least_appearance_m(spec_of(VehicleType::Holonomic), 10.0, 1.0, kStep_s), 1.2);
  EXPECT_DOUBLE_EQ(least_appearance_m(spec_of(VehicleType::ConstantSpeed), 10.0, 0.0, kStep_s), 1.0 + 40.0);
}

/// Full braking as the vehicle's model flies it, step by step, straight on. The way (m).
double braking_way_m(double speed_mps, double acceleration_mps2) {
  double way_m = 0.0;
  while (speed_mps > 0.0) {
    const double next_mps = std::max(0.0, speed_mps - acceleration_mps2 * kStep_s);
    way_m += 0.5 * (speed_mps + next_mps) * kStep_s;
    speed_mps = next_mps;
  }
  return way_m;
}

Mover drawn_mover(RandomStream& stream) {
  Mover mover;
  mover.radius_m = stream.uniform(0.2, 3.0);
  mover.sudden = true;
  mover.at_s = stream.uniform(0.0, 5.0);
  mover.column = stream.uniform() < 0.3;
  for (Eigen::Index axis = 0; axis < 3; ++axis) mover.position_m[axis] = stream.uniform(-30.0, 30.0);
  if (stream.uniform() < 0.4) mover.ahead = AheadOf{1, stream.uniform(1.0, 40.0)};
  if (!mover.ahead && stream.uniform() < 0.5) mover.near_m = stream.uniform(5.0, 30.0);
  if (stream.uniform() < 0.5) {
    mover.motion = LineMotion{Vec3(stream.uniform(-4.0, 4.0), stream.uniform(-4.0, 4.0), 0.0)};
  }
  return mover;
}

/// Vehicles that fly about at random, 1 to `count`.
std::vector<Bystander> drawn_vehicles(RandomStream& stream, int count) {
  std::vector<Bystander> vehicles;
  for (int i = 1; i <= count; ++i) {
    Bystander vehicle;
    vehicle.spec = spec_of(VehicleType::Multirotor);
    vehicle.spec.id = static_cast<AgentId>(i);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      vehicle.position_m[axis] = stream.uniform(-30.0, 30.0);
      vehicle.velocity_mps[axis] = stream.uniform(-5.0, 5.0);
    }
    vehicle.in_the_air = stream.uniform() < 0.9;
    vehicles.push_back(vehicle);
  }
  return vehicles;
}

TEST(Appearance, NeverIsWhereBrakingIsTooLate) {
  int appeared = 0;
  int waited = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    RandomStream stream(seed, 1, Purpose::Test, 0);
    const Mover mover = drawn_mover(stream);
    std::vector<Bystander> vehicles = drawn_vehicles(stream, 4);
    Movers movers({mover}, {}, 0.0, seed, kStep_s);
    for (std::uint32_t step = 1; step <= 100; ++step) {
      movers.open(step, vehicles);
      const MoverRecord& record = movers.all()[0];
      if (record.appeared_step == step) {
        ++appeared;
        waited += kStep_s * (step - 2) > mover.at_s ? 1 : 0;
        for (const Bystander& vehicle : vehicles) {
          if (!vehicle.in_the_air) continue;
          const double speed_mps = vehicle.velocity_mps.norm();
          const double apart_m =
              distance_m(vehicle.position_m, record.position_m, mover.column) - vehicle.spec.radius_m - mover.radius_m;
          // One step as before, and then full braking; the obstacle comes nearer meanwhile.
          const double way_m = braking_way_m(speed_mps, 4.0);
          EXPECT_GT(apart_m, way_m) << "seed " << seed;
          EXPECT_GT(apart_m, least_appearance_m(vehicle.spec, speed_mps, speed_of(mover), kStep_s));
        }
        break;
      }
      for (Bystander& vehicle : vehicles) vehicle.position_m += kStep_s * vehicle.velocity_mps;
    }
  }
  EXPECT_GT(appeared, 1000);
  EXPECT_GT(waited, 100) << "the rule kept none waiting";
}

}  // namespace
}  // namespace skein
