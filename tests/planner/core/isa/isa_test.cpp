#include "planner/core/isa/isa.hpp"

#include <gtest/gtest.h>

namespace skein {
namespace {

TEST(Isa, EverySupportedNameIsTakenAtItsWord) {
  int supported = 0;
  for (const Isa isa : kIsas) {
    const std::string name(name_of(isa));
    if (!is_supported(isa)) continue;
    ++supported;
    EXPECT_EQ(isa_fault(name.c_str()), std::nullopt) << name;
    EXPECT_EQ(chosen_isa(name.c_str()), isa) << name;
  }
  EXPECT_GE(supported, 2);  // scalar and baseline, everywhere
}

TEST(Isa, OneThatTheProcessorLacksIsAFault) {
  for (const Isa isa : kIsas) {
    const std::string name(name_of(isa));
    const auto fault = isa_fault(name.c_str());
    EXPECT_EQ(fault.has_value(), !is_supported(isa));
    EXPECT_EQ(fault.value_or("this processor lacks").find("this processor lacks") == std::string::npos, false);
  }
}

TEST(Isa, AnUnknownNameIsAFaultThatNamesTheAllowedOnes) {
  const auto fault = isa_fault("sse9");
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->find("SKEIN_ISA is 'sse9', which is no instruction set; allowed here: scalar, baseline"), 0U)
      << *fault;
}

TEST(Isa, UnsetOrEmptyMeansTheWidest) {
  Isa widest = Isa::Baseline;
  for (const Isa isa : kIsas) {
    if (is_supported(isa)) widest = isa;  // they are listed by width
  }
  EXPECT_EQ(isa_fault(nullptr), std::nullopt);
  EXPECT_EQ(isa_fault(""), std::nullopt);
  EXPECT_EQ(chosen_isa(nullptr), widest);
  EXPECT_EQ(chosen_isa(""), widest);
}

}  // namespace
}  // namespace skein
