#include "idl/convert/parts.hpp"

#include <stdexcept>
#include <string>

namespace skein {

wire::Header wire_head(std::uint64_t run, std::int64_t stamp_ns, AgentId sender, std::uint32_t incarnation) {
  wire::Header head;
  head.run(run);
  head.stamp_ns(stamp_ns);
  head.sender(sender);
  head.incarnation(incarnation);
  return head;
}

wire::Point3 wire_point(const Vec3& point) {
  wire::Point3 out;
  out.x(point.x());
  out.y(point.y());
  out.z(point.z());
  return out;
}

wire::DirectedPoint wire_pose(const Pose& pose) {
  wire::DirectedPoint out;
  out.position_m(wire_point(pose.position_m));
  out.heading_rad(pose.heading_rad);
  out.climb_rad(pose.climb_rad);
  return out;
}

Vec3 plain_point(const wire::Point3& point) {
  return {point.x(), point.y(), point.z()};
}

Pose plain_pose(const wire::DirectedPoint& pose) {
  return {plain_point(pose.position_m()), pose.heading_rad(), pose.climb_rad()};
}

std::vector<wire::Sighting> wire_tracks(const std::vector<Track>& tracks) {
  std::vector<wire::Sighting> out(tracks.size());
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    out[i].id(tracks[i].id);
    out[i].position_m(wire_point(tracks[i].position_m));
    out[i].velocity_mps(wire_point(tracks[i].velocity_mps));
    out[i].radius_m(tracks[i].radius_m);
    out[i].column(tracks[i].column);
    out[i].immobile(tracks[i].fixed);
  }
  return out;
}

std::vector<Track> plain_tracks(const std::vector<wire::Sighting>& tracks) {
  std::vector<Track> out;
  for (const wire::Sighting& track : tracks) {
    out.push_back({track.id(), plain_point(track.position_m()), plain_point(track.velocity_mps()), track.radius_m(),
                   track.column(), track.immobile()});
  }
  return out;
}

void require_bound(std::size_t size, std::size_t bound, const char* what) {
  if (size <= bound) return;
  throw std::invalid_argument(std::string(what) + " has " + std::to_string(size) + " elements; the wire takes " +
                              std::to_string(bound));
}

}  // namespace skein
