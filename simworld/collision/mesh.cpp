#include "simworld/collision/mesh.hpp"

#include <fcl/fcl.h>

#include <algorithm>
#include <stdexcept>

namespace skein {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSS<double>>;
using Object = fcl::CollisionObject<double>;

constexpr double kThread_m = 1e-4;  // radius of the capsule that stands for a segment
constexpr double kTouch_m = 1e-5;   // by which a box is shrunk, so that touching faces do not count

Box bounds_of(const std::vector<Vec3>& points_m) {
  Box box{points_m.front(), points_m.front()};
  for (const Vec3& p : points_m) {
    box.min_m = box.min_m.cwiseMin(p);
    box.max_m = box.max_m.cwiseMax(p);
  }
  return box;
}

/// A turn that takes the z axis to the unit vector `axis`.
fcl::Matrix3<double> frame_along(const Vec3& axis) {
  const Vec3 aside = std::fabs(axis.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
  const Vec3 x = aside.cross(axis).normalized();
  fcl::Matrix3<double> frame;
  frame << x, axis.cross(x), axis;
  return frame;
}

}  // namespace

struct Mesh::Parts {
  std::vector<Vec3> points_m;
  std::vector<Triangle> triangles;
  Box bounds;
  std::shared_ptr<Model> model;
};

Mesh::Mesh(std::vector<Vec3> points_m, std::vector<Triangle> triangles) {
  if (triangles.empty()) throw std::invalid_argument("a mesh needs at least one triangle");
  auto parts = std::make_shared<Parts>();
  std::vector<fcl::Triangle> faces;
  for (const Triangle& t : triangles) {
    for (const std::uint32_t corner : t) {
      if (corner >= points_m.size() || !points_m[corner].allFinite()) {
        throw std::invalid_argument("a triangle of a mesh has no such corner");
      }
    }
    faces.emplace_back(t[0], t[1], t[2]);
  }
  parts->bounds = bounds_of(points_m);
  parts->model = std::make_shared<Model>();
  parts->model->beginModel(static_cast<int>(faces.size()), static_cast<int>(points_m.size()));
  parts->model->addSubModel(points_m, faces);
  parts->model->endModel();
  parts->points_m = std::move(points_m);
  parts->triangles = std::move(triangles);
  parts_ = std::move(parts);
}

const Box& Mesh::bounds() const {
  return parts_->bounds;
}

std::size_t Mesh::triangles() const {
  return parts_->triangles.size();
}

bool Mesh::overlaps(const Box& box) const {
  const Vec3 size_m = box.max_m - box.min_m - Vec3::Constant(2.0 * kTouch_m);
  if (size_m.minCoeff() <= 0.0) return false;
  const Object surface(parts_->model);
  const Object other(std::make_shared<fcl::Box<double>>(size_m), fcl::Matrix3<double>::Identity(),
                     Vec3(0.5 * (box.min_m + box.max_m)));
  fcl::CollisionResult<double> result;
  return fcl::collide(&surface, &other, fcl::CollisionRequest<double>(), result) > 0;
}

double Mesh::distance_m(const Vec3& a, const Vec3& b) const {
  const Object surface(parts_->model);
  const double length_m = (b - a).norm();
  const bool stands = length_m < kThread_m;
  std::shared_ptr<fcl::CollisionGeometry<double>> thread;
  if (stands) {
    thread = std::make_shared<fcl::Sphere<double>>(kThread_m);
  } else {
    thread = std::make_shared<fcl::Capsule<double>>(kThread_m, length_m);
  }
  const fcl::Matrix3<double> turn =
      stands ? fcl::Matrix3<double>(fcl::Matrix3<double>::Identity()) : frame_along((b - a) / length_m);
  const Object segment(thread, turn, Vec3(0.5 * (a + b)));
  fcl::DistanceRequest<double> request;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  fcl::DistanceResult<double> result;
  const double distance_m = fcl::distance(&surface, &segment, request, result);
  return distance_m <= 0.0 ? 0.0 : distance_m + kThread_m;
}

bool Mesh::operator==(const Mesh& other) const {
  return parts_ == other.parts_ ||
         (parts_->points_m == other.parts_->points_m && parts_->triangles == other.parts_->triangles);
}

}  // namespace skein
