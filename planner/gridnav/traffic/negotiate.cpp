#include "planner/gridnav/traffic/negotiate.hpp"

#include <algorithm>

namespace skein::gridnav {
namespace {

/// What the options met, over all of them.
struct Found {
  const Option* free = nullptr;  ///< the first without conflict
  bool only_moving = true;       ///< nothing but motions of others in the way
  const Other* standing = nullptr;
  const Other* against = nullptr;  ///< comes against this UAV, with right of way
};

class Negotiation {
 public:
  Negotiation(const KnownMap& map, const Traveller& traveller, std::span<const Other> others)
      : map_(map), self_(traveller), others_(others) {
    result_.intent = traveller.own;
    result_.intent.to_m = traveller.start_m;
    key_ = key_of(self_.body.id, self_.own);
    hear_askers();
  }

  Announcement run(std::span<const Option> options, const std::function<std::vector<Option>()>& detours) {
    const Found found = examine(options);
    if (found.free != nullptr) return go(found.free->end_m);
    if (!options.empty() && found.only_moving && asker_ == nullptr) return yield();
    if (!options.empty()) {
      const std::vector<Option> around = detours();
      const Found beside = examine(around);
      if (beside.free != nullptr) return go(beside.free->end_m);
    }
    const Other* first = asker_ != nullptr ? asker_ : found.against;
    if (first != nullptr) return back_off(*first);
    if (found.standing == nullptr || is_held(*found.standing)) return yield();
    if (is_first(*found.standing)) return yield();
    result_.intent.asks = found.standing->id;
    return result_;
  }

 private:
  /// The intent whose place in the order an other has: its own, or that of the one on whose behalf it moves, as that
  /// one said it last; a place handed on must not outlive a rotation. Nothing if unknown, or if it is this UAV's.
  [[nodiscard]] const Intent* standing_of(const Other& other) const {
    if (!other.intent || other.intent->on_behalf_of == self_.body.id) return nullptr;
    if (other.intent->on_behalf_of == other.id) return &*other.intent;
    for (const Other& root : others_)
      if (root.id == other.intent->on_behalf_of && root.intent && root.intent->on_behalf_of == root.id)
        return &*root.intent;
    return nullptr;
  }

  [[nodiscard]] bool is_first(const Other& other) const {
    const Intent* its = standing_of(other);
    return &other == asker_ || (its != nullptr && key_of(other.id, *its) < key_);
  }

  // Who asks with right of way is answered in its name.
  void hear_askers() {
    for (const Other& other : others_) {
      if (!other.asks_own) continue;
      const Intent* its = standing_of(other);
      if (its == nullptr || !(key_of(other.id, *its) < key_)) continue;
      asker_ = &other;
      inherit(*its);
    }
  }

  void inherit(const Intent& from) {
    result_.intent.status = from.status;
    result_.intent.waited = from.waited;
    result_.intent.to_go_m = from.to_go_m;
    result_.intent.on_behalf_of = from.on_behalf_of;
    key_ = key_of(self_.body.id, result_.intent);
  }

  Found examine(std::span<const Option> options) const {
    Found found;
    for (const Option& option : options) {
      bool free = true;
      for (const Other& other : others_) {
        const bool first = is_first(other);
        const Conflict conflict = conflict_of(self_.start_m, option.end_m, option.after_m, other, first);
        if (conflict == Conflict::None) continue;
        free = false;
        if (conflict != Conflict::Moving) found.only_moving = false;
        if (conflict == Conflict::Standing && (found.standing == nullptr || !is_held(other))) found.standing = &other;
        if (first && (conflict == Conflict::Against || (conflict == Conflict::Standing && ahead_of(other))))
          found.against = &other;
      }
      if (free) {
        found.free = &option;
        return found;
      }
    }
    return found;
  }

  /// Whether this UAV stands on the way on which the other is to come.
  [[nodiscard]] bool ahead_of(const Other& other) const {
    const OnWay at = on_way(self_.start_m, other.way_m);
    return at.distance_m < other.clearance_m && at.along_m > 1e-6;
  }

  Announcement go(const Vec3& end_m) {
    result_.intent.to_m = end_m;
    return result_;
  }

  Announcement yield() {
    result_.yielding = true;
    return result_;
  }

  Announcement back_off(const Other& first) {
    if (&first != asker_) inherit(*standing_of(first));
    result_.yielding = true;
    std::vector<bool> way_first;
    for (const Other& other : others_) way_first.push_back(&other == &first || is_first(other));
    const BackOff found = find_back_off(map_, self_.start_m, others_, way_first);
    result_.intent.asks = found.blocked_by;
    for (const CellIndex cell : found.cells) {
      const Vec3 end = map_.grid().centre_m(map_.grid().cell_at(cell));
      if (may_end(end)) result_.intent.to_m = end;
    }
    const Vec3 centre = map_.grid().centre_m(map_.grid().cell_of(self_.start_m));
    if (!found.cells.empty() && result_.intent.to_m == self_.start_m && may_end(centre)) result_.intent.to_m = centre;
    return result_;
  }

  [[nodiscard]] bool may_end(const Vec3& end_m) const {
    if ((end_m - self_.start_m).norm() > self_.body.reach_m) return false;
    if (!map_.motion_clear(self_.start_m, end_m, self_.body.radius_m, Need::SeenFree)) return false;
    return std::none_of(others_.begin(), others_.end(), [&](const Other& other) {
      return conflict_of(self_.start_m, end_m, end_m, other, false) == Conflict::Standing;
    });
  }

  const KnownMap& map_;
  const Traveller& self_;
  std::span<const Other> others_;
  const Other* asker_ = nullptr;
  Key key_;
  Announcement result_;
};

}  // namespace

Announcement negotiate(const KnownMap& map, const Traveller& traveller, std::span<const Option> options,
                       const std::function<std::vector<Option>()>& detours, std::span<const Other> others) {
  return Negotiation(map, traveller, others).run(options, detours);
}

Announcement announce_plainly(const Traveller& traveller, std::span<const Option> options,
                              std::span<const Other> others) {
  Announcement result;
  result.intent = traveller.own;
  result.intent.to_m = traveller.start_m;
  for (const Option& option : options) {
    const bool free = std::all_of(others.begin(), others.end(), [&](const Other& other) {
      return conflict_of(traveller.start_m, option.end_m, option.after_m, other, false) == Conflict::None;
    });
    if (!free) continue;
    result.intent.to_m = option.end_m;
    break;
  }
  return result;
}

}  // namespace skein::gridnav
