// The closed forms of distance against FCL, a library written for it: static distances, and motions against dense
// sampling. FCL's cylinder stands on the origin and its box is centred, hence the shifts.
#include <fcl/fcl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "planner/core/geometry/closest_approach.hpp"
#include "planner/core/geometry/distance.hpp"
#include "planner/core/random/random_stream.hpp"
#include "simworld/collision/clearance.hpp"
#include "tests/simworld/missions.hpp"

namespace skein {
namespace {

using Object = fcl::CollisionObject<double>;
constexpr int kCases = 100000;

Object placed(std::shared_ptr<fcl::CollisionGeometry<double>> shape, const Vec3& at_m) {
  fcl::Transform3<double> transform = fcl::Transform3<double>::Identity();
  transform.translation() = at_m;
  return Object(std::move(shape), transform);
}

Object sphere(double radius_m, const Vec3& at_m) {
  return placed(std::make_shared<fcl::Sphere<double>>(radius_m), at_m);
}

Object fcl_of(const Box& box) {
  const Vec3 size_m = box.max_m - box.min_m;
  return placed(std::make_shared<fcl::Box<double>>(size_m), 0.5 * (box.min_m + box.max_m));
}

Object fcl_of(const Cylinder& cylinder) {
  const Vec3 middle_m(cylinder.centre_m.x(), cylinder.centre_m.y(), 0.5 * (cylinder.z_min_m + cylinder.z_max_m));
  return placed(std::make_shared<fcl::Cylinder<double>>(cylinder.radius_m, cylinder.z_max_m - cylinder.z_min_m),
                middle_m);
}

/// Distance (m) of two bodies that are apart; not positive when they touch.
double fcl_distance_m(const Object& a, const Object& b) {
  fcl::DistanceRequest<double> request;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.distance_tolerance = 1e-9;
  fcl::DistanceResult<double> result;
  return fcl::distance(&a, &b, request, result);
}

class Draw {
 public:
  explicit Draw(std::uint64_t index) : random_(21, 1, Purpose::Test, index) {}

  double within(double low, double high) { return random_.uniform(low, high); }
  Vec3 point(double reach_m) {
    return {within(-reach_m, reach_m), within(-reach_m, reach_m), within(-reach_m, reach_m)};
  }
  Box box() {
    const Vec3 low = point(20.0);
    return {low, low + Vec3(within(0.5, 20.0), within(0.5, 20.0), within(0.5, 20.0))};
  }
  Cylinder cylinder() {
    const double low_m = within(-20.0, 10.0);
    return {Vec2(within(-20.0, 20.0), within(-20.0, 20.0)), within(0.5, 15.0), low_m, low_m + within(0.5, 20.0)};
  }

 private:
  RandomStream random_;
};

TEST(FclProperty, SphereAndSphere) {
  Draw draw(1);
  for (int i = 0; i < kCases; ++i) {
    const Vec3 a = draw.point(30.0);
    const Vec3 b = draw.point(30.0);
    const double r_m = draw.within(0.1, 2.0);
    const double s_m = draw.within(0.1, 2.0);
    const double ours_m = closest_approach(a, a, b, b).distance_m - r_m - s_m;
    if (ours_m > 0.0) {
      ASSERT_NEAR(fcl_distance_m(sphere(r_m, a), sphere(s_m, b)), ours_m, 1e-9) << i;
    } else {
      ASSERT_LE(fcl_distance_m(sphere(r_m, a), sphere(s_m, b)), 1e-9) << i;
    }
  }
}

/// Where both say 'apart' the distances agree; where one says 'touching', the other one is within the tolerance.
template <typename Shape>
void expect_agreement(const Shape& shape, const Vec3& p, double radius_m, double tolerance_m, int i) {
  const double ours_m = signed_distance(p, shape) - radius_m;
  const double fcls_m = fcl_distance_m(sphere(radius_m, p), fcl_of(shape));
  ASSERT_NEAR(std::max(fcls_m, 0.0), std::max(ours_m, 0.0), tolerance_m) << "case " << i << " at " << p.transpose();
}

TEST(FclProperty, SphereAndBox) {
  Draw draw(2);
  for (int i = 0; i < kCases; ++i) expect_agreement(draw.box(), draw.point(40.0), draw.within(0.1, 2.0), 1e-6, i);
}

TEST(FclProperty, SphereAndCylinder) {
  Draw draw(3);
  for (int i = 0; i < kCases; ++i) expect_agreement(draw.cylinder(), draw.point(40.0), draw.within(0.1, 2.0), 1e-6, i);
}

/// A random step of a vehicle, an arc in space.
Motion random_motion(Draw& draw) {
  const VehicleSpec spec = test::vehicle(1, Vec3::Zero(), 0.0, Vec3::Zero());
  const VehicleState state{draw.point(20.0), 10.0 * draw.point(1.0).normalized()};
  return advance_constant_speed(spec, state, draw.point(1.0), draw.within(0.3, 1.5)).motion;
}

/// The place at a fraction of the step, straight between the points of the motion.
Vec3 place_at(const Motion& motion, double fraction) {
  const double parts = fraction * (kMotionPoints - 1);
  const auto i = std::min(static_cast<std::size_t>(parts), kMotionPoints - 2);
  return motion.points_m[i] + (parts - static_cast<double>(i)) * (motion.points_m[i + 1] - motion.points_m[i]);
}

/// Least distance that FCL finds at 401 moments; sampling can only miss, by half a sample's way at most.
template <typename Other>
double sampled_m(const Motion& motion, double radius_m, const Other& other_at) {
  double least_m = 1e9;
  for (int k = 0; k <= 400; ++k) {
    const double fraction = k / 400.0;
    least_m = std::min(least_m, fcl_distance_m(sphere(radius_m, place_at(motion, fraction)), other_at(fraction)));
  }
  return std::max(least_m, 0.0);
}

TEST(FclProperty, MotionsAgainstDenseSampling) {
  Draw draw(4);
  constexpr double kRadius_m = 0.01;
  constexpr double kMissed_m = 0.05;  // 15 m at most in 400 parts, twice that for two vehicles
  for (int i = 0; i < 150; ++i) {
    const Motion a = random_motion(draw);
    const Motion b = random_motion(draw);
    const double apart_m = std::max(separation_m(a, b) - 2.0 * kRadius_m, 0.0);
    const double apart_sampled_m =
        sampled_m(a, kRadius_m, [&](double fraction) { return sphere(kRadius_m, place_at(b, fraction)); });
    ASSERT_LE(apart_m, apart_sampled_m + 1e-6) << i;
    ASSERT_GE(apart_m, apart_sampled_m - kMissed_m) << i;

    const Box box = draw.box();
    const Cylinder cylinder = draw.cylinder();
    const auto expect_clear = [&](const Zone& zone, const Object& object) {
      const double clear_m = std::max(clearance_m(a, zone) - kRadius_m, 0.0);
      const double clear_sampled_m = sampled_m(a, kRadius_m, [&](double) { return object; });
      ASSERT_LE(clear_m, clear_sampled_m + 1e-6) << i;
      ASSERT_GE(clear_m, clear_sampled_m - kMissed_m) << i;
    };
    expect_clear({box, false}, fcl_of(box));
    expect_clear({cylinder, true}, fcl_of(cylinder));
  }
}

}  // namespace
}  // namespace skein
