// Each mode and reason of the run-time monitor, and which one wins.
#include "agent/monitor/monitor.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace skein {
namespace {

constexpr double kSafe_m = 4.0;

/// A UAV at the origin that flies east at 10 m/s, on its plan, alone.
struct Flight {
  ControllerOptions options;
  std::vector<Neighbour> neighbours;
  std::vector<double> safe_m;
  Situation now;

  Flight() {
    options.horizon_s = 5.0;
    options.deviation_m = 10.0;
    now.velocity_mps = Vec3(10.0, 0.0, 0.0);
    now.reference_m = Vec3::Zero();
  }
  void meet(const Vec3& position_m, const Vec3& velocity_mps) {
    neighbours.push_back({7, position_m, velocity_mps, 0.5, 4.0});
    safe_m.push_back(kSafe_m);
  }
  [[nodiscard]] Watch watch() {
    now.neighbours = neighbours;
    now.safe_m = safe_m;
    return skein::watch(options, now);
  }
  void expect(SafetyMode mode, SafetyReason reason) {
    const Watch found = watch();
    EXPECT_EQ(found.mode, mode);
    EXPECT_EQ(found.reason, reason);
  }
};

TEST(Monitor, AFlightByPlanIsAutonomous) {
  Flight flight;
  EXPECT_EQ(flight.watch(), (Watch{SafetyMode::Autonomous, SafetyReason::None, 0.0, 1e6}));
}

TEST(Monitor, PredictsTheSeparationOfStraightLinesWithinTheHorizon) {
  Flight flight;
  flight.meet(Vec3(80.0, 6.0, 0.0), Vec3(-10.0, 0.0, 0.0));  // passes 6 m aside after 4 s
  EXPECT_NEAR(flight.watch().predicted_separation_m, 6.0, 1e-9);
  flight.expect(SafetyMode::Autonomous, SafetyReason::None);
  flight.meet(Vec3(200.0, 0.0, 0.0), Vec3(-10.0, 0.0, 0.0));  // meets head on, after the horizon
  EXPECT_NEAR(flight.watch().predicted_separation_m, 6.0, 1e-9);
  flight.expect(SafetyMode::Autonomous, SafetyReason::None);
  flight.options.horizon_s = 9.9;
  EXPECT_NEAR(flight.watch().predicted_separation_m, 2.0, 1e-9);
  flight.expect(SafetyMode::Controlled, SafetyReason::Peer);
}

TEST(Monitor, APeerIsTooCloseJustUnderTheSeparationToKeep) {
  Flight at;
  at.meet(Vec3(50.0, kSafe_m, 0.0), Vec3::Zero());
  at.expect(SafetyMode::Autonomous, SafetyReason::None);
  Flight under;
  under.meet(Vec3(50.0, kSafe_m - 1e-6, 0.0), Vec3::Zero());
  under.expect(SafetyMode::Controlled, SafetyReason::Peer);
}

TEST(Monitor, MeasuresTheDeviationFromThePlan) {
  Flight flight;
  flight.now.reference_m = Vec3(6.0, 8.0, 0.0);
  EXPECT_EQ(flight.watch().deviation_m, 10.0);
  flight.expect(SafetyMode::Autonomous, SafetyReason::None);
  flight.now.reference_m = Vec3(6.0, 8.0, 0.5);
  flight.expect(SafetyMode::Controlled, SafetyReason::Deviation);
}

TEST(Monitor, EachReasonComesBeforeThoseThatMatterLess) {
  Flight flight;
  flight.now.stale_peer = true;
  flight.expect(SafetyMode::Controlled, SafetyReason::StalePeer);
  flight.now.reference_m = Vec3(100.0, 0.0, 0.0);
  flight.expect(SafetyMode::Controlled, SafetyReason::Deviation);
  flight.now.steering.overruled = true;
  flight.expect(SafetyMode::Controlled, SafetyReason::Obstacle);
  flight.meet(Vec3(20.0, 0.0, 0.0), Vec3::Zero());
  flight.expect(SafetyMode::Controlled, SafetyReason::Peer);
  flight.now.zone_unconfirmed = true;
  flight.expect(SafetyMode::Controlled, SafetyReason::Unconfirmed);
  flight.now.replanning = true;
  flight.expect(SafetyMode::Hold, SafetyReason::Replanning);
  flight.now.has_plan = false;
  flight.expect(SafetyMode::Hold, SafetyReason::NoPlan);
}

TEST(Monitor, SaysHowFarAndHowCloseInEveryMode) {
  Flight flight;
  flight.now.has_plan = false;
  flight.now.reference_m = Vec3(3.0, 4.0, 0.0);
  flight.meet(Vec3(0.0, 9.0, 0.0), Vec3(10.0, 0.0, 0.0));
  EXPECT_EQ(flight.watch().deviation_m, 5.0);
  EXPECT_NEAR(flight.watch().predicted_separation_m, 9.0, 1e-9);
}

}  // namespace
}  // namespace skein
