#include "idl/process/turn.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace skein {
namespace {

TEST(Turn, NobodyIsServedWithoutAService) {
  Turn turn;
  EXPECT_FALSE(turn.take());
  int served = 0;
  {
    const Turn::Service service(turn, [&] { return ++served > 0; });
    EXPECT_TRUE(turn.take());
  }
  EXPECT_FALSE(turn.take());
  EXPECT_EQ(served, 1);
}

TEST(Turn, TheOwnThreadIsWokenWhenThereIsMoreToDo) {
  Turn turn;
  const Turn::Service service(turn, [] { return false; });
  EXPECT_FALSE(turn.take());
}

TEST(Turn, WhoComesWhileTheOwnThreadServesDoesNotWait) {
  Turn turn;
  bool served = false;
  const Turn::Service service(turn, [&] { return served = true; });
  const auto lock = turn.own();
  std::thread other([&] { EXPECT_FALSE(turn.take()); });
  other.join();
  EXPECT_FALSE(served);
}

TEST(Turn, WhatAThreadOfDdsMeetsReachesTheOwnThreadOnce) {
  Turn turn;
  int calls = 0;
  const Turn::Service service(turn, [&]() -> bool {
    ++calls;
    throw std::runtime_error("no such vehicle");
  });
  EXPECT_FALSE(turn.take());
  EXPECT_FALSE(turn.take());  // not again before the own thread knows
  EXPECT_EQ(calls, 1);
  EXPECT_THROW((void)turn.own(), std::runtime_error);
  EXPECT_NO_THROW((void)turn.own());
}

TEST(Turn, OneServesAtATime) {
  constexpr int kTries = 2000;
  Turn turn;
  int inside = 0;  // guarded by the turn alone
  std::atomic<int> served = 0;
  std::atomic<bool> overlapped = false;
  const auto serve = [&] {
    if (++inside != 1) overlapped = true;
    ++served;
    --inside;
    return true;
  };
  const Turn::Service service(turn, serve);
  std::thread dds([&] {
    for (int i = 0; i < kTries; ++i) (void)turn.take();
  });
  for (int i = 0; i < kTries; ++i) {
    const auto lock = turn.own();
    serve();
  }
  dds.join();
  EXPECT_FALSE(overlapped);
  EXPECT_GE(served, kTries);
}

}  // namespace
}  // namespace skein
