#include "simworld/lockstep/map_watch.hpp"

#include <algorithm>
#include <functional>
#include <limits>

#include "planner/core/lockstep/map_sample.hpp"
#include "planner/core/obstacle_map/tile.hpp"
#include "planner/core/radio/radio.hpp"
#include "planner/core/radio/radio_budget.hpp"

namespace skein {
namespace {

constexpr double kImprobable = 1e-9;
constexpr std::uint64_t kPatience_frames = 4;  ///< as the agents have it
constexpr double kLongest = 1e9;               ///< steps: beyond the longest flight

std::uint64_t parts(std::uint64_t whole, std::uint64_t part) {
  return (whole + part - 1) / part;
}

/// How often at least a sample is sent again until one is heard. @pre loss under 1
std::uint64_t tries_against(double loss) {
  std::uint64_t tries = 0;
  for (double all_lost = loss; all_lost > kImprobable; all_lost *= loss) ++tries;
  return tries;
}

bool same_place(const MapHolder& a, const MapHolder& b) {
  return a.agent == b.agent && a.incarnation == b.incarnation && a.position_m == b.position_m;
}

}  // namespace

std::optional<std::uint32_t> settling_steps(const Mission& mission) {
  if (!mission.transit || mission.transit->planner.name == kStraight) return std::nullopt;
  const TransitMission& transit = *mission.transit;
  const bool errs = transit.sensor.miss > 0.0 || transit.sensor.false_alarm > 0.0;
  if (transit.planner.share_maps == 0.0 || errs || transit.radio.loss >= 0.999) return std::nullopt;
  const RadioBudget budget(transit.radio, share_of(mission, 0));
  const auto decisions = static_cast<double>(budget.decisions_per_frame());
  const double slot_bytes =
      budget.slot_bits() / 8.0 - decisions * (transit.radio.header_bits / 8.0 + static_cast<double>(kControlBytes));
  const auto half_bytes = static_cast<std::uint64_t>(std::clamp(slot_bytes / 2.0, 0.0, 1e6));
  const std::uint64_t tiles = std::min<std::uint64_t>(half_bytes / kMapTileBytes, kMaxMapTiles);
  const std::uint64_t entries = half_bytes / kSeenBytes;
  if (tiles == 0 || entries == 0) return std::nullopt;
  const std::uint64_t n = mission.vehicles.size();
  const std::uint64_t tile_frames = parts(TileGrid(grid_of(transit)).size() * n, tiles);
  const std::uint64_t waits = kPatience_frames * (n + tries_against(transit.radio.loss));
  const std::uint64_t frames = tile_frames + parts(n, entries) + waits;
  const std::uint64_t frame_steps = std::uint64_t{budget.decisions_per_frame()} * steps_per_decision(mission);
  const std::uint64_t steps = 1 + (n - 1) * (frames * frame_steps + latency_of(transit.radio));
  if (static_cast<double>(steps) > kLongest) return std::nullopt;
  return static_cast<std::uint32_t>(steps);
}

MapWatch::MapWatch(const Mission& mission)
    : range_m_(mission.transit->radio.range_m), settling_steps_(skein::settling_steps(mission)) {}

std::vector<MapWatch::Group> MapWatch::groups_of(std::span<const MapHolder> holders) const {
  std::vector<Group> groups;
  std::vector<bool> placed(holders.size(), false);
  for (std::size_t first = 0; first < holders.size(); ++first) {
    if (placed[first]) continue;
    Group group;
    group.members.push_back(holders[first]);
    placed[first] = true;
    for (std::size_t i = 0; i < group.members.size(); ++i) {
      const Vec3 from_m = group.members[i].position_m;
      for (std::size_t other = 0; other < holders.size(); ++other) {
        if (placed[other] || (holders[other].position_m - from_m).norm() > range_m_) continue;
        group.members.push_back(holders[other]);
        placed[other] = true;
      }
    }
    std::ranges::sort(group.members, {}, &MapHolder::agent);
    groups.push_back(std::move(group));
  }
  return groups;
}

void MapWatch::add(std::uint32_t step, std::span<const MapHolder> holders) {
  std::vector<Group> now = groups_of(holders);
  due_ = differing_ = 0;
  for (Group& group : now) {
    const auto before = std::ranges::find_if(
        groups_, [&](const Group& old) { return std::ranges::equal(old.members, group.members, same_place); });
    group.since_step = before == groups_.end() ? step : before->since_step;
    const bool due = settling_steps_ && group.members.size() > 1 && step - group.since_step >= *settling_steps_;
    if (!due) continue;
    const bool equal =
        std::ranges::adjacent_find(group.members, std::not_equal_to<>(), &MapHolder::map_hash) == group.members.end();
    due_ += group.members.size();
    if (!equal) differing_ += group.members.size();
  }
  groups_ = std::move(now);
}

}  // namespace skein
