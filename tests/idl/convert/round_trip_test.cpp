// Every field survives plain -> wire -> CDR bytes -> wire -> plain, bit for bit.
#include <gtest/gtest.h>

#include <bit>

#include "idl/convert/cdr.hpp"
#include "tests/idl/convert/examples.hpp"

namespace skein {
namespace {

template <typename Plain>
Checked<Plain> there_and_back(const Plain& value, const WireContext& context = {}) {
  const auto sample = to_wire(value, examples::kStamp);
  const auto carried = from_cdr<std::decay_t<decltype(sample)>>(to_cdr(sample));
  EXPECT_TRUE(carried.has_value());
  return from_wire(carried.value_or(sample), context);
}

TEST(RoundTrip, Mission) {
  EXPECT_EQ(there_and_back(examples::mission()).value(), examples::mission());
}
TEST(RoundTrip, MissionOfATransit) {
  EXPECT_EQ(there_and_back(examples::crossing()).value(), examples::crossing());
}
TEST(RoundTrip, ObstacleMap) {
  EXPECT_EQ(there_and_back(examples::obstacle_map()).value(), examples::obstacle_map());
}
TEST(RoundTrip, Tick) {
  EXPECT_EQ(there_and_back(examples::tick()).value(), examples::tick());
  EXPECT_EQ(there_and_back(examples::last_tick()).value(), examples::last_tick());
}
TEST(RoundTrip, Sense) {
  EXPECT_EQ(there_and_back(examples::sense()).value(), examples::sense());
}
TEST(RoundTrip, CommandAndInject) {
  EXPECT_EQ(there_and_back(examples::command()).value(), examples::command());
  EXPECT_EQ(there_and_back(examples::inject()).value(), examples::inject());
}
TEST(RoundTrip, Beacon) {
  EXPECT_EQ(there_and_back(examples::beacon()).value(), examples::beacon());
}
TEST(RoundTrip, Representative) {
  EXPECT_EQ(there_and_back(examples::representative()).value(), examples::representative());
}

TEST(RoundTrip, Revision) {
  EXPECT_EQ(there_and_back(examples::revision()).value(), examples::revision());
}

TEST(RoundTrip, KeepsTheSignOfZero) {
  const Representative back = there_and_back(examples::representative()).value();
  EXPECT_EQ(std::bit_cast<std::uint64_t>(back.particle[1]), std::bit_cast<std::uint64_t>(-0.0));
}

TEST(RoundTrip, EveryPlannerOptionTravels) {
  const Mission before = examples::mission();
  for (const RendezvousField& field : kRendezvousFields) {
    Mission changed = before;
    std::visit(
        [&](auto member) {
          auto& value = changed.planner.*member;
          value = static_cast<std::decay_t<decltype(value)>>(value == field.max ? field.min : field.max);
        },
        field.member);
    if (validate(changed.planner)) continue;
    EXPECT_NE(changed, before) << field.key;
    EXPECT_EQ(there_and_back(changed).value(), changed) << field.key;
  }
}

/// Sets one value after another to an end of its range.
template <typename Options, std::size_t N>
void expect_all_travel(Options TransitMission::*part, const std::array<OptionField<Options>, N>& fields) {
  for (const OptionField<Options>& field : fields) {
    Mission changed = examples::crossing();
    double& value = (*changed.transit).*part.*field.member;
    value = value == field.max ? field.min : field.max;
    EXPECT_NE(changed, examples::crossing()) << field.key;
    EXPECT_EQ(there_and_back(changed).value(), changed) << field.key;
  }
}

TEST(RoundTrip, EveryOptionOfATransitTravels) {
  expect_all_travel(&TransitMission::planner, kTransitFields);
  expect_all_travel(&TransitMission::radio, kRadioFields);
  expect_all_travel(&TransitMission::sensor, kSensorFields);
}

TEST(RoundTrip, EveryOptionOfTheControllerTravels) {
  for (const OptionField<ControllerOptions>& field : kControllerFields) {
    Mission changed = examples::mission();
    double& value = changed.controller.*field.member;
    value = value == field.max ? field.min : field.max;
    EXPECT_NE(changed, examples::mission()) << field.key;
    EXPECT_EQ(there_and_back(changed).value(), changed) << field.key;
  }
}

TEST(RoundTrip, TheSizeOfAnObstacleMapIsKnownWithoutSerialisingIt) {
  ObstacleMapSample m = examples::obstacle_map();
  for (const std::size_t seen : {0, 1, 2, 9, 255}) {
    for (const std::size_t tiles : {0, 1, 2, 7, 1024}) {
      m.seen.clear();
      for (AgentId id = 1; id <= seen; ++id) m.seen.push_back({id, 1, 2});
      m.tiles.assign(tiles, examples::obstacle_map().tiles[0]);
      const wire::ObstacleMap sample = to_wire(m, examples::kStamp);
      EXPECT_EQ(payload_bytes(tiles, seen), wire::ObstacleMap::getCdrSerializedSize(sample)) << seen << " " << tiles;
      EXPECT_EQ(payload_bytes(tiles, seen) + 4, to_cdr(sample).size()) << seen << " " << tiles;
    }
  }
}

TEST(RoundTrip, TheLargestOfEverything) {
  Mission m = examples::mission();
  m.name = std::string(wire::kMaxName, 'n');
  m.vehicles.clear();
  for (AgentId id = 1; id <= kMaxAgents; ++id) {
    m.vehicles.push_back(examples::mission().vehicles[0]);
    m.vehicles.back().id = id;
  }
  m.zones.assign(wire::kMaxZones, examples::mission().zones[0]);
  m.announced.assign(wire::kMaxAnnounced, examples::mission().announced[0]);
  EXPECT_EQ(there_and_back(m).value(), m);

  Tick t = examples::tick();
  t.roster.clear();
  for (AgentId id = 1; id <= kMaxAgents; ++id) t.roster.push_back({id, 1, id, true, true});
  t.refused.assign(wire::kMaxRefused, {9, RefusalReason::RunStarted});
  EXPECT_EQ(there_and_back(t).value(), t);

  Beacon b = examples::beacon();
  b.matched.clear();
  for (std::uint64_t nonce = 0; nonce < wire::kMaxMatched; ++nonce) b.matched.push_back(nonce);
  b.needs.assign(wire::kMaxNeeds, {1, 1});
  EXPECT_EQ(there_and_back(b).value(), b);

  ObstacleMapSample o = examples::obstacle_map();
  o.seen.clear();
  for (AgentId id = 1; id <= kMaxAgents; ++id) o.seen.push_back({id, id, id});
  o.tiles.assign(kMaxMapTiles, examples::obstacle_map().tiles[0]);
  EXPECT_EQ(there_and_back(o).value(), o);
  EXPECT_LT(to_cdr(to_wire(o, examples::kStamp)).size(), 60000u);  // one datagram

  Sense s = examples::sense();
  s.heard.clear();
  for (AgentId id = 1; id <= kMaxAgents; ++id) {
    if (id != s.agent) s.heard.push_back({id, Vec3(1.0, 2.0, 3.0), Vec3::Zero(), false});
  }
  s.sight = CellWindow::of({0, 0, 0}, 64, 64, 48);
  EXPECT_EQ(s.sight.packed.size(), kMaxSightBytes);
  const Track track = s.tracks[0];
  s.tracks.clear();
  for (std::uint32_t id = 1; id <= wire::kMaxTracks; ++id) {
    s.tracks.push_back(track);
    s.tracks.back().id = id;
  }
  s.zones.assign(wire::kMaxAnnounced, ZoneState::Occupied);
  EXPECT_EQ(there_and_back(s).value(), s);

  Representative r = examples::representative();
  r.particle.assign(wire::kMaxParticle, 1.0);
  EXPECT_EQ(there_and_back(r).value(), r);
}

TEST(RoundTrip, TheHeaderSaysRunStampSenderAndIncarnation) {
  const wire::Representative sample = to_wire(examples::representative(), examples::kStamp);
  EXPECT_EQ(sample.head().run(), 77u);
  EXPECT_EQ(sample.head().stamp_ns(), examples::kStamp.stamp_ns);
  EXPECT_EQ(sample.head().sender(), 3u);
  EXPECT_EQ(sample.head().incarnation(), 2u);
  EXPECT_EQ(to_wire(examples::mission(), examples::kStamp).head().run(), 77u);
  EXPECT_EQ(to_wire(examples::sense(), examples::kStamp).head().sender(), kWorldId);
}

TEST(RoundTrip, WhatIsOverTheBoundsOfTheWireThrows) {
  Mission name = examples::mission();
  name.name = std::string(wire::kMaxName + 1, 'n');
  EXPECT_THROW((void)to_wire(name, examples::kStamp), std::invalid_argument);
  Mission planner = examples::mission();
  planner.planner.name = std::string(33, 'n');
  EXPECT_THROW((void)to_wire(planner, examples::kStamp), std::invalid_argument);
  Mission zones = examples::mission();
  zones.zones.resize(wire::kMaxZones + 1);
  EXPECT_THROW((void)to_wire(zones, examples::kStamp), std::invalid_argument);
  Representative particle = examples::representative();
  particle.particle.resize(wire::kMaxParticle + 1);
  EXPECT_THROW((void)to_wire(particle, examples::kStamp), std::invalid_argument);
  Tick roster = examples::tick();
  roster.roster.resize(kMaxAgents + 1);
  EXPECT_THROW((void)to_wire(roster, examples::kStamp), std::invalid_argument);
  ObstacleMapSample tiles = examples::obstacle_map();
  tiles.tiles.resize(kMaxMapTiles + 1);
  EXPECT_THROW((void)to_wire(tiles, examples::kStamp), std::invalid_argument);
  Sense sight = examples::sense();
  sight.sight = CellWindow::of({0, 0, 0}, 64, 64, 49);
  EXPECT_THROW((void)to_wire(sight, examples::kStamp), std::invalid_argument);
  Mission announced = examples::mission();
  announced.announced.resize(wire::kMaxAnnounced + 1);
  EXPECT_THROW((void)to_wire(announced, examples::kStamp), std::invalid_argument);
  Sense tracks = examples::sense();
  tracks.tracks.resize(wire::kMaxTracks + 1);
  EXPECT_THROW((void)to_wire(tracks, examples::kStamp), std::invalid_argument);
  Sense states = examples::sense();
  states.zones.resize(wire::kMaxAnnounced + 1);
  EXPECT_THROW((void)to_wire(states, examples::kStamp), std::invalid_argument);
  Representative known = examples::revision();
  known.revision->obstacles.resize(wire::kMaxKnown + 1);
  EXPECT_THROW((void)to_wire(known, examples::kStamp), std::invalid_argument);
  Beacon matched = examples::beacon();
  matched.matched.resize(wire::kMaxMatched + 1);
  EXPECT_THROW((void)to_wire(matched, examples::kStamp), std::invalid_argument);
}

}  // namespace
}  // namespace skein
