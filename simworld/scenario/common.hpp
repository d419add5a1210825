// What scenarios of all kinds have in common: points, bodies, zones, terrain, lockstep and world options.
//
// Source: docs/scenario.md. Departs from source: none. Complexity: O(values).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "simworld/scenario/reader.hpp"
#include "simworld/scenario/scenario.hpp"

namespace skein::scenario {

using Keys = std::string_view;

inline constexpr Limits kCoordinate{-1e7, 1e7, "m"};
inline constexpr Limits kHeight{-kUnboundedZ_m, kUnboundedZ_m, "m"};
inline constexpr Limits kExtent{1e-3, 1e6, "m"};
inline constexpr std::size_t kMaxZones = 256;    // of each list
inline constexpr std::size_t kMaxHidden = 1000;  // hidden obstacles that are listed

[[nodiscard]] AgentId read_id(const MapReader& reader);
/// x_m, y_m, and z_m, which is 0 if left out.
[[nodiscard]] Vec3 read_point(const MapReader& reader);
/// name, kind, seed and step_s. @param seed replaces the file's
void read_head(const MapReader& root, std::optional<std::uint64_t> seed, Mission& mission);
[[nodiscard]] OnAgentLoss read_on_agent_loss(const MapReader& vehicles);
/// radius_m and safety_radius_m.
void read_body(const MapReader& vehicles, VehicleSpec& spec);
/// @throws ReadFault if the safety radius is less than the body's
void check_body(const MapReader& vehicles, const VehicleSpec& spec);
/// z_min_m and z_max_m, each as it is if left out.
void read_heights(const MapReader& item, double& z_min_m, double& z_max_m);
[[nodiscard]] Cylinder read_cylinder(const MapReader& item);
[[nodiscard]] Box read_box(const MapReader& item);
/// Obstacles are cylinders, or boxes if they have x_min_m; no-fly zones are boxes, or cylinders if they have radius_m.
void read_zones(const MapReader& root, std::string_view list, bool no_fly, std::vector<Zone>& zones);
/// The constants of Eq. 13 of papers/001 under a key that is there.
[[nodiscard]] Terrain read_terrain_map(const MapReader& parent, std::string_view key, double length_unit_m);
/// The sections lockstep and world.
void read_lockstep_and_world(const MapReader& root, Scenario& into);

/// The numbers of an option aggregate, each with its range; what is left out stays as it is.
template <typename Options, std::size_t N>
void read_fields(const MapReader& map, const std::array<OptionField<Options>, N>& fields, Options& options) {
  for (const OptionField<Options>& field : fields) {
    options.*field.member = map.number(field.key, {field.min, field.max, field.unit}, options.*field.member);
  }
}

}  // namespace skein::scenario
