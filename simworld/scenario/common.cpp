#include "simworld/scenario/common.hpp"

#include <fmt/core.h>

#include <limits>

namespace skein::scenario {
namespace {

constexpr Keys kCylinder[] = {"x_m", "y_m", "radius_m", "z_min_m", "z_max_m"};
constexpr Keys kBox[] = {"x_min_m", "y_min_m", "x_max_m", "y_max_m", "z_min_m", "z_max_m"};
constexpr Keys kTerrain[] = {"a", "b", "c", "d", "e", "f", "g", "h", "l"};
constexpr Keys kLockstep[] = {"deadline_s"};
constexpr Keys kWorld[] = {"max_steps", "max_rounds", "extra_steps", "slow"};

constexpr Keys kSlow[] = {"id", "factor", "from_s"};

constexpr std::uint64_t kMostSteps = 10'000'000;

}  // namespace

AgentId read_id(const MapReader& reader) {
  return static_cast<AgentId>(reader.whole("id", 1, kMaxAgents));
}

Vec3 read_point(const MapReader& reader) {
  const double x_m = reader.number("x_m", kCoordinate);
  const double y_m = reader.number("y_m", kCoordinate);
  return {x_m, y_m, reader.number("z_m", kHeight, 0.0)};
}

void read_head(const MapReader& root, std::optional<std::uint64_t> seed, Mission& mission) {
  static constexpr Keys kKinds[] = {"rendezvous", "transit"};
  mission.name = root.name("name");
  mission.kind = root.word("kind", kKinds) == "transit" ? MissionKind::Transit : MissionKind::Rendezvous;
  mission.seed = root.whole("seed", 0, std::numeric_limits<std::uint64_t>::max(), 0);
  if (seed) mission.seed = *seed;
  mission.step_s = root.number("step_s", {1e-3, 60, "s"});
}

OnAgentLoss read_on_agent_loss(const MapReader& vehicles) {
  static constexpr Keys kLosses[] = {"remove", "hover", "continue"};
  const std::string on_loss = vehicles.word("on_agent_loss", kLosses, "remove");
  return on_loss == "remove" ? OnAgentLoss::Remove : on_loss == "hover" ? OnAgentLoss::Hover : OnAgentLoss::Continue;
}

void read_body(const MapReader& vehicles, VehicleSpec& spec) {
  spec.radius_m = vehicles.number("radius_m", {1e-3, 1000, "m"});
  spec.safety_radius_m = vehicles.number("safety_radius_m", {1e-3, 1e5, "m"});
}

void check_body(const MapReader& vehicles, const VehicleSpec& spec) {
  if (spec.safety_radius_m >= spec.radius_m) return;
  vehicles.refuse("safety_radius_m", fmt::format("at least vehicles.radius_m, {} m", spec.radius_m));
}

void read_heights(const MapReader& item, double& z_min_m, double& z_max_m) {
  z_min_m = item.number("z_min_m", kHeight, z_min_m);
  z_max_m = item.number("z_max_m", kHeight, z_max_m);
  if (z_max_m <= z_min_m) item.refuse("z_max_m", fmt::format("more than z_min_m, {} m", z_min_m));
}

Cylinder read_cylinder(const MapReader& item) {
  Cylinder cylinder;
  const double x_m = item.number("x_m", kCoordinate);
  cylinder.centre_m = Vec2(x_m, item.number("y_m", kCoordinate));
  cylinder.radius_m = item.number("radius_m", kExtent);
  read_heights(item, cylinder.z_min_m, cylinder.z_max_m);
  return cylinder;
}

Box read_box(const MapReader& item) {
  Box box;
  const double x_min_m = item.number("x_min_m", kCoordinate);
  box.min_m.head<2>() = Vec2(x_min_m, item.number("y_min_m", kCoordinate));
  const double x_max_m = item.number("x_max_m", kCoordinate);
  box.max_m.head<2>() = Vec2(x_max_m, item.number("y_max_m", kCoordinate));
  if (box.max_m.x() <= box.min_m.x()) item.refuse("x_max_m", fmt::format("more than x_min_m, {} m", box.min_m.x()));
  if (box.max_m.y() <= box.min_m.y()) item.refuse("y_max_m", fmt::format("more than y_min_m, {} m", box.min_m.y()));
  read_heights(item, box.min_m.z(), box.max_m.z());
  return box;
}

/// Obstacles are cylinders, or boxes if they have x_min_m; no-fly zones are boxes, or cylinders if they have radius_m.
void read_zones(const MapReader& root, std::string_view list, bool no_fly, std::vector<Zone>& zones) {
  const std::span<const YamlNode> items = root.list(list, kMaxZones, false);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool is_box = no_fly ? items[i].find("radius_m") == nullptr : items[i].find("x_min_m") != nullptr;
    const MapReader item = is_box ? root.item(list, i, kBox) : root.item(list, i, kCylinder);
    if (is_box) {
      zones.push_back({read_box(item), no_fly});
    } else {
      zones.push_back({read_cylinder(item), no_fly});
    }
  }
}

Terrain read_terrain_map(const MapReader& parent, std::string_view key, double length_unit_m) {
  constexpr Limits kConstant{-1000, 1000};
  const MapReader terrain = parent.map(key, kTerrain, true);
  Terrain out;
  double Terrain::*members[] = {&Terrain::a, &Terrain::b, &Terrain::c, &Terrain::d, &Terrain::e,
                                &Terrain::f, &Terrain::g, &Terrain::h, &Terrain::l};
  for (std::size_t i = 0; i < std::size(members); ++i) out.*members[i] = terrain.number(kTerrain[i], kConstant, 0.0);
  out.unit_m = length_unit_m;
  return out;
}

void read_lockstep_and_world(const MapReader& root, Scenario& into) {
  const MapReader lockstep = root.map("lockstep", kLockstep, false);
  const MapReader world = root.map("world", kWorld, false);
  into.lockstep.deadline_s = lockstep.number("deadline_s", {0.1, 3600, "s"}, into.lockstep.deadline_s);
  into.world.extra_steps = static_cast<std::uint32_t>(world.whole("extra_steps", 0, kMostSteps, 0));
  into.world.max_steps = static_cast<std::uint32_t>(world.whole("max_steps", 1, kMostSteps, into.world.max_steps));
  const auto slow = world.list("slow", kMaxAgents, false);
  for (std::size_t i = 0; i < slow.size(); ++i) {
    const MapReader item = world.item("slow", i, kSlow);
    const AgentId id = read_id(item);
    const double factor = item.number("factor", {0.05, 2});
    into.world.surprises.slow.push_back({id, factor, item.number("from_s", {0, 1e7, "s"}, 0.0)});
  }
  into.world.max_rounds = static_cast<std::uint32_t>(world.whole("max_rounds", 1, kMostSteps, into.world.max_rounds));
}

}  // namespace skein::scenario
