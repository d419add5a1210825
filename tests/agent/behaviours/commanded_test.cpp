// An agent that was commanded: circles of least radius that close, braking, points, the ground, and back to the
// mission.
#include "agent/behaviours/commanded.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/core/geometry/frames.hpp"
#include "simworld/vehicles/multirotor.hpp"

namespace skein {
namespace {

/// Flies straight on, and counts its rounds.
class Straightforward final : public Behaviour {
 public:
  explicit Straightforward(int& rounds) : rounds_(rounds) {}
  [[nodiscard]] bool can_use(const Representative& /*peer*/) const override { return true; }
  RoundOutput on_round(const RoundInput& input) override {
    ++rounds_;
    RoundOutput out;
    out.mode = AgentMode::Flying;
    out.commanded_velocity_mps = input.sense->velocity_mps;
    return out;
  }
  void add_to(StateHash& hash) const override { hash.add(rounds_); }

 private:
  int& rounds_;
};

Mission mission_of(VehicleType type) {
  Mission mission;
  mission.name = "one";
  mission.step_s = 0.5;
  VehicleSpec vehicle;
  vehicle.id = 1;
  vehicle.type = type;
  vehicle.start = {Vec3(10.0, 20.0, 40.0), 0.7, 0.0};
  vehicle.speed_mps = type == VehicleType::ConstantSpeed ? 50.0 : 8.0;
  vehicle.max_curvature_per_m = 0.01;
  vehicle.radius_m = 1.0;
  vehicle.max_acceleration_mps2 = type == VehicleType::ConstantSpeed ? 0.0 : 4.0;
  mission.vehicles = {vehicle};
  return mission;
}

/// One vehicle and its agent, by hand.
struct Flight {
  explicit Flight(VehicleType type)
      : mission(mission_of(type)),
        spec(mission.vehicles[0]),
        state(initial_state(spec)),
        agent(mission, 1, std::make_unique<Straightforward>(rounds)) {
    state.velocity_mps = spec.speed_mps * direction_of(spec.start);
  }
  void step() {
    Tick tick;
    tick.phase = Phase::Flying;
    tick.step = ++steps;
    tick.round = steps;
    Sense sense;
    sense.pose = pose_of(state);
    if (state.velocity_mps.head<2>().norm() < 1e-9) sense.pose.heading_rad = heading_rad;
    heading_rad = sense.pose.heading_rad;
    sense.velocity_mps = state.velocity_mps;
    out = agent.on_round({tick, &sense});
    state = advance_vehicle(spec, state, out.commanded_velocity_mps, mission.step_s).after;
  }
  void order(OrderKind kind, const Vec3& to_m = Vec3::Zero()) { agent.obey({1, kAllAgents, kind, to_m, 0.0}); }

