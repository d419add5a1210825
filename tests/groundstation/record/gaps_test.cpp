// What was lost of each writer is counted by its numbers; what a recorder has of a round, by what the round's tick and
// beacons announce.
#include "groundstation/record/gaps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "groundstation/record/round_book.hpp"
#include "idl/convert/cdr.hpp"
#include "idl/convert/convert.hpp"

namespace skein {
namespace {

using bus::TopicId;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

bus::RawSample sample_of(std::uint8_t writer, std::uint64_t sequence, TopicId topic = TopicId::Beacon) {
  bus::RawSample sample;
  sample.topic = topic;
  sample.writer[0] = writer;
  sample.sequence = sequence;
  return sample;
}

TEST(Gaps, CountWhatIsMissingBetweenTheFirstAndTheLast) {
  Gaps gaps;
  for (const std::uint64_t sequence : {5U, 6U, 9U, 12U}) gaps.note(sample_of(1, sequence), false, 3);
  gaps.note(sample_of(2, 100, TopicId::Tick), true, kWorldId);
  EXPECT_EQ(gaps.lost(), 4U);
  EXPECT_EQ(gaps.texts(), (mcap::Texts{{"lost", "4"},
                                       {"skein/beacon of agent 3", "kept 4 lost 4 from 5 to 12"},
                                       {"skein/tick of world", "kept 1 lost 0 from 100 to 100"}}));
}

TEST(Gaps, WritersOfOneNameAreKeptApart) {
  Gaps gaps;
  gaps.note(sample_of(1, 1), false, 3);
  gaps.note(sample_of(2, 7), false, 3);  // its process was restarted
  EXPECT_EQ(gaps.lost(), 0U);
  EXPECT_EQ(gaps.texts().size(), 3U);
  EXPECT_EQ(gaps.texts().at("skein/beacon of agent 3 #2"), "kept 1 lost 0 from 7 to 7");
}

TEST(Gaps, NothingHeardIsNothingLost) {
  EXPECT_EQ(Gaps().lost(), 0U);
}

class RoundBookTest : public ::testing::Test {
 protected:
  template <typename Value>
  void note(TopicId topic, const Value& value) {
    book.note(topic, to_cdr(to_wire(value, {})));
  }
  void tick(std::uint32_t round, Phase phase = Phase::Flying, bool sense = false) {
    Tick value;
    value.run = 9;
    value.round = round;
    value.phase = phase;
    value.roster = {{1, 1, 11}, {2, 4, 12}};
    for (RosterEntry& entry : value.roster) entry.sense = sense;
    note(TopicId::Tick, value);
  }
  void beacon(AgentId agent, std::uint32_t incarnation, std::uint32_t round, bool representative = false) {
    Beacon value;
    value.run = 9;
    value.agent = agent;
    value.incarnation = incarnation;
    value.round = round;
    value.closes_round = true;
    value.representative = representative;
    note(TopicId::Beacon, value);
  }
  RoundBook book;
};

TEST_F(RoundBookTest, LacksTheBeaconsOfTheRoster) {
  EXPECT_EQ(book.round(), 0U);
  EXPECT_THAT(book.lacking(), IsEmpty());
  tick(7);
  EXPECT_EQ(book.round(), 7U);
  EXPECT_THAT(book.lacking(), ElementsAre(1, 2));
  beacon(1, 1, 7);
  beacon(2, 3, 7);  // of an incarnation that is gone
  EXPECT_THAT(book.lacking(), ElementsAre(2));
  beacon(2, 4, 7);
  EXPECT_THAT(book.lacking(), IsEmpty());
  tick(8);
  EXPECT_THAT(book.lacking(), ElementsAre(1, 2));
}

TEST_F(RoundBookTest, LacksWhatIsSensedAndWhatABeaconSaysWasSent) {
  tick(7, Phase::Flying, true);
  beacon(1, 1, 7, true);
  beacon(2, 4, 7);
  EXPECT_THAT(book.lacking(), ElementsAre(1, 2));
  Sense sense;
  sense.run = 9;
  sense.agent = 2;
  sense.incarnation = 4;
  sense.round = 7;
  note(TopicId::Sense, sense);
  EXPECT_THAT(book.lacking(), ElementsAre(1));
  sense.agent = 1;
  sense.incarnation = 1;
  note(TopicId::Sense, sense);
  EXPECT_THAT(book.lacking(), ElementsAre(1));
  Representative representative;
  representative.run = 9;
  representative.agent = 1;
  representative.incarnation = 1;
  representative.round = 7;
  note(TopicId::Representative, representative);
  EXPECT_THAT(book.lacking(), IsEmpty());
}

TEST_F(RoundBookTest, TakesAnswersThatComeBeforeTheirTick) {
  tick(7);
  beacon(1, 1, 8);
  beacon(2, 4, 8);
  tick(8, Phase::Finished);
  EXPECT_THAT(book.lacking(), IsEmpty());
  EXPECT_TRUE(book.finished());
  tick(7);  // a late copy
  EXPECT_EQ(book.round(), 8U);
}

TEST_F(RoundBookTest, WaitingTicksAreNoRounds) {
  tick(0, Phase::Waiting);
  EXPECT_EQ(book.round(), 0U);
  EXPECT_FALSE(book.finished());
}

}  // namespace
}  // namespace skein
