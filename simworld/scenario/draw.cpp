#include "simworld/scenario/draw.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "planner/core/random/random_stream.hpp"
#include "simworld/sensing/shortest_paths.hpp"

namespace skein::scenario {
namespace {

constexpr Keys kWithin[] = {"x_min_m", "y_min_m", "x_max_m", "y_max_m", "z_min_m", "z_max_m"};
constexpr int kTries = 1000;

bool holds(const Box& box, const Vec3& p) {
  return (p.array() >= box.min_m.array()).all() && (p.array() <= box.max_m.array()).all();
}

/// The centres of the cells in a box that count, by ascending index.
std::vector<Vec3> centres_in(const Box& box, const TruthGrid& truth, const std::vector<std::uint32_t>& regions,
                             std::uint32_t region) {
  std::vector<Vec3> centres_m;
  for (CellIndex cell = 0; cell < regions.size(); ++cell) {
    if (regions[cell] == 0 || (region != 0 && regions[cell] != region)) continue;
    const Vec3 centre_m = truth.grid().centre_m(truth.grid().cell_at(cell));
    if (holds(box, centre_m)) centres_m.push_back(centre_m);
  }
  return centres_m;
}

/// Takes one of the points out, if there is one.
std::optional<Vec3> take(std::vector<Vec3>& points_m, RandomStream& stream) {
  if (points_m.empty()) return std::nullopt;
  const auto at = points_m.begin() + static_cast<std::ptrdiff_t>(stream.below(points_m.size()));
  const Vec3 point_m = *at;
  *at = points_m.back();
  points_m.pop_back();
  return point_m;
}

/// Goals, then starts that keep their distances; nothing if the points run out.
std::optional<Drawn> try_places(const Draw& draw, std::vector<Vec3> starts_m, std::vector<Vec3> goals_m,
                                std::size_t vehicles, double apart_m, double goal_radius_m, RandomStream& stream) {
  Drawn drawn;
  for (std::size_t i = 0; i < vehicles; ++i) {
    const std::optional<Vec3> goal_m =
        i > 0 && !draw.own_goals ? std::optional(drawn.goals_m.front()) : take(goals_m, stream);
    if (!goal_m) return std::nullopt;
    drawn.goals_m.push_back(*goal_m);
  }
  while (drawn.starts_m.size() < vehicles) {
    const std::optional<Vec3> start_m = take(starts_m, stream);
    if (!start_m) return std::nullopt;
    const bool crowded =
        std::ranges::any_of(drawn.starts_m, [&](const Vec3& other_m) { return (other_m - *start_m).norm() < apart_m; });
    if (crowded || (drawn.goals_m[drawn.starts_m.size()] - *start_m).norm() <= goal_radius_m) continue;
    drawn.starts_m.push_back(*start_m);
  }
  return drawn;
}

}  // namespace

Draw read_draw(const MapReader& root, const Box& area, bool own_goals) {
  static constexpr Keys kFrom[] = {"connected", "free"};
  const MapReader map = root.map("draw", kDrawKeys, true);
  Draw draw;
  draw.connected = map.word("from", kFrom) == "connected";
  draw.own_goals = map.whole("own_goals", 0, 1, own_goals ? 1 : 0) == 1;
  const auto within = [&](std::string_view key) {
    if (map.find(key) == nullptr) return area;
    Box box = read_box(map.map(key, kWithin, true));
    return box;
  };
  draw.starts = within("starts");
  draw.goals = within("goals");
  return draw;
}

Drawn draw_places(const Draw& draw, const TruthGrid& truth, std::size_t vehicles, const VehicleSpec& common,
                  double goal_radius_m, std::uint64_t seed, const Place& place) {
  RandomStream stream(seed, kWorldId, Purpose::Layout, 1);
  const std::vector<std::uint32_t> regions = regions_of(truth);
  const std::vector<Vec3> anchors_m = centres_in(draw.starts, truth, regions, 0);
  for (int n = 0; n < kTries && !anchors_m.empty(); ++n) {
    const Vec3 anchor_m = anchors_m[stream.below(anchors_m.size())];
    const std::uint32_t region = draw.connected ? regions[truth.grid().index_of(truth.grid().cell_of(anchor_m))] : 0;
    const auto drawn = try_places(draw, centres_in(draw.starts, truth, regions, region),
                                  centres_in(draw.goals, truth, regions, region), vehicles,
                                  2.0 * common.safety_radius_m, goal_radius_m, stream);
    if (drawn) return *drawn;
  }
  throw ReadFault(place, fmt::format("draw finds no starts and goals for {} vehicles; allowed: an area with enough {}",
                                     vehicles, draw.connected ? "cells that a path joins" : "free cells"));
}

}  // namespace skein::scenario
