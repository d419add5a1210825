// Garbage on the bus beside the honest samples is refused, counted, and changes nothing.
#include <functional>
#include <limits>

#include "tests/groundstation/inprocess/tampering.hpp"

namespace skein {
namespace {

using test::paper_scenario;
using test::run_with;
using Spoil = std::function<void(wire::Representative&)>;

/// One way to spoil a representative, and a name for it.
struct Garbage {
  const char* name;
  Spoil spoil;
};

const std::vector<Garbage> kGarbage{
    {"NaN", [](auto& sample) { sample.cost(std::numeric_limits<double>::quiet_NaN()); }},
    {"infinite", [](auto& sample) { sample.path_length_m(std::numeric_limits<double>::infinity()); }},
    {"other run", [](auto& sample) { sample.head().run(99); }},
    {"other incarnation", [](auto& sample) { sample.head().incarnation(5); }},
    {"unknown id",
     [](auto& sample) {
       sample.agent(200);
       sample.head().sender(200);
     }},
    {"other sender", [](auto& sample) { sample.head().sender(sample.agent() + 1); }},
    {"bad octet", [](auto& sample) { sample.stage(77); }},
};

/// Puts a spoilt copy in front of every honest representative. @param to_world counts those that the world got
bus::Tamper hostile(const Spoil& spoil, std::uint64_t& to_world) {
  return [&spoil, &to_world](bus::Transit transit) {
    std::vector<bus::Transit> arrived;
    if (const auto* honest = std::get_if<wire::Representative>(&transit.sample)) {
      wire::Representative spoilt = *honest;
      spoil(spoilt);
      spoilt.particle({1.0, 1.0});
      arrived.push_back({transit.from, transit.to, spoilt, 0});
      to_world += transit.to == kWorldId;
    }
    arrived.push_back(std::move(transit));
    return arrived;
  };
}

TEST(HostileBus, GarbageIsRefusedCountedAndChangesNothing) {
  for (const Garbage& garbage : kGarbage) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Scenario scenario = paper_scenario(seed);
      const InProcessResult calm = run_with(scenario, {});
      std::uint64_t to_world = 0;
      const InProcessResult rough = run_with(scenario, hostile(garbage.spoil, to_world));
      ASSERT_EQ(rough.report.at("state_hash"), calm.report.at("state_hash")) << garbage.name;
      ASSERT_EQ(rough.exit_code, calm.exit_code) << garbage.name;
      ASSERT_GT(to_world, 100U);
      ASSERT_EQ(rough.report.at("refused_samples"), to_world) << garbage.name;
      ASSERT_EQ(rough.report.at("topics").at("representative"), calm.report.at("topics").at("representative"));
    }
  }
}

/// Spoils a copy of every beacon and tick as well.
std::vector<bus::Transit> crowd(bus::Transit transit) {
  std::vector<bus::Transit> arrived;
  if (const auto* beacon = std::get_if<wire::Beacon>(&transit.sample)) {
    wire::Beacon spoilt = *beacon;
    spoilt.nonce(beacon->nonce() + 1000);
    spoilt.mode(static_cast<std::uint8_t>(AgentMode::Leaving));
    arrived.push_back({transit.from, transit.to, spoilt, 0});
    spoilt = *beacon;
    spoilt.head().run(99);
    spoilt.head().incarnation(1);
    arrived.push_back({transit.from, transit.to, spoilt, 0});
    spoilt = *beacon;
    spoilt.planned_length_m(std::numeric_limits<double>::quiet_NaN());
    arrived.push_back({transit.from, transit.to, spoilt, 0});
  } else if (const auto* tick = std::get_if<wire::Tick>(&transit.sample)) {
    wire::Tick spoilt = *tick;
    spoilt.head().run(99);
    spoilt.round(tick->round() + 50);
    arrived.push_back({transit.from, transit.to, spoilt, 0});
    spoilt = *tick;
    spoilt.phase(9);
    arrived.push_back({transit.from, transit.to, spoilt, 0});
  } else if (const auto* sense = std::get_if<wire::Sense>(&transit.sample)) {
    wire::Sense spoilt = *sense;
    spoilt.own().heading_rad(1.0);
    spoilt.head().incarnation(7);
    arrived.push_back({transit.from, transit.to, spoilt, 0});
  }
  arrived.push_back(std::move(transit));
  return arrived;
}

TEST(HostileBus, SpoiltBeaconsTicksAndSensesChangeNothing) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Scenario scenario = paper_scenario(seed);
    const InProcessResult calm = run_with(scenario, {});
    const InProcessResult rough = run_with(scenario, crowd);
    ASSERT_EQ(rough.report.at("state_hash"), calm.report.at("state_hash")) << seed;
    ASSERT_EQ(rough.exit_code, 0) << rough.report.dump(2);
    ASSERT_TRUE(rough.report.at("roster_changes").empty()) << seed;
    ASSERT_GT(rough.report.at("refused_samples"), 3000) << seed;
  }
}

}  // namespace
}  // namespace skein
