#include "planner/core/options/rendezvous_options.hpp"

#include <gtest/gtest.h>

namespace skein {
namespace {

TEST(RendezvousOptions, EveryPlannerHasLegalDefaultsUnderItsName) {
  for (const std::string_view name : kRendezvousPlanners) {
    const auto options = defaults_of(name);
    ASSERT_TRUE(options.has_value()) << name;
    EXPECT_EQ(options->name, name);
    EXPECT_FALSE(validate(*options).has_value()) << name;
  }
  EXPECT_FALSE(defaults_of("dcpso ").has_value());
  EXPECT_FALSE(defaults_of("").has_value());
}

TEST(RendezvousOptions, PlannersDifferAsDocumented) {
  EXPECT_EQ(*defaults_of("dcpso"), RendezvousOptions{});
  RendezvousOptions solo;
  solo.name = "dcpso-solo";
  solo.equalise = 0;
  solo.cooperate = 0;
  EXPECT_EQ(*defaults_of("dcpso-solo"), solo);
  RendezvousOptions paper;
  paper.name = "dcpso-paper";
  paper.equalise = 0;
  paper.max_segments = 1;
  paper.reinitialise_probability = 0.0;
  paper.velocity_limit = 0.2;
  EXPECT_EQ(*defaults_of("dcpso-paper"), paper);
  RendezvousOptions genetic = paper;
  genetic.name = "ccga";
  genetic.own_reference = 0;
  EXPECT_EQ(*defaults_of("ccga"), genetic);
}

TEST(RendezvousOptions, AnUnknownPlannerIsNamedWithThoseThatThereAre) {
  RendezvousOptions options;
  options.name = "best";
  const auto fault = validate(options);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->key, "name");
  EXPECT_EQ(fault->message, "'best' is no rendezvous planner; allowed: dcpso, dcpso-paper, dcpso-solo, ccga");
}

TEST(RendezvousOptions, AValueOutOfRangeIsNamedWithItsRange) {
  RendezvousOptions options;
  options.mutation_probability = 1.5;
  const auto fault = validate(options);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->message, "mutation_probability is 1.5; allowed: 0 to 1");
}

}  // namespace
}  // namespace skein
