// The changes of velocity that the safety filter tries where the wished one is not safe.
//
// Source: own. Departs from source: none.
#pragma once

#include <array>

namespace skein {

/// Of a direction e, sideways s and upwards u: forward, side and up parts, and the size within what one step can
/// change.
struct Turned {
  double forward, side, up, size;
};

inline constexpr double kHalf = 0.5;
inline constexpr double kRoot = 0.8660254037844386;  // sqrt(3) / 2

/// Level turns by 30 to 180 degrees to both sides, whole and half.
inline constexpr std::array<Turned, 24> kLevelFan{{
    {1, 0, 0, 1},           {1, 0, 0, .5},           {kRoot, -kHalf, 0, 1},
    {kRoot, kHalf, 0, 1},   {kRoot, -kHalf, 0, .5},  {kRoot, kHalf, 0, .5},
    {kHalf, -kRoot, 0, 1},  {kHalf, kRoot, 0, 1},    {kHalf, -kRoot, 0, .5},
    {kHalf, kRoot, 0, .5},  {0, -1, 0, 1},           {0, 1, 0, 1},
    {0, -1, 0, .5},         {0, 1, 0, .5},           {-kHalf, -kRoot, 0, 1},
    {-kHalf, kRoot, 0, 1},  {-kHalf, -kRoot, 0, .5}, {-kHalf, kRoot, 0, .5},
    {-kRoot, -kHalf, 0, 1}, {-kRoot, kHalf, 0, 1},   {-kRoot, -kHalf, 0, .5},
    {-kRoot, kHalf, 0, .5}, {-1, 0, 0, 1},           {-1, 0, 0, .5},
}};

inline constexpr double kDiagonal = 0.7071067811865476;  // sqrt(1 / 2)
/// Turns up and down by 30 to 150 degrees, and between.
inline constexpr std::array<Turned, 16> kSteepFan{{
    {kRoot, 0, -kHalf, 1},
    {kRoot, 0, kHalf, 1},
    {kHalf, kHalf, kDiagonal, 1},
    {kHalf, kHalf, -kDiagonal, 1},
    {kHalf, -kHalf, kDiagonal, 1},
    {kHalf, -kHalf, -kDiagonal, 1},
    {kHalf, 0, kRoot, 1},
    {kHalf, 0, -kRoot, 1},
    {0, 0, 1, 1},
    {0, 0, -1, 1},
    {0, 0, 1, .5},
    {0, 0, -1, .5},
    {-kHalf, 0, kRoot, 1},
    {-kHalf, 0, -kRoot, 1},
    {-kRoot, 0, kHalf, 1},
    {-kRoot, 0, -kHalf, 1},
}};

}  // namespace skein