  int rounds = 0;
  Mission mission;
  VehicleSpec spec;
  VehicleState state;
  CommandedBehaviour agent;
  RoundOutput out;
  std::uint32_t steps = 0;
  double heading_rad = 0.0;
};

TEST(Circle, IsTheLeastThatClosesInWholeStepsAndEndsWhereItBegan) {
  const Mission mission = mission_of(VehicleType::ConstantSpeed);
  const VehicleSpec& spec = mission.vehicles[0];
  for (const double climb_rad : {0.0, 0.3}) {
    for (const double side : {1.0, -1.0}) {
      const Pose from{Vec3(1.0, 2.0, 300.0), 2.0, climb_rad};
      Circle circle(spec, mission.step_s, from, side);
      VehicleState state{from.position_m, spec.speed_mps * direction_of(from)};
      const double turn_rad = spec.max_curvature_per_m * spec.speed_mps * mission.step_s;
      EXPECT_GE(circle.radius_m(), 1.0 / spec.max_curvature_per_m * (1.0 - 1e-12));
      EXPECT_LE(circle.radius_m(), (1.0 + turn_rad / (2.0 * 3.141592653589793 - turn_rad)) / spec.max_curvature_per_m);
      double farthest_m = 0.0;
      for (std::uint32_t k = 0; k < circle.steps(); ++k) {
        state = advance_constant_speed(spec, state, circle.command_mps(), mission.step_s).after;
        EXPECT_NEAR((state.position_m - circle.place_m(k + 1)).norm(), 0.0, 1e-6);
        farthest_m = std::max(farthest_m, (state.position_m - from.position_m).norm());
      }
      EXPECT_TRUE(circle.closed());
      EXPECT_NEAR((state.position_m - from.position_m).norm(), 0.0, 1e-6);
      EXPECT_NEAR((state.velocity_mps - spec.speed_mps * direction_of(from)).norm(), 0.0, 1e-6);
      EXPECT_NEAR(farthest_m, 2.0 * circle.radius_m(), 0.1 * circle.radius_m());
    }
  }
}

TEST(Commanded, IsItsMissionsBehaviourUntilACommand) {
  Flight flight(VehicleType::ConstantSpeed);
  flight.order(OrderKind::Resume);
  StateHash own;
  StateHash bare;
  for (int i = 0; i < 5; ++i) flight.step();
  flight.agent.add_to(own);
  bare.add(5);
  EXPECT_EQ(flight.rounds, 5);
  EXPECT_EQ(flight.out.mode, AgentMode::Flying);
  EXPECT_EQ(own.value(), bare.value());
}

TEST(Commanded, AConstantSpeedVehicleCirclesAndGoesOnWhereItLeft) {
  Flight flight(VehicleType::ConstantSpeed);
  for (int i = 0; i < 3; ++i) flight.step();
  const VehicleState left = flight.state;
  flight.order(OrderKind::Hold);
  for (int i = 0; i < 10; ++i) {
    flight.step();
    EXPECT_EQ(flight.out.mode, AgentMode::Holding);
  }
  flight.order(OrderKind::Resume);
  int more = 0;
  while (flight.rounds == 3 && more < 200) {
    const VehicleState before = flight.state;
    flight.step();
    ++more;
    if (flight.rounds > 3) {
      EXPECT_NEAR((before.position_m - left.position_m).norm(), 0.0, 1e-6);
    }
  }
  EXPECT_EQ(flight.out.mode, AgentMode::Flying);
  EXPECT_LT(more, 30);
}

TEST(Commanded, AMultirotorBrakesAndHoversAndGoesOn) {
  Flight flight(VehicleType::Multirotor);
  flight.step();
  const Vec3 from_m = flight.state.position_m;
  flight.order(OrderKind::Hold);
  for (int i = 0; i < 60; ++i) flight.step();
  EXPECT_EQ(flight.out.mode, AgentMode::Holding);
  EXPECT_LT(flight.state.velocity_mps.norm(), 1e-3);
  EXPECT_LT((flight.state.position_m - from_m).norm(), 2.0 * 8.0 * 8.0 / 4.0);
  flight.order(OrderKind::Resume);
  flight.step();
  EXPECT_EQ(flight.out.mode, AgentMode::Flying);
  EXPECT_EQ(flight.rounds, 2);
}

TEST(Commanded, AMultirotorFliesToThePointHoldsThereAndComesBack) {
  Flight flight(VehicleType::Multirotor);
  flight.step();
  const Vec3 to_m(60.0, -10.0, 30.0);
  flight.order(OrderKind::Goto, to_m);
  flight.step();
  EXPECT_EQ(flight.out.mode, AgentMode::GoingTo);
  for (int i = 0; i < 120; ++i) flight.step();
  EXPECT_EQ(flight.out.mode, AgentMode::Holding);
  EXPECT_LT((flight.state.position_m - to_m).norm(), 0.6);
  flight.order(OrderKind::Resume);
  for (int i = 0; i < 120 && flight.rounds == 1; ++i) flight.step();
  EXPECT_EQ(flight.out.mode, AgentMode::Flying);
}

TEST(Commanded, AConstantSpeedVehicleComesBackToWhereItLeft) {
  for (const Vec3& to_m : {Vec3(3000.0, -500.0, 0.0), Vec3(-900.0, 20.0, 0.0), Vec3(10.0, 300.0, 0.0)}) {
    Flight flight(VehicleType::ConstantSpeed);
    flight.step();
    const VehicleState left = flight.state;
    flight.order(OrderKind::Goto, to_m);
    for (int i = 0; i < 250; ++i) flight.step();
    EXPECT_EQ(flight.out.mode, AgentMode::Holding);
    EXPECT_LT((flight.state.position_m - to_m).head<2>().norm(), 500.0);
    flight.order(OrderKind::Resume);
    VehicleState before = flight.state;
    for (int i = 0; i < 400 && flight.rounds == 1; ++i) {
      before = flight.state;
      flight.step();
    }
    EXPECT_EQ(flight.out.mode, AgentMode::Flying);
    EXPECT_LT((before.position_m - left.position_m).norm(), 15.0);
    EXPECT_LT((before.velocity_mps - left.velocity_mps).norm(), 0.15 * 50.0);
  }
}

TEST(Commanded, LandsAndStaysDown) {
  for (const VehicleType type : {VehicleType::Multirotor, VehicleType::ConstantSpeed}) {
    Flight flight(type);
    flight.order(OrderKind::Land);
    flight.step();
    EXPECT_EQ(flight.out.mode, AgentMode::Landing);
    for (int i = 0; i < 200 && flight.out.mode != AgentMode::Landed; ++i) {
      flight.step();
      ASSERT_GT(flight.state.position_m.z(), 0.0);
    }
    EXPECT_EQ(flight.out.mode, AgentMode::Landed);
    EXPECT_EQ(flight.out.commanded_velocity_mps, Vec3::Zero());
    flight.order(OrderKind::Resume);
    flight.step();
    EXPECT_EQ(flight.out.mode, AgentMode::Landed);
    EXPECT_EQ(flight.rounds, 0);
  }
}

}  // namespace
}  // namespace skein
