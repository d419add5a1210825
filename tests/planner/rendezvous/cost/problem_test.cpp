#include "planner/rendezvous/cost/problem.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

TEST(Problem, IsMadeFromTheMission) {
  const Problem problem = make_problem(test::layout_a(7), 2);
  ASSERT_EQ(problem.participants.size(), 3U);
  EXPECT_EQ(problem.own().id, 2U);
  EXPECT_EQ(problem.zones.size(), 4U);
  EXPECT_EQ(problem.keep_out_m, 7.0);
  EXPECT_EQ(problem.seed, 7U);
  EXPECT_DOUBLE_EQ(problem.max_curvature_per_m, 0.002 * 0.999);
  // Start (-1, 10), slot (30 - 0.3, 15 - 0.6).
  const double chord_m = Vec2(30700.0, 4400.0).norm();
  EXPECT_DOUBLE_EQ(problem.own().hermite.chord_m(), chord_m);
  EXPECT_DOUBLE_EQ(problem.own().range_m.min, 0.03 * chord_m);
  EXPECT_DOUBLE_EQ(problem.own().range_m.max, 6.0 * chord_m);
}

TEST(Problem, SlotsTurnWithTheFormation) {
  Mission mission = test::open_field(1);
  mission.formation.heading_rad = 1.5707963267948966;
  const Problem problem = make_problem(mission, 1);  // slot (0.6, 0) km ahead, now to the north
  EXPECT_NEAR(problem.own().hermite.chord_m(), Vec2(28000.0, 20600.0).norm(), 1e-6);
}

TEST(Problem, ZonesAtOtherHeightsAreLeftOut) {
  Mission mission = test::layout_a(1);
  std::get<Cylinder>(mission.zones[0].shape).z_min_m = 100.0;
  std::get<Box>(mission.zones[2].shape).max_m.z() = -7.5;
  EXPECT_EQ(make_problem(mission, 1).zones.size(), 2U);
  std::get<Box>(mission.zones[2].shape).max_m.z() = -6.5;
  EXPECT_EQ(make_problem(mission, 1).zones.size(), 3U);
}

TEST(Problem, SeparationTakesHeightIntoAccount) {
  Problem problem = make_problem(test::layout_a(1), 1);
  EXPECT_DOUBLE_EQ(required_separation_m(problem.participants[0], problem.participants[1]), 200.0);
  problem.participants[1].altitude_m = 120.0;
  EXPECT_DOUBLE_EQ(required_separation_m(problem.participants[0], problem.participants[1]), 160.0);
  problem.participants[1].altitude_m = 300.0;
  EXPECT_EQ(required_separation_m(problem.participants[0], problem.participants[1]), 0.0);
}

void expect_refused(const std::function<void(Mission&)>& spoil, const char* said) {
  Mission mission = test::layout_a(1);
  spoil(mission);
  try {
    (void)make_problem(mission, 1);
    ADD_FAILURE() << "accepted, though: " << said;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
  }
}

TEST(Problem, BadMissionsAreRefused) {
  expect_refused([](Mission& m) { m.vehicles.erase(m.vehicles.begin()); }, "no vehicle 1");
  expect_refused([](Mission& m) { m.vehicles[1].start.climb_rad = 0.1; }, "climbs");
  expect_refused([](Mission& m) { m.vehicles[1].start.position_m.z() = 10.0; }, "altitude");
  expect_refused([](Mission& m) { m.vehicles[1].speed_mps = 40.0; }, "speed");
  expect_refused([](Mission& m) { m.vehicles[2].max_curvature_per_m = 0.0; }, "curvature");
  expect_refused([](Mission& m) { m.vehicles[2].radius_m = -1.0; }, "radius");
  expect_refused([](Mission& m) { m.vehicles[0].start.position_m = Vec3(30600.0, 15000.0, 0.0); }, "slot");
  expect_refused([](Mission& m) { std::swap(m.vehicles[1], m.vehicles[2]); }, "ascending");
  expect_refused([](Mission& m) { m.length_unit_m = 0.0; }, "length_unit_m");
  expect_refused([](Mission& m) { m.planner.particles = 1; }, "particles");
}

TEST(Problem, UnknownParticipantsAreRefused) {
  const Problem problem = make_problem(test::layout_a(1), 1);
  EXPECT_EQ(participant_of(problem, 3).id, 3U);
  EXPECT_THROW((void)participant_of(problem, 9), std::invalid_argument);
}

}  // namespace
}  // namespace skein::rendezvous
