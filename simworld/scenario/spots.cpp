#include "simworld/scenario/spots.hpp"

#include <fmt/core.h>

namespace skein::scenario {
namespace {

constexpr Keys kPlaced[] = {"id", "x_m", "y_m", "z_m"};
constexpr Keys kPoint[] = {"x_m", "y_m", "z_m"};

}  // namespace

Spots read_spots(const MapReader& parent, std::string_view list, double z_m) {
  Spots spots;
  const auto items = parent.list(list, kMaxAgents, true);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const MapReader item = parent.item(list, i, kPlaced);
    Vec3 point_m = read_point(item);
    if (item.find("z_m") == nullptr) point_m.z() = z_m;
    if (!spots.emplace(read_id(item), Spot{point_m, place_of_item(items[i])}).second) {
      item.refuse("id", fmt::format("an id that no other item of {} has", parent.path_of(list)));
    }
  }
  return spots;
}

bool has_own_goals(const MapReader& root) {
  return root.find("goals") != nullptr && root.find("goals")->kind == NodeKind::List;
}

std::vector<Spot> read_goals(const MapReader& root, const std::vector<VehicleSpec>& vehicles, double z_m) {
  std::vector<Spot> goals;
  if (!has_own_goals(root)) {
    const MapReader map = root.map("goals", kPoint, true);
    Vec3 point_m = read_point(map);
    if (map.find("z_m") == nullptr) point_m.z() = z_m;
    goals.assign(vehicles.size(), {point_m, place_of_item(*root.find("goals"))});
    return goals;
  }
  const Spots spots = read_spots(root, "goals", z_m);
  for (const VehicleSpec& vehicle : vehicles) {
    const auto found = spots.find(vehicle.id);
    if (found == spots.end()) {
      throw ReadFault(root.place_of("goals"), fmt::format("goals has none for vehicle {}; allowed: one for each start, "
                                                          "or one point for all",
                                                          vehicle.id));
    }
    goals.push_back(found->second);
  }
  return goals;
}

}  // namespace skein::scenario
