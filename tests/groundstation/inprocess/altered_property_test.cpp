// The plan is made of what comes over the bus: one representative altered in transit changes the other agents' plans.
#include <functional>
#include <map>

#include "tests/groundstation/inprocess/tampering.hpp"

namespace skein {
namespace {

using test::paper_scenario;
using test::run_with;

using Edit = std::function<void(wire::Representative&)>;

/// Edits the representative that agent `from` published in round `round` on its way to agent `to` (0: to all agents).
/// @param altered counts the samples
bus::Tamper altering(AgentId from, AgentId to, std::uint32_t round, const Edit& edit, std::uint64_t& altered) {
  return [=, &altered](bus::Transit transit) {
    auto* sample = std::get_if<wire::Representative>(&transit.sample);
    const bool meant = to == 0 ? transit.to != kWorldId : transit.to == to;
    if (sample != nullptr && sample->agent() == from && sample->round() == round && meant && transit.from == from) {
      edit(*sample);
      ++altered;
    }
    return std::vector{transit};
  };
}

/// A longer way than anybody's: the reference length of the receivers' next generation.
void lengthen(wire::Representative& sample) {
  for (double& m : sample.particle()) m *= 1.05;
  sample.own_length_m(1.5 * sample.own_length_m());
  sample.path_length_m(1.05 * sample.path_length_m());
}

double planned_length_m(const InProcessResult& result, AgentId id) {
  for (const auto& vehicle : result.report.at("vehicles")) {
    if (vehicle.at("id") == id) return vehicle.at("planned_length_m").get<double>();
  }
  throw std::runtime_error("no such vehicle");
}

TEST(AlteredRepresentative, ToAllChangesTheOthersPlans) {
  int plans_changed = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = paper_scenario(seed);
    const InProcessResult honest = run_with(scenario, {});
    std::uint64_t altered = 0;
    const auto liar = static_cast<AgentId>(1 + seed % 3);
    const auto round = static_cast<std::uint32_t>(10 + 3 * seed);
    const InProcessResult lied = run_with(scenario, altering(liar, 0, round, lengthen, altered));
    ASSERT_EQ(altered, 2U) << seed;  // one sample, on its way to two peers
    ASSERT_NE(lied.report.at("state_hash"), honest.report.at("state_hash")) << seed;
    for (const AgentId id : {1U, 2U, 3U}) plans_changed += planned_length_m(lied, id) != planned_length_m(honest, id);
    ASSERT_TRUE(lied.exit_code == 0 || lied.exit_code == 1) << lied.report.dump(2);
    ASSERT_EQ(lied.report.at("collisions"), 0) << seed;
  }
  EXPECT_GE(plans_changed, 20);
}

TEST(AlteredRepresentative, ToOneReceiverChangesTheRun) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = paper_scenario(seed);
    const InProcessResult honest = run_with(scenario, {});
    std::uint64_t altered = 0;
    const auto receiver = static_cast<AgentId>(2 + seed % 2);
    const InProcessResult lied = run_with(scenario, altering(1, receiver, 30, lengthen, altered));
    ASSERT_EQ(altered, 1U) << seed;
    ASSERT_NE(lied.report.at("state_hash"), honest.report.at("state_hash")) << seed;
    ASSERT_TRUE(lied.exit_code == 0 || lied.exit_code == 1) << lied.report.dump(2);
  }
}

TEST(AlteredRepresentative, TheLastOneAlteredForOneReceiverIsAPlanThatItsPeersDidNotAccept) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = paper_scenario(seed);
    const InProcessResult honest = run_with(scenario, {});
    ASSERT_EQ(honest.report.at("unaccepted_plans"), 0) << seed;
    ASSERT_TRUE(honest.report.at("first_unaccepted_plan").is_null()) << seed;
    const auto last = honest.report.at("rounds").get<std::uint32_t>() - 1;  // upon which all are ready in the next
    const auto receiver = static_cast<AgentId>(2 + seed % 2);
    std::uint64_t altered = 0;
    const Edit hardly = [](wire::Representative& sample) { sample.particle()[0] *= 1.0 + 1e-12; };
    const InProcessResult lied = run_with(scenario, altering(1, receiver, last, hardly, altered));
    ASSERT_EQ(altered, 1U) << seed;
    ASSERT_EQ(lied.report.at("exit_code"), 0) << seed << ": " << lied.report.at("reason");
    ASSERT_EQ(lied.report.at("unaccepted_plans"), lied.report.at("steps")) << seed << ": one agent in each round";
    ASSERT_EQ(lied.report.at("first_unaccepted_plan").at("agent"), receiver) << seed;
    ASSERT_EQ(lied.report.at("first_unaccepted_plan").at("step"), 1) << seed;
  }
}

