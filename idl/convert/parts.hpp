// The parts that several samples share, between plain value and wire. Parts from the wire are checked before.
#pragma once

#include "idl/convert/convert.hpp"

namespace skein {

[[nodiscard]] wire::Header wire_head(std::uint64_t run, std::int64_t stamp_ns, AgentId sender,
                                     std::uint32_t incarnation);
[[nodiscard]] wire::Point3 wire_point(const Vec3& point);
[[nodiscard]] wire::DirectedPoint wire_pose(const Pose& pose);
[[nodiscard]] Vec3 plain_point(const wire::Point3& point);
[[nodiscard]] Pose plain_pose(const wire::DirectedPoint& pose);

[[nodiscard]] std::vector<wire::Sighting> wire_tracks(const std::vector<Track>& tracks);
[[nodiscard]] std::vector<Track> plain_tracks(const std::vector<wire::Sighting>& tracks);

[[nodiscard]] wire::RendezvousPlanner wire_options(const RendezvousOptions& options);
[[nodiscard]] RendezvousOptions plain_options(const wire::RendezvousPlanner& options);

/// @throws std::invalid_argument if size > bound.
void require_bound(std::size_t size, std::size_t bound, const char* what);

}  // namespace skein
