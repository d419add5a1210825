// What the tests of refusals share: a valid sample, spoilt in one field, is refused with that field and reason.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include "tests/idl/convert/examples.hpp"

namespace skein::refusals {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline const std::vector<RosterEntry> kRoster{{1, 1, 0x1111, true, true}, {3, 2, 0x3333, true, true}};
inline const std::vector<AgentId> kKnown{1, 3};

inline WireContext strict() {
  return {.run = 77,
          .known = kKnown,
          .roster = std::span<const RosterEntry>(kRoster),
          .particle_size = 2,
          .grid = CellGrid{Vec3::Zero(), 2.0, 4.0, 20, 12, 1}};
}

template <typename Wire>
struct Case {
  std::string_view where;
  WireFaultReason reason;
  std::function<void(Wire&)> spoil;
};

template <typename Wire>
void expect_refused(const Wire& valid, const std::vector<Case<Wire>>& cases) {
  ASSERT_TRUE(from_wire(valid, strict()).ok()) << from_wire(valid, strict()).fault().where;
  for (const Case<Wire>& bad : cases) {
    Wire sample = valid;
    bad.spoil(sample);
    const auto checked = from_wire(sample, strict());
    ASSERT_FALSE(checked.ok()) << bad.where;
    EXPECT_EQ(checked.fault().where, bad.where);
    EXPECT_EQ(checked.fault().reason, bad.reason)
        << bad.where << ": " << name_of(checked.fault().reason) << ", not " << name_of(bad.reason);
  }
}

}  // namespace skein::refusals
