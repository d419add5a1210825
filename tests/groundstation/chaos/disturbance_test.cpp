// Files of faults, read or refused in one line.
#include "groundstation/chaos/disturbance.hpp"

#include <gtest/gtest.h>

namespace skein::chaos {
namespace {

using Kinds = std::vector<Disturbance>;

TEST(Disturbance, AFileNamesOneALineSomeWithAnAmount) {
  const auto read = read_kinds("# what is tried\nkill\n\n  world  # twice as often\nworld\ndrop 0.1\ndelay\n", "f");
  ASSERT_TRUE(std::holds_alternative<Kinds>(read)) << std::get<std::string>(read);
  EXPECT_EQ(std::get<Kinds>(read),
            (Kinds{{Kind::Kill}, {Kind::World}, {Kind::World}, {Kind::Drop, 0.1}, {Kind::Delay, 20.0}}));
}

TEST(Disturbance, EveryNameIsReadAsItsKind) {
  for (const Disturbance& kind : all_kinds()) {
    EXPECT_EQ(std::get<Kinds>(read_kinds(std::string(name_of(kind.kind)), "f")), Kinds{kind});
  }
}

TEST(Disturbance, AMistakeIsNamedWithItsLine) {
  const std::string allowed = "kill, stop, restart, world, pause, slow, drop, delay, partition";
  const std::pair<const char*, std::string> mistakes[] = {
      {"kill\nmelt\n", "f:2:1: unknown fault 'melt'; allowed: " + allowed},
      {"# nothing\n", "f:1:1: no fault is named; allowed: " + allowed},
      {"kill 3", "f:1:1: 'kill' takes nothing after it"},
      {"partition 2", "f:1:1: 'partition' takes nothing after it"},
      {"drop 0.1 0.2", "f:1:1: 'drop' takes nothing after it"},
      {"drop 0.6", "f:1:1: '0.6' is no amount for drop; allowed: 0.001 to 0.5"},
      {"drop nan", "f:1:1: 'nan' is no amount for drop; allowed: 0.001 to 0.5"},
      {"delay 10x", "f:1:1: '10x' is no amount for delay; allowed: 1 to 1000 Mbit/s"},
  };
  for (const auto& [text, line] : mistakes) {
    const auto read = read_kinds(text, "f");
    ASSERT_TRUE(std::holds_alternative<std::string>(read)) << text;
    EXPECT_EQ(std::get<std::string>(read), line);
  }
}

TEST(Disturbance, OnlyWhatActsBelowDdsNeedsTheMachinesLeave) {
  for (const Disturbance& kind : all_kinds()) {
    if (needs_network(kind.kind)) continue;
    EXPECT_EQ(obstacle_to(kind.kind), std::nullopt) << name_of(kind.kind);
  }
  EXPECT_NE(network_script({Kind::Drop, 0.1}).find("--probability 0.1000 -j DROP"), std::string::npos);
  EXPECT_NE(network_script({Kind::Delay, 5.0}).find("rate 5.000mbit"), std::string::npos);
}

}  // namespace
}  // namespace skein::chaos
