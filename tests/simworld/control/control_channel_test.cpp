// The line between launcher and world: whole messages, and the end of the other end.
#include "simworld/control/control_channel.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <numeric>
#include <string>
#include <vector>

namespace skein {
namespace {

using Json = nlohmann::json;

TEST(ControlChannel, MessagesKeepTheirBoundariesBothWays) {
  auto [near, far] = ControlChannel::pair();
  EXPECT_FALSE(near.receive().has_value());
  std::vector<int> all(256);
  std::iota(all.begin(), all.end(), 1);
  near.send({{"launch", all}});
  near.send({{"kill", 2}});
  far.send({{"started", {1, 2}}, {"pid", 77}});
  EXPECT_EQ(far.receive(), Json({{"launch", all}})) << "the longest list";
  EXPECT_EQ(far.receive(), Json({{"kill", 2}}));
  EXPECT_FALSE(far.receive().has_value());
  EXPECT_EQ(near.receive(), Json({{"started", {1, 2}}, {"pid", 77}}));
  EXPECT_TRUE(near.open());
  EXPECT_TRUE(far.open());
}

TEST(ControlChannel, NoticesThatTheOtherEndIsGoneAfterItsLastWords) {
  auto [near, far] = ControlChannel::pair();
  far.send({{"ended", 2}});
  far.close();
  EXPECT_FALSE(far.open());
  EXPECT_EQ(near.receive(), Json({{"ended", 2}}));
  EXPECT_FALSE(near.receive().has_value());
  EXPECT_FALSE(near.open());
  near.send({{"kill", 1}});  // reaches nobody, and raises no signal
  EXPECT_FALSE(near.receive().has_value());
}

TEST(ControlChannel, SendingToAnEndThatIsGoneClosesTheChannel) {
  auto [near, far] = ControlChannel::pair();
  far.close();
  near.send({{"kill", 1}});
  EXPECT_FALSE(near.open());
}

TEST(ControlChannel, LeavesOutWhatMayBeLeftOutWhileTheOtherEndIsSlow) {
  auto [near, far] = ControlChannel::pair();
  for (int i = 0; i < 5000; ++i) near.send({{"progress", i}}, true);
  EXPECT_TRUE(near.open());
  int arrived = 0;
  while (const auto message = far.receive()) EXPECT_EQ(message->at("progress"), arrived++);
  EXPECT_GT(arrived, 10);
  EXPECT_LT(arrived, 5000);
  near.send({{"progress", -1}}, true);
  EXPECT_EQ(far.receive(), Json({{"progress", -1}}));
}

TEST(ControlChannel, WhatIsNoObjectIsSkipped) {
  auto [near, far] = ControlChannel::pair();
  for (const std::string& text : {std::string("{\"launch\": "), std::string("[1, 2]"), std::string("\xff\xfe")}) {
    ASSERT_EQ(send(near.fd(), text.data(), text.size(), 0), static_cast<ssize_t>(text.size()));
    EXPECT_FALSE(far.receive().has_value());
    EXPECT_TRUE(far.open());
  }
}

TEST(ControlChannel, OnlyTheSecondEndSurvivesExec) {
  auto [near, far] = ControlChannel::pair();
  EXPECT_EQ(fcntl(near.fd(), F_GETFD) & FD_CLOEXEC, FD_CLOEXEC);
  EXPECT_EQ(fcntl(far.fd(), F_GETFD) & FD_CLOEXEC, 0);
  const ControlChannel taken(far.release());  // what the child does with the number it is given
  EXPECT_FALSE(far.open());
  EXPECT_EQ(fcntl(taken.fd(), F_GETFD) & FD_CLOEXEC, FD_CLOEXEC);
}

TEST(ControlChannel, WithoutADescriptorItIsClosed) {
  ControlChannel channel(-1);
  EXPECT_FALSE(channel.open());
  channel.send({{"progress", 1}});
  EXPECT_FALSE(channel.receive().has_value());
}

}  // namespace
}  // namespace skein
