#include "idl/bus/inbox.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <thread>

namespace skein::bus {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

bool readable(const Wake& wake) {
  pollfd polled{wake.fd(), POLLIN, 0};
  return ::poll(&polled, 1, 0) == 1;
}

TEST(Inbox, RingsWhenPutAndIsQuietWhenDrained) {
  const Wake wake;
  Inbox<int> inbox(8, wake);
  EXPECT_FALSE(readable(wake));
  inbox.put(1);
  inbox.put(2);
  EXPECT_TRUE(readable(wake));
  std::vector<int> into{0};
  inbox.drain(into);
  EXPECT_THAT(into, ElementsAre(0, 1, 2));
  EXPECT_FALSE(readable(wake));
}

TEST(Inbox, WakesOnceTheCountedSamplesThatAreWaitedForAreThere) {
  const Wake wake;
  Inbox<int> inbox(8, wake);
  std::vector<int> into;
  inbox.wake_after(2);
  inbox.put(1, Ring::Counted);
  inbox.put(2, Ring::Silent);
  EXPECT_FALSE(readable(wake));
  inbox.put(3, Ring::Counted);
  EXPECT_TRUE(readable(wake));
  inbox.drain(into);
  EXPECT_THAT(into, ElementsAre(1, 2, 3));
  inbox.put(4, Ring::Counted);
  EXPECT_FALSE(readable(wake)) << "the count starts anew";
  inbox.put(5, Ring::Now);
  EXPECT_TRUE(readable(wake));
}

TEST(Inbox, WhoWaitsForFewerIsWokenByWhatIsThereAlready) {
  const Wake wake;
  Inbox<int> inbox(8, wake);
  inbox.wake_after(SIZE_MAX);
  inbox.put(1, Ring::Silent);
  inbox.put(2, Ring::Counted);
  inbox.wake_after(2);
  EXPECT_FALSE(readable(wake));
  inbox.wake_after(1);
  EXPECT_TRUE(readable(wake));
  std::vector<int> into;
  inbox.drain(into);
  inbox.put(3, Ring::Silent);
  EXPECT_FALSE(readable(wake));
  inbox.wake_after(0);
  EXPECT_TRUE(readable(wake)) << "0: any sample";
}

TEST(Inbox, LosesTheOldestWhenFullAndCountsIt) {
  const Wake wake;
  Inbox<int> inbox(2, wake);
  for (int i = 1; i <= 5; ++i) inbox.put(i);
  std::vector<int> into;
  inbox.drain(into);
  EXPECT_THAT(into, ElementsAre(4, 5));
  EXPECT_EQ(inbox.lost(), 3u);
}

TEST(Inbox, TakesFromOneThreadWhatAnotherPuts) {
  constexpr int kCount = 10000;
  const Wake wake;
  Inbox<int> inbox(kCount, wake);
  std::thread writer([&] {
    for (int i = 0; i < kCount; ++i) inbox.put(i);
  });
  std::vector<int> into;
  while (into.size() < kCount) {
    pollfd polled{wake.fd(), POLLIN, 0};
    if (::poll(&polled, 1, 10000) != 1) break;
    inbox.drain(into);
  }
  writer.join();
  ASSERT_EQ(into.size(), std::size_t{kCount});
  for (int i = 0; i < kCount; ++i) EXPECT_EQ(into[static_cast<std::size_t>(i)], i);
}

TEST(Wake, ManyRingsAreOneAndClearIsIdempotent) {
  const Wake wake;
  for (int i = 0; i < 1000; ++i) wake.ring();
  EXPECT_TRUE(readable(wake));
  wake.clear();
  wake.clear();
  EXPECT_FALSE(readable(wake));
}

}  // namespace
}  // namespace skein::bus
