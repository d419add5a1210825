// Time left, and when a line of progress is shown.
#include "groundstation/sweep/progress.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace skein {
namespace {

TEST(Progress, TimeLeftIsThatOfTheRunsThatWereMadeHere) {
  EXPECT_EQ(progress_text(10, 40, 0, 20.0), "10 of 40 runs, 1 min 0 s left");
  EXPECT_EQ(progress_text(30, 40, 20, 20.0), "30 of 40 runs, 20 s left");
  EXPECT_EQ(progress_text(1, 1000, 0, 10.0), "1 of 1000 runs, 2 h 46 min left");
  EXPECT_EQ(progress_text(20, 40, 20, 5.0), "20 of 40 runs");
  EXPECT_EQ(progress_text(40, 40, 0, 5.0), "40 of 40 runs");
}

TEST(Progress, OnATerminalALineIsRewrittenAndEnded) {
  std::ostringstream out;
  ProgressLine line(out, ProgressKind::Terminal, "sweep", 100.0);
  line.show(1, 4, 100.05);  // too soon
  line.show(2, 4, 101.0);
  line.show(4, 4, 101.01);
  line.end();
  EXPECT_EQ(out.str(), "\r\x1b[Ksweep: 2 of 4 runs, 1 s left\r\x1b[Ksweep: 4 of 4 runs\n");
}

TEST(Progress, ElsewhereALineEveryTenSecondsAndAtTheEnd) {
  std::ostringstream out;
  ProgressLine line(out, ProgressKind::Lines, "sweep", 0.0);
  for (std::size_t done = 1; done <= 30; ++done) line.show(done, 30, static_cast<double>(done));
  line.end();
  EXPECT_EQ(out.str(), "sweep: 10 of 30 runs, 20 s left\nsweep: 20 of 30 runs, 10 s left\nsweep: 30 of 30 runs\n");
}

TEST(Progress, NoneSaysNothing) {
  std::ostringstream out;
  ProgressLine line(out, ProgressKind::None, "sweep", 0.0);
  line.show(30, 30, 100.0);
  line.end();
  EXPECT_EQ(out.str(), "");
}

TEST(InterruptedText, SaysHowFarItIsAndHowItGoesOn) {
  EXPECT_EQ(interrupted_text(3, 30, "j"),
            "interrupted: 3 of 30 runs are done; the same command with --resume j goes on with them");
  EXPECT_EQ(
      interrupted_text(3, 30, ""),
      "interrupted: 3 of 30 runs are done; to be able to go on with them a job needs --resume FILE from its start");
}

}  // namespace
}  // namespace skein
