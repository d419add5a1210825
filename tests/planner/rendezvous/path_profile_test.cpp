#include "planner/rendezvous/path_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

/// From (0, 0) straight along x to (4, 0) km.
Mission straight_way() {
  Mission mission = test::open_field(1);
  mission.vehicles.resize(1);
  mission.formation = {Vec3(4000.0, 0.0, 0.0), 0.0, 0.0};
  mission.vehicles[0].start = {Vec3::Zero(), 0.0, 0.0};
  mission.vehicles[0].slot_offset_m = Vec3::Zero();
  return mission;
}

TEST(PathProfile, OfAStraightWayByHand) {
  const auto profile = path_profile(straight_way(), {1, {4000.0, 4000.0}}, 5);
  ASSERT_EQ(profile.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(profile[k].arc_m, 1000.0 * static_cast<double>(k), 1e-6);
    EXPECT_NEAR((profile[k].position_m - Vec3(profile[k].arc_m, 0.0, 0.0)).norm(), 0.0, 1e-6);
    EXPECT_NEAR(profile[k].curvature_per_m, 0.0, 1e-12);
    EXPECT_EQ(profile[k].torsion_per_m, 0.0);
  }
}

TEST(PathProfile, InSpaceStepsAreAsLongAsTheArcAndTurnByTheCurvature) {
  const Mission mission = test::layout_space(1);
  for (const VehicleSpec& vehicle : mission.vehicles) {
    const auto profile = path_profile(mission, {vehicle.id, {60000.0, 60000.0}}, 2001);
    EXPECT_NEAR((profile.front().position_m - vehicle.start.position_m).norm(), 0.0, 1e-6);
    EXPECT_NEAR((profile.back().position_m - slot_pose(mission, vehicle).position_m).norm(), 0.0, 1e-6);
    double most_torsion_per_m = 0.0;
    for (std::size_t k = 1; k + 1 < profile.size(); ++k) {
      const double step_m = profile[k].arc_m - profile[k - 1].arc_m;
      const Vec3 bend = profile[k + 1].position_m - 2.0 * profile[k].position_m + profile[k - 1].position_m;
      EXPECT_NEAR(bend.norm() / (step_m * step_m), profile[k].curvature_per_m, 1e-6);
      most_torsion_per_m = std::max(most_torsion_per_m, std::fabs(profile[k].torsion_per_m));
    }
    EXPECT_GT(most_torsion_per_m, 1e-6);
  }
}

TEST(PathProfile, RefusesWhatIsNoPlan) {
  EXPECT_THROW((void)path_profile(straight_way(), {1, {4000.0}}, 5), std::invalid_argument);
  EXPECT_THROW((void)path_profile(straight_way(), {9, {4000.0, 4000.0}}, 5), std::invalid_argument);
  EXPECT_THROW((void)path_profile(straight_way(), {1, {4000.0, 4000.0}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace skein::rendezvous