TEST(AlteredRepresentative, OfANewPlanUnderWayIsFoundToo) {
  const Scenario scenario = paper_scenario(1, "rendezvous-surprise");
  std::uint32_t last = 0;  // round in which agent 1 published the representative that the new plan is made of
  const InProcessResult honest = run_with(scenario, [&](bus::Transit transit) {
    const auto* sample = std::get_if<wire::Representative>(&transit.sample);
    if (sample != nullptr && sample->agent() == 1 && sample->reopening().empty()) last = sample->round();
    return std::vector{transit};
  });
  ASSERT_EQ(honest.report.at("replans").back().at("outcome"), "switched");
  ASSERT_GT(last, honest.report.at("rounds").get<std::uint32_t>()) << "in flight";
  ASSERT_EQ(honest.report.at("unaccepted_plans"), 0);
  std::uint64_t altered = 0;
  const Edit hardly = [](wire::Representative& sample) { sample.particle()[0] *= 1.0 + 1e-12; };
  const InProcessResult lied = run_with(scenario, altering(1, 2, last, hardly, altered));
  ASSERT_EQ(altered, 1U);
  EXPECT_GT(lied.report.at("unaccepted_plans"), 0);
  EXPECT_EQ(lied.report.at("first_unaccepted_plan").at("agent"), 2);
  EXPECT_EQ(lied.report.at("first_unaccepted_plan").at("step"), honest.report.at("replans").back().at("switch_step"));
}

TEST(AlteredRepresentative, AnyLegalParticleAtAnyTimeEndsInAVerdict) {
  RandomStream random(41, 1, Purpose::Test, 0);
  int runs_changed = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Scenario scenario = paper_scenario(seed);
    const auto liar = static_cast<AgentId>(1 + random.below(3));
    const VehicleSpec& spec = vehicle_of(scenario.mission, liar);
    const double chord_m = (slot_pose(scenario.mission, spec).position_m - spec.start.position_m).norm();
    const auto drawn_m = [&] { return random.uniform(0.04, 5.9) * chord_m; };
    const std::vector<double> particle{drawn_m(), drawn_m()};
    const auto round = static_cast<std::uint32_t>(random.uniform() < 0.5 ? 45 + random.below(9) : 1 + random.below(45));
    std::uint64_t altered = 0;
    const Edit edit = [&](wire::Representative& sample) { sample.particle(particle); };
    const InProcessResult lied = run_with(scenario, altering(liar, 0, round, edit, altered));
    ASSERT_LE(altered, 2U);
    ASSERT_TRUE(lied.exit_code == 0 || lied.exit_code == 1) << lied.report.dump(2);
    runs_changed += lied.report.at("state_hash") != run_with(scenario, {}).report.at("state_hash");
  }
  EXPECT_GE(runs_changed, 5);
}

TEST(AlteredRepresentative, InTheFirstExchangeChangesWhatTheReceiverDoesNext) {
  // only agent 2 hears the lie about round 1: in round 2 its hash differs, and agent 3's does not
  const Scenario scenario = paper_scenario(1);
  const auto hashes_of = [&](const bus::Tamper& tamper) {
    std::map<AgentId, std::uint64_t> hashes;
    const auto spying = [&](bus::Transit transit) {
      const auto* beacon = std::get_if<wire::Beacon>(&transit.sample);
      if (beacon != nullptr && beacon->closes_round() && beacon->round() == 2)
        hashes[beacon->agent()] = beacon->state_hash();
      return tamper ? tamper(std::move(transit)) : std::vector{transit};
    };
    (void)run_with(scenario, spying);
    return hashes;
  };
  std::uint64_t altered = 0;
  auto honest = hashes_of({});
  auto lied = hashes_of(altering(1, 2, 1, lengthen, altered));
  ASSERT_EQ(altered, 1U);
  EXPECT_EQ(lied[1], honest[1]);
  EXPECT_NE(lied[2], honest[2]);
  EXPECT_EQ(lied[3], honest[3]);
}

}  // namespace
}  // namespace skein
