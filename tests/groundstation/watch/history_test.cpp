#include "groundstation/watch/history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::watch {
namespace {

using ::testing::ElementsAre;

TEST(History, KeepsEverythingWhileThereIsRoom) {
  History<int> history(8);
  for (int i = 0; i < 5; ++i) history.add(i);
  EXPECT_THAT(history.entries(), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_EQ(history.last(), 4);
}

TEST(History, ThinsOutAndKeepsTheFirstAndTheNewest) {
  History<int> history(8);
  for (int i = 0; i < 8; ++i) history.add(i);
  EXPECT_THAT(history.entries(), ElementsAre(0, 2, 4, 6, 7));
  history.add(8);
  EXPECT_THAT(history.entries(), ElementsAre(0, 2, 4, 6, 8));
  history.add(9);
  EXPECT_THAT(history.entries(), ElementsAre(0, 2, 4, 6, 8, 9));
}

TEST(History, StaysBoundedAndEven) {
  History<int> history(8);
  for (int i = 0; i < 1000; ++i) {
    history.add(i);
    ASSERT_LT(history.entries().size(), 8U);
    ASSERT_EQ(history.entries().front(), 0);
    ASSERT_EQ(history.last(), i);
  }
  const int stride = history.entries()[1];
  for (std::size_t k = 0; k + 1 < history.entries().size(); ++k) {
    EXPECT_EQ(history.entries()[k], static_cast<int>(k) * stride);
  }
}

}  // namespace
}  // namespace skein::watch
