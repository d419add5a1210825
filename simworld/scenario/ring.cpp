#include "simworld/scenario/ring.hpp"

#include "planner/core/math/det_math.hpp"

namespace skein::scenario {
namespace {

constexpr std::string_view kRing[] = {"agents", "start_radius_m", "slot_radius_m", "start_turn_rad"};
constexpr Limits kRadius{1e-3, 1e6, "m"};

}  // namespace

std::vector<VehicleSpec> read_ring(const MapReader& vehicles, const VehicleSpec& common, const Pose& formation) {
  const MapReader ring = vehicles.map("ring", kRing, true);
  const std::uint64_t agents = ring.whole("agents", 2, kMaxAgents);
  const double start_radius_m = ring.number("start_radius_m", kRadius);
  const double slot_radius_m = ring.number("slot_radius_m", kRadius);
  const double turn_rad = ring.number("start_turn_rad", {-math::kPi, math::kPi, "rad"}, 1.0);
  std::vector<VehicleSpec> specs;
  for (std::uint64_t k = 0; k < agents; ++k) {
    VehicleSpec spec = common;
    const double at_rad = math::kTwoPi * static_cast<double>(k) / static_cast<double>(agents);
    const Vec3 outward(math::cos(at_rad), math::sin(at_rad), 0.0);
    const double in_formation_rad = at_rad - formation.heading_rad;
    spec.id = static_cast<AgentId>(k + 1);
    spec.start.position_m = formation.position_m + start_radius_m * outward;
    spec.start.heading_rad = math::wrap_angle(at_rad + math::kPi + turn_rad);
    spec.slot_offset_m = -slot_radius_m * Vec3(math::cos(in_formation_rad), math::sin(in_formation_rad), 0.0);
    specs.push_back(spec);
  }
  return specs;
}

}  // namespace skein::scenario
