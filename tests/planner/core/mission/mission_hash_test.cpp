#include <gtest/gtest.h>

#include <set>

#include "planner/core/mission/mission.hpp"

namespace skein {
namespace {

TEST(MissionHash, EveryPlannerOptionChangesIt) {
  std::set<std::uint64_t> seen{mission_hash(Mission{})};
  for (const RendezvousField& field : kRendezvousFields) {
    Mission mission;
    std::visit(
        [&](auto member) {
          auto& value = mission.planner.*member;
          value = static_cast<std::decay_t<decltype(value)>>(value == field.max ? field.min : field.max);
        },
        field.member);
    EXPECT_TRUE(seen.insert(mission_hash(mission)).second) << field.key;
  }
}

TEST(MissionHash, SoDoesThePlannersName) {
  std::set<std::uint64_t> seen;
  for (const std::string_view name : kRendezvousPlanners) {
    Mission mission;
    mission.planner.name = name;
    EXPECT_TRUE(seen.insert(mission_hash(mission)).second) << name;
  }
}

}  // namespace
}  // namespace skein
