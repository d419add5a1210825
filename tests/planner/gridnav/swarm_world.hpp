// A small world for navigators in one process: cells that are occupied, ideal sensors, motions that are judged exactly.
//
// Sensors see at once every cell whose centre is within range and whose line of sight crosses no occupied cell. Maps
// may be shared at once; intents may be lost. Every motion is held against all occupied cells and all other motions.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "planner/gridnav/navigator.hpp"

namespace skein::gridnav {

struct Layout {
  CellGrid grid;
  std::vector<bool> occupied;  ///< by cell
  std::vector<Cell> starts;
  std::vector<Vec3> goals_m;  ///< by UAV
};

/// A plane of rows, north first: '#' occupied, 'a'.. starts, 'A'.. goals of the same UAV, else free.
[[nodiscard]] Layout drawn(const std::vector<std::string>& rows, double cell_m);

/// What an operator tells a navigator before a decision.
struct Told {
  enum class What : std::uint8_t { Hold, Goto, Resume };
  std::uint32_t decision = 0;
  AgentId id = 0;
  What what = What::Hold;
  Vec3 point_m = Vec3::Zero();
  double speed_mps = 10.0;
};

struct Conditions {
  std::string planner = "peach3d";
  double sensor_m = 24.0;
  double speed_mps = 10.0;
  double radius_m = 0.25;
  double goal_radius_m = 0.9;
  double patience = 40;
  bool share = true;
  double loss = 0.0;
  std::uint64_t seed = 1;
  std::uint32_t most_decisions = 2000;
  std::vector<Told> told;
};

struct Flight {
  NavStatus status = NavStatus::Flying;
  double length_m = 0.0;
  std::vector<Vec3> places_m;
};

struct Outcome {
  std::vector<Flight> flights;
  std::uint32_t decisions = 0;
  double closest_m = 1e9;  ///< least distance of two bodies' centres, continuous
  std::uint32_t hits = 0;  ///< motions that sweep an occupied cell or leave the grid
  std::uint64_t hash = 0;  ///< of all navigators after every decision

  [[nodiscard]] int count(NavStatus status) const;
};

[[nodiscard]] Mission mission_of(const Layout& layout, const Conditions& conditions);
[[nodiscard]] Outcome fly(const Layout& layout, const Conditions& conditions);

/// Shortest way over open cells without cutting corners (m), or a negative number. Plain Dijkstra.
[[nodiscard]] double shortest_m(const Layout& layout, const Cell& from, const Cell& to);

}  // namespace skein::gridnav
