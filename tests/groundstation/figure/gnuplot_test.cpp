// gnuplot as a child: a picture, or one line that says why there is none.
#include "groundstation/figure/gnuplot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::figure {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string failure_of(const std::string& script, double deadline_s, const std::string& program) {
  try {
    (void)draw(script, deadline_s, program);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(Gnuplot, DrawsSvgAndPng) {
  EXPECT_THAT(draw("set terminal svg\nplot x\n"), HasSubstr("</svg>"));
  EXPECT_THAT(draw("set terminal pngcairo\nplot x\n"), StartsWith("\x89PNG"));
}

TEST(Gnuplot, MoreThanAPipeHolds) {
  std::string script = "set terminal svg\n$points << EOD\n";
  for (int i = 0; i < 60'000; ++i) script += std::to_string(i) + " " + std::to_string(i % 7) + "\n";
  EXPECT_GT(draw(script + "EOD\nplot $points with lines\n").size(), 100'000U);
}

TEST(Gnuplot, WhatItRefusesIsSaidInOneLine) {
  const std::string said = failure_of("set terminal svg\nplot nonsense(\n", 30.0, "gnuplot");
  EXPECT_THAT(said, StartsWith("gnuplot failed: "));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0);
}

TEST(Gnuplot, IsNamedWithItsPackageWhereItIsNotThere) {
  EXPECT_THROW((void)draw("", 30.0, "no-such-gnuplot"), NoGnuplot);
  EXPECT_THAT(failure_of("", 30.0, "no-such-gnuplot"), HasSubstr("gnuplot-nox"));
}

TEST(Gnuplot, IsKilledAtItsDeadline) {
  EXPECT_THAT(failure_of("while (1) { x = 1 }\n", 0.2, "gnuplot"), HasSubstr("did not end within 0.2 s"));
}

}  // namespace
}  // namespace skein::figure
