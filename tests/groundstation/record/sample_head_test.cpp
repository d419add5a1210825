// What the first bytes of a sample say is what its type decodes from them.
#include "groundstation/record/sample_head.hpp"

#include <gtest/gtest.h>

#include "idl/convert/cdr.hpp"
#include "tests/idl/convert/examples.hpp"

namespace skein {
namespace {

using bus::TopicId;

template <typename Value>
void expect_head(TopicId topic, const Value& value) {
  const auto sample = to_wire(value, examples::kStamp);
  const Bytes payload = to_cdr(sample);
  const auto head = head_of(topic, payload);
  ASSERT_TRUE(head);
  EXPECT_EQ(head->run, sample.head().run());
  EXPECT_EQ(head->stamp_ns, sample.head().stamp_ns());
  EXPECT_EQ(head->sender, sample.head().sender());
  EXPECT_EQ(head->incarnation, sample.head().incarnation());
  if constexpr (requires { sample.agent(); }) {
    EXPECT_EQ(head->agent, sample.agent());
  }
  if constexpr (requires { sample.round(); }) {
    EXPECT_EQ(head->round, sample.round());
  }
}

TEST(SampleHead, IsWhatTheTypesSay) {
  expect_head(TopicId::Mission, examples::mission());
  expect_head(TopicId::Tick, examples::tick());
  expect_head(TopicId::Sense, examples::sense());
  expect_head(TopicId::Beacon, examples::beacon());
  expect_head(TopicId::Representative, examples::representative());
  expect_head(TopicId::ObstacleMap, examples::obstacle_map());
}

TEST(SampleHead, IsReadFromBigEndianBytesToo) {
  Bytes payload(4 + 28 + 4, 0);
  payload[4 + 7] = 9;   // run
  payload[4 + 27] = 3;  // agent
  payload[4 + 30] = 1;  // round
  const auto head = head_of(TopicId::Sense, payload);
  ASSERT_TRUE(head);
  EXPECT_EQ(head->run, 9U);
  EXPECT_EQ(head->agent, 3U);
  EXPECT_EQ(head->round, 256U);
}

TEST(SampleHead, IsNotThereIfTheBytesEndBefore) {
  const Bytes payload = to_cdr(to_wire(examples::beacon(), examples::kStamp));
  for (const std::size_t size : {0U, 3U, 4U, 20U, 51U}) {
    EXPECT_EQ(head_of(TopicId::Beacon, std::span(payload).first(size)).has_value(), false) << size;
  }
  EXPECT_TRUE(head_of(TopicId::Beacon, std::span(payload).first(52)));
}

}  // namespace
}  // namespace skein
