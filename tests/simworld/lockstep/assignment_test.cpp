// Processes without an id: which one the world holds for them, and until when.
#include <gtest/gtest.h>

#include "simworld/lockstep/admission.hpp"
#include "tests/simworld/lockstep/stage.hpp"

namespace skein {
namespace {

using test::introduction;
using test::nonce_of;
using test::Stage;
using Given = std::vector<Assignment>;

constexpr double kSilence_s = 10.0;

Admission three() {
  return {test::kRun, test::kWorldNonce, {1, 2, 5}, kSilence_s};
}
Beacon request(std::uint64_t nonce) {
  Beacon beacon = introduction(kWorldId, {}, nonce);
  beacon.run = 0;
  return beacon;
}
bool ask(Admission& admission, std::uint64_t nonce, double now_s = 0.0) {
  return admission.introduce(request(nonce), now_s);
}

TEST(Assignment, GivesTheLowestIdThatNobodyHolds) {
  Admission admission = three();
  admission.introduce(introduction(1, {}), 0.0);
  EXPECT_TRUE(ask(admission, 501));
  EXPECT_TRUE(ask(admission, 502));
  EXPECT_EQ(admission.take_assigned(), (Given{{501, 2}, {502, 5}}));
  EXPECT_TRUE(admission.take_assigned().empty());
  EXPECT_EQ(admission.introduced(), 3U);
  EXPECT_TRUE(admission.take_refused().empty());
}

TEST(Assignment, AProcessThatAsksAgainIsToldTheSame) {
  Admission admission = three();
  ask(admission, 501);
  ask(admission, 501);
  EXPECT_EQ(admission.take_assigned(), (Given{{501, 1}}));
  ask(admission, 501, 0.25);
  EXPECT_EQ(admission.take_assigned(), (Given{{501, 1}}));
}

TEST(Assignment, WhoFindsNoFreeIdWaitsForOne) {
  Admission admission = three();
  for (const std::uint64_t nonce : {501, 502, 503, 504}) ask(admission, nonce);
  EXPECT_EQ(admission.take_assigned(), (Given{{501, 1}, {502, 2}, {503, 5}}));
  admission.forget(502);
  ask(admission, 504, 1.0);
  EXPECT_EQ(admission.take_assigned(), (Given{{504, 2}}));
  EXPECT_TRUE(admission.take_refused().empty());
}

TEST(Assignment, AnIdWhoseHolderIsSilentIsGivenAnew) {
  Admission admission = three();
  admission.introduce(introduction(1, {}), 0.0);
  for (const AgentId id : {2U, 5U}) admission.introduce(introduction(id, {}), 5.0);
  ask(admission, 501, kSilence_s - 0.1);
  EXPECT_TRUE(admission.take_assigned().empty());
  ask(admission, 501, kSilence_s);
  EXPECT_EQ(admission.take_assigned(), (Given{{501, 1}}));
}

TEST(Assignment, TheHolderGoesOnUnderItsIdAndNonce) {
  Admission admission(test::kRun, test::kWorldNonce, {1}, kSilence_s);
  ask(admission, 501);
  EXPECT_FALSE(admission.roster(std::vector<std::uint64_t>{501}).has_value());
  EXPECT_FALSE(admission.introduce(introduction(1, {test::kWorldNonce}, 501), 0.5));
  ask(admission, 501, 0.5);  // a late copy takes nothing back
  const auto roster = admission.roster(std::vector<std::uint64_t>{501});
  ASSERT_TRUE(roster.has_value());
  EXPECT_EQ(roster->front().agent, 1U);
  EXPECT_EQ(roster->front().nonce, 501U);
}

TEST(Assignment, AnotherProcessWithThatIdIsRefused) {
  Admission admission = three();
  ask(admission, 501);
  admission.introduce(introduction(1, {}), 0.1);
  ask(admission, 501, 0.2);
  admission.introduce(introduction(1, {}, 501), 0.3);
  EXPECT_EQ(admission.take_refused(), (std::vector<Refusal>{{nonce_of(1), RefusalReason::IdInUse}}));
}

TEST(Assignment, ALostAgentsIdIsGivenAndComesBackUnderTheNextIncarnation) {
  Admission admission(test::kRun, test::kWorldNonce, {1, 2}, kSilence_s);
  for (const AgentId id : {1U, 2U}) admission.introduce(introduction(id, {}), 0.0);
  admission.close();
  ask(admission, 501, 20.0);
  EXPECT_TRUE(admission.take_assigned().empty());  // a live agent may be silent between its ticks
  admission.lose(2, 30, false);
  ask(admission, 501, 20.5);
  EXPECT_EQ(admission.take_assigned(), (Given{{501, 2}}));
  const std::vector<std::uint64_t> live{nonce_of(1)};
  EXPECT_TRUE(admission.returning(std::vector<std::uint64_t>{501}, live, 20.5).empty());
  admission.introduce(introduction(2, {test::kWorldNonce, nonce_of(1)}, 501), 21.0);
  const auto back = admission.returning(std::vector<std::uint64_t>{501}, live, 21.0);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].agent, 2U);
  EXPECT_EQ(back[0].incarnation, 2U);
}

TEST(Assignment, TheNextTickTellsIt) {
  Stage stage(2);
  stage.introduce(1);
  stage.say(request(501));
  stage.at(0.0);
  EXPECT_EQ(stage.last_tick().assigned, (Given{{501, 2}}));
  stage.at(0.5);
  EXPECT_TRUE(stage.last_tick().assigned.empty());
  EXPECT_EQ(stage.session.introduced(), 2U);
  Beacon goodbye = request(501);
  goodbye.mode = AgentMode::Leaving;
  stage.say(goodbye);
  stage.at(0.6);
  EXPECT_EQ(stage.session.introduced(), 1U);
}

TEST(Assignment, ALiveAgentsIdIsNotGivenInARun) {
  Stage stage(2);
  const Tick first = stage.start();
  Beacon asks = request(501);
  asks.round = first.round;  // it has heard a tick: the ticks need no break for it
  stage.say(asks);
  const Tick second = stage.round(first, AgentMode::Planning);
  EXPECT_TRUE(second.assigned.empty());
  EXPECT_EQ(second.roster.size(), 2U);
}

}  // namespace
}  // namespace skein
