// A swarm of maps that exchange samples under the loss, order and repetition that a test chooses.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "planner/core/obstacle_map/obstacle_map.hpp"

namespace skein::testing {

struct MapSwarm {
  MapSwarm(const CellGrid& grid, std::size_t n) {
    for (AgentId id = 1; id <= n; ++id) ids.push_back(id);
    for (const AgentId id : ids) {
      maps.emplace_back(grid, id, ids);
      at_m.push_back(grid.centre_m({0, 0, 0}));
      incarnations.push_back(1);
    }
  }

  /// Rank `from` composes for those who hear each other by `hears`.
  ObstacleMapSample compose(std::size_t from, std::size_t budget,
                            const std::function<bool(std::size_t, std::size_t)>& hears) {
    std::vector<MapPeer> peers;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (i != from && hears(i, from)) peers.push_back({ids[i], at_m[i], at_m[i]});
    }
    MapRequest request;
    request.budget_bytes = budget;
    request.round = round;
    request.peers = peers;
    request.range_m = range_m;
    ObstacleMapSample sample;
    sample.agent = ids[from];
    sample.incarnation = incarnations[from];
    sample.round = round;
    if (auto part = maps[from].compose(request)) {
      sample.seen = std::move(part->seen);
      sample.tiles = std::move(part->tiles);
    }
    const std::size_t bytes = payload_bytes(sample.tiles.size(), sample.seen.size());
    sent_bytes += bytes;
    sent_tiles += sample.tiles.size();
    largest_bytes = std::max(largest_bytes, bytes);
    return sample;
  }

  /// A round in which all send, then all hear those that `hears` says: (sender, receiver).
  void exchange(std::size_t budget, const std::function<bool(std::size_t, std::size_t)>& hears) {
    ++round;
    std::vector<ObstacleMapSample> samples;
    for (std::size_t i = 0; i < ids.size(); ++i) samples.push_back(compose(i, budget, hears));
    for (std::size_t to = 0; to < ids.size(); ++to) {
      for (std::size_t from = 0; from < ids.size(); ++from) {
        if (from != to && hears(from, to)) maps[to].merge(samples[from]);
      }
    }
  }
  void exchange_all(std::size_t budget = SIZE_MAX) {
    exchange(budget, [](std::size_t, std::size_t) { return true; });
  }

  [[nodiscard]] bool all_equal() const {
    for (const ObstacleMap& map : maps) {
      if (!map.same_map(maps[0]) || map.map_hash() != maps[0].map_hash()) return false;
    }
    return true;
  }

  std::vector<AgentId> ids;
  std::vector<ObstacleMap> maps;
  std::vector<Vec3> at_m;
  std::vector<std::uint32_t> incarnations;
  double range_m = std::numeric_limits<double>::infinity();
  std::uint32_t round = 0;
  std::size_t sent_bytes = 0;
  std::size_t sent_tiles = 0;
  std::size_t largest_bytes = 0;
};

}  // namespace skein::testing
