#include "simworld/scenario/hidden.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "planner/core/random/random_stream.hpp"
#include "simworld/scenario/overrides.hpp"

namespace skein::scenario {
namespace {

constexpr Keys kCylinder[] = {"x_m", "y_m", "radius_m", "z_min_m", "z_max_m"};
constexpr Keys kBox[] = {"x_min_m", "y_min_m", "x_max_m", "y_max_m", "z_min_m", "z_max_m"};
constexpr Keys kSphere[] = {"x_m", "y_m", "z_m", "radius_m"};
constexpr Keys kGround[] = {"terrain"};
constexpr Keys kMesh[] = {"file", "x_m", "y_m", "z_m", "scale"};
constexpr Keys kForest[] = {"trees", "density_per_m2", "radius_min_m", "radius_max_m"};
constexpr std::uint64_t kMaxTrees = 10'000;

Sphere read_sphere(const MapReader& item) {
  const Vec3 centre_m = read_point(item);
  return {centre_m, item.number("radius_m", kExtent)};
}

Mesh read_mesh_item(const MapReader& item, const std::string& folder) {
  const std::string file = item.text("file");
  const Vec3 at_m = read_point(item);
  const MeshResult result =
      read_mesh(file.front() == '/' ? file : folder + file, at_m, item.number("scale", {1e-6, 1e6}, 1.0));
  if (const auto* fault = std::get_if<std::string>(&result)) {
    throw ReadFault(item.place_of("file"), fmt::format("{}: {}; allowed: a mesh file that assimp reads",
                                                       item.path_of("file"), on_one_line(*fault)));
  }
  return std::get<Mesh>(result);
}

Obstacle read_item(const MapReader& root, std::size_t index, const YamlNode& node, const std::string& folder) {
  constexpr std::string_view kList = "hidden_obstacles";
  const auto item = [&](std::span<const Keys> keys) { return root.item(kList, index, keys); };
  if (node.find("file") != nullptr) return {read_mesh_item(item(kMesh), folder), ""};
  if (node.find("terrain") != nullptr) return {read_terrain_map(item(kGround), "terrain", 1.0), ""};
  if (node.find("x_min_m") != nullptr) return {read_box(item(kBox)), ""};
  if (node.find("z_m") != nullptr) return {read_sphere(item(kSphere)), ""};
  return {read_cylinder(item(kCylinder)), ""};
}

}  // namespace

std::vector<Obstacle> read_hidden(const MapReader& root, const std::string& folder) {
  std::vector<Obstacle> hidden;
  const auto items = root.list("hidden_obstacles", kMaxHidden, false);
  for (std::size_t i = 0; i < items.size(); ++i) {
    hidden.push_back(read_item(root, i, items[i], folder));
    hidden.back().name = fmt::format("hidden_obstacles.{}", i + 1);
  }
  return hidden;
}

std::optional<Forest> read_forest(const MapReader& root, const Box& area) {
  if (root.find("forest") == nullptr) return std::nullopt;
  const MapReader map = root.map("forest", kForest, true);
  Forest forest;
  if (map.find("trees") != nullptr && map.find("density_per_m2") != nullptr) {
    map.refuse("density_per_m2", "no density beside forest.trees");
  }
  if (map.find("density_per_m2") != nullptr) {
    const Vec3 size_m = area.max_m - area.min_m;
    const double trees = std::floor(map.number("density_per_m2", {0, 1, "per m2"}) * size_m.x() * size_m.y());
    if (trees > static_cast<double>(kMaxTrees)) {
      map.refuse("density_per_m2", fmt::format("at most {} trees in the area", kMaxTrees));
    }
    forest.trees = static_cast<std::uint64_t>(trees);
  } else {
    forest.trees = map.whole("trees", 0, kMaxTrees);
  }
  forest.radius_min_m = map.number("radius_min_m", kExtent);
  forest.radius_max_m = map.number("radius_max_m", kExtent);
  if (forest.radius_max_m < forest.radius_min_m) {
    map.refuse("radius_max_m", fmt::format("at least radius_min_m, {} m", forest.radius_min_m));
  }
  return forest;
}

std::vector<Obstacle> grow(const Forest& forest, const Box& area, std::span<const Box> kept_free, std::uint64_t seed) {
  RandomStream stream(seed, kWorldId, Purpose::Layout, 0);
  std::vector<Obstacle> trees;
  for (std::uint64_t n = 0; n < forest.trees; ++n) {
    const double x_m = stream.uniform(area.min_m.x(), area.max_m.x());
    const double y_m = stream.uniform(area.min_m.y(), area.max_m.y());
    const double radius_m = stream.uniform(forest.radius_min_m, forest.radius_max_m);
    Obstacle tree{Cylinder{Vec2(x_m, y_m), radius_m, area.min_m.z(), area.max_m.z()}, fmt::format("forest.{}", n + 1)};
    const bool in_the_way = std::ranges::any_of(kept_free, [&](const Box& box) { return overlaps(tree, box); });
    if (!in_the_way) trees.push_back(std::move(tree));
  }
  return trees;
}

}  // namespace skein::scenario
