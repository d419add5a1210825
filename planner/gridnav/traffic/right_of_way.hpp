// Right of way among UAVs that decide at the same time, from what each sent one decision before.
//
// In decision k-1 every UAV sends the motion that it intends for decision k. In decision k it flies its own intent as a
// whole, or stays where it is. It flies only if the motion
//   (a) keeps clear of the place where every other stands now,
//   (b) keeps clear, moving together, of the intended motion of every other with right of way, and
//   (c) keeps clear of all that an other can reach within the decision whose intent it did not hear.
// Then no two bodies touch, whatever samples are lost: who stays is passed by (a). If both i and j move and each heard
// the other, the order of sent keys is the same for both and the lower has checked (b). If j did not hear i, then (c)
// kept j's motion off everything that i can reach, i's motion included. All are inequalities of the least distance of
// straight motions at constant speed; nothing is sampled.
// The order is total: Flying before Deadlock before Unreachable before Held, fewer rotations, less to go, lower id. Who
// was asked to move aside sends the key of the one on whose behalf it moves (priority inheritance).
// Source: Okumura et al., 'Priority inheritance with backtracking', AIJ 2022 (PIBT), for the order and inheritance.
// Departs from source: by messages, one decision ahead; no following into a cell before it is empty.
// Complexity: O(neighbours).
#pragma once

#include <compare>
#include <optional>
#include <span>
#include <vector>

#include "planner/core/lockstep/map_sample.hpp"

namespace skein::gridnav {

/// Kept between bodies beside their radii, against rounding.
inline constexpr double kMargin_m = 0.02;

/// A UAV within radio range that has not landed.
struct Neighbour {
  AgentId id = 0;
  Vec3 position_m = Vec3::Zero();  ///< at the decision's start
  double radius_m = 0.0;
  std::optional<Intent> intent;  ///< heard for this decision; nothing if it was lost
};

/// Place in the order: the smaller key has right of way.
struct Key {
  int group = 0;
  std::uint32_t rotations = 0;
  double to_go_m = 0.0;
  AgentId on_behalf_of = 0;
  bool pushed = false;
  AgentId id = 0;

  auto operator<=>(const Key&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm of clang-tidy 14
};

/// The key that a sent intent of UAV id stands for.
[[nodiscard]] Key key_of(AgentId id, const Intent& intent);

/// The body that moves: radius and how far it gets in one decision (m).
struct Body {
  AgentId id = 0;
  double radius_m = 0.0;
  double reach_m = 0.0;
};

/// Whether `own` may fly its intent for this decision by rules (a), (b), (c).
/// @param reaches_m of each neighbour, in the same order
[[nodiscard]] bool may_fly(const Body& own, const Intent& intent, std::span<const Neighbour> neighbours,
                           std::span<const double> reaches_m);

/// A neighbour as expected at the start of the next decision.
struct Other {
  AgentId id = 0;
  double clearance_m = 0.0;      ///< sum of the radii and the margin
  Vec3 now_m = Vec3::Zero();     ///< at this decision's start
  Vec3 next_m = Vec3::Zero();    ///< where it is after this decision, if it flies what it said
  std::vector<Vec3> way_m;       ///< from now_m on, as far as it said
  bool moves_on = false;         ///< whether it said that it moves after that
  std::optional<Intent> intent;  ///< the last one heard, if not too old
  bool asks_own = false;         ///< whether it asks this UAV to move aside
};

/// Whether it said that it stays by command: asking it to move aside is of no use.
[[nodiscard]] inline bool is_held(const Other& other) {
  return other.intent && other.intent->status == NavStatus::Held;
}

/// How a motion of the next decision stands to one other.
enum class Conflict : std::uint8_t {
  None = 0,
  Standing = 1,  ///< it would touch the other where that will stand
  Moving = 2,    ///< it would touch the other's next motion
  Against = 3,   ///< it would end on the other's way, and lead on against it
};

/// @param after where the way leads on from `end`
[[nodiscard]] Conflict conflict_of(const Vec3& start, const Vec3& end, const Vec3& after, const Other& other,
                                   bool other_first);

/// Distance of p from a way, and how far along it (m) the closest point is.
struct OnWay {
  double distance_m;
  double along_m;
};
[[nodiscard]] OnWay on_way(const Vec3& p, std::span<const Vec3> way_m);

}  // namespace skein::gridnav
