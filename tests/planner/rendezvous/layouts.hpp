// Canonical missions of the rendezvous tests: the paper's three UAVs among obstacles of our own.
//
//   y/km                                 A: circles (11, 6) r 2, (6.5, 17.5) r 3; rectangles [20, 25] x [2, 6],
//   20 3 ___        # #                     [14, 20] x [18, 20]
//        (__)      # # #    <-- slots    B: circles (12, 5) r 1.5, (23, 5) r 2; rectangles [9, 14] x [14, 18],
//   10  2           at (30, 15)             [16, 20] x [18, 20]
//           O    [ ]
//   -5   1            x/km               The rendezvous point is (30, 15): the paper's (35, 15) is a misprint.
#pragma once

#include "planner/core/mission/mission.hpp"

namespace skein::test {

/// Without zones; radius 2 m, safety radius 100 m, 2 per km, 50 m/s, lengths in kilometres.
[[nodiscard]] Mission open_field(std::uint64_t seed);
[[nodiscard]] Mission layout_a(std::uint64_t seed);
[[nodiscard]] Mission layout_b(std::uint64_t seed);

/// The open field with two gates: walls at x 8 .. 10 open over y 3 .. 15, a wall at x 15 .. 17 open below y 9, a circle
/// (15, -8) r 4 under it, and circles of r 1 at (12, 13), (25, 10), (3, 16). UAV 1 and 3 would have to swing there and
/// back more often than a single segment can (deploy/scenarios/rendezvous-clutter.yaml).
[[nodiscard]] Mission layout_clutter(std::uint64_t seed);

/// In space, without zones: heights 2.3, 2 and 3.3 km, climbs pi/12, pi/8 and -pi/7, slots at 3 km, formation heading
/// pi/9; torsion at most 2 per km.
[[nodiscard]] Mission open_space(std::uint64_t seed);

/// Open space with A's circles, up to 4 and 2.8 km, A's rectangles of any height, a box over [10, 18] x [8, 12] from
/// 3.4 km up, and hills of up to 2.1 km near (9, 17), under the dive of UAV 3. Its unobstructed path crosses the second
/// cylinder.
[[nodiscard]] Mission layout_space(std::uint64_t seed);

/// n UAVs on a ring, started 1 rad off the way to the centre, to slots across another ring; radii in metres.
[[nodiscard]] Mission ring(std::uint64_t seed, int n, double start_m, double slot_m);

/// A mission with points for vehicles and no margin: the figures of the paper.
[[nodiscard]] Mission as_points(Mission mission);

[[nodiscard]] Zone circle_km(double x, double y, double radius);
[[nodiscard]] Zone rectangle_km(double x_min, double x_max, double y_min, double y_max);

}  // namespace skein::test
