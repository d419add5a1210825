// The magnitudes that the wire lets through: far over what flies, far under what overflows.
#pragma once

#include <cstdint>

namespace skein::limits {

inline constexpr double kPosition_m = 1e7;
inline constexpr double kHeading_rad = 1e3;   ///< headings need not be normalised
inline constexpr double kClimb_rad = 1.5708;  ///< straight up, rounded up
inline constexpr double kSpeed_mps = 1e4;
inline constexpr double kLeastAcceleration_mps2 = 1e-6;
inline constexpr double kAcceleration_mps2 = 1e4;
inline constexpr double kLength_m = 1e9;
inline constexpr double kCurvature_per_m = 1e4;
inline constexpr double kTerrain = 1e4;  ///< constants of Eq. 13
inline constexpr double kTime_s = 1e9;
inline constexpr double kStep_s = 3600.0;
inline constexpr double kParticle = 1e10;
inline constexpr double kCost = 1e300;
inline constexpr std::int32_t kCell = 1 << 20;     ///< cells from the lower corner of the area
inline constexpr std::uint32_t kCells = 1U << 28;  ///< of a grid
inline constexpr double kUnitMin_m = 1e-6;
inline constexpr double kUnitMax_m = 1e6;

}  // namespace skein::limits
