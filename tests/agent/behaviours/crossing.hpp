// A transit behaviour flown by hand: the test plays its world (tick, sense, peers), a plane of 20 x 10 cells of 4 m.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "agent/behaviours/transit.hpp"
#include "tests/simworld/transits.hpp"

namespace skein::test {

inline const Vec3 kWest(6, 18, 6);
inline const Vec3 kEast(74, 18, 6);

/// UAVs 1 and 2 cross from west to east at 10 m/s, a decision a second. @param step_s of which a second is a multiple
inline Mission crossing(double step_s = 1.0) {
  Mission mission = transit_of({crosser(1, kWest), crosser(2, Vec3(6, 30, 6))}, {kEast, Vec3(74, 30, 6)});
  mission.step_s = step_s;
  return mission;
}

inline HeardPeer peer_at(const Vec3& position_m, bool landed = false) {
  return {2, position_m, Vec3::Zero(), landed};
}

/// A block of one level whose cells are all seen to be free.
inline CellWindow free_block(const Cell& low, std::int32_t ni, std::int32_t nj) {
  const auto cells = static_cast<std::size_t>(ni) * static_cast<std::size_t>(nj);
  CellWindow sight{low, ni, nj, 1, std::vector<std::uint8_t>((cells + 3) / 4)};
  for (std::size_t n = 0; n < cells; ++n) sight.set(n, CellState::Free);
  return sight;
}

/// Every cell of the plane is seen to be free, but those that are given.
inline CellWindow sight_of(const std::vector<Cell>& occupied = {}) {
  CellWindow sight = free_block({0, 0, 0}, 20, 10);
  for (const Cell& cell : occupied) sight.set(static_cast<std::size_t>(cell.j * 20 + cell.i), CellState::Occupied);
  return sight;
}

/// The cells of column i, from row `from` to row 9.
inline std::vector<Cell> wall_at(std::int32_t i, std::int32_t from = 0) {
  std::vector<Cell> cells;
  for (std::int32_t j = from; j < 10; ++j) cells.push_back({i, j, 0});
  return cells;
}

/// A sample of agent 2 that was composed in `round`: its first contribution to tile 0, whose cell (0, 0, 0) is
/// occupied.
inline ObstacleMapSample told(std::uint32_t round) {
  ObstacleMapSample sample;
  sample.run = 1;
  sample.agent = 2;
  sample.incarnation = 1;
  sample.round = round;
  sample.tiles = {{2, 0, 0, 1, {3, 0}}};
  return sample;
}

class Crossing {
 public:
  explicit Crossing(Mission mission) : mission_(std::move(mission)), behaviour(mission_, 1) {
    position_m = mission_.vehicles[0].start.position_m;
  }

  /// One flight step: the UAV senses, decides and flies its command.
  const RoundOutput& step(const std::vector<HeardPeer>& heard = {}, const CellWindow& sight = sight_of(),
                          const std::vector<ObstacleMapSample>& maps = {}) {
    ++steps;
    Sense sense;
    sense.agent = 1;
    sense.round = round();
    sense.pose.position_m = position_m;
    sense.heard = heard;
    sense.sight = sight;
    last = behaviour.on_round({tick(Phase::Flying), &sense, {}, maps});
    position_m += last.commanded_velocity_mps * mission_.step_s;
    return last;
  }
  /// Planning is round 1, flight step k round k + 1.
  [[nodiscard]] std::uint32_t round() const { return steps + 1; }
  [[nodiscard]] Tick tick(Phase phase) const {
    Tick tick;
    tick.run = 1;
    tick.step = steps;
    tick.round = round();
    tick.phase = phase;
    return tick;
  }
  [[nodiscard]] std::uint64_t hash() const {
    StateHash hash;
    behaviour.add_to(hash);
    return hash.value();
  }

 private:
  Mission mission_;

 public:
  TransitBehaviour behaviour;
  Vec3 position_m;
  std::uint32_t steps = 0;
  RoundOutput last;
};

}  // namespace skein::test
