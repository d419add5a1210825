// Each kind of bad sample is refused, with its reason and the field that is wrong.
#include "tests/idl/convert/refusals.hpp"

namespace skein {
namespace {

using namespace refusals;
using enum WireFaultReason;

TEST(Refusal, Mission) {
  using W = wire::Mission;
  expect_refused<W>(
      to_wire(examples::mission(), examples::kStamp),
      {{"mission.head.sender", WrongSender, [](W& m) { m.head().sender(1); }},
       {"mission.head.run", WrongRun, [](W& m) { m.head().run(78); }},
       {"mission.name", OutOfRange, [](W& m) { m.name("a\nb"); }},
       {"mission.kind", BadEnum, [](W& m) { m.kind(0); }},
       {"mission.length_unit_m", OutOfRange, [](W& m) { m.length_unit_m(0.0); }},
       {"mission.step_s", OutOfRange, [](W& m) { m.step_s(0.0); }},
       {"mission.step_s", NonFinite, [](W& m) { m.step_s(kInfinity); }},
       {"mission.formation", NonFinite, [](W& m) { m.formation().position_m().y(kNan); }},
       {"mission.formation", OutOfRange, [](W& m) { m.formation().climb_rad(1.6); }},
       {"mission.arrival_radius_m", OutOfRange, [](W& m) { m.arrival_radius_m(-1.0); }},
       {"mission.terrain", NonFinite, [](W& m) { m.terrain()[0].f(kNan); }},
       {"mission.terrain", OutOfRange, [](W& m) { m.terrain()[0].l(1e5); }},
       {"mission.terrain", OutOfRange, [](W& m) { m.terrain().resize(2); }},
       {"mission.vehicles.max_torsion_per_m", OutOfRange, [](W& m) { m.vehicles()[0].max_torsion_per_m(-1.0); }},
       {"mission.vehicles", BadMission, [](W& m) { m.vehicles().clear(); }},
       {"mission.vehicles", OutOfRange, [](W& m) { m.vehicles().resize(257); }},
       {"mission.zones", OutOfRange, [](W& m) { m.zones().resize(1025); }},
       {"mission.vehicles", BadOrder, [](W& m) { m.vehicles()[1].agent(1); }},
       {"mission.vehicles", BadOrder, [](W& m) { std::swap(m.vehicles()[0], m.vehicles()[1]); }},
       {"mission.vehicles.agent", UnknownAgent, [](W& m) { m.vehicles()[0].agent(0); }},
       {"mission.vehicles.agent", UnknownAgent, [](W& m) { m.vehicles()[1].agent(257); }},
       {"mission.vehicles.start", OutOfRange, [](W& m) { m.vehicles()[0].start().position_m().x(2e7); }},
       {"mission.vehicles.slot_offset_m", NonFinite, [](W& m) { m.vehicles()[0].slot_offset_m().z(-kInfinity); }},
       {"mission.vehicles.kind", BadEnum, [](W& m) { m.vehicles()[0].kind(9); }},
       {"mission.vehicles.speed_mps", OutOfRange, [](W& m) { m.vehicles()[0].speed_mps(-1.0); }},
       {"mission.vehicles.max_curvature_per_m", NonFinite, [](W& m) { m.vehicles()[0].max_curvature_per_m(kNan); }},
       {"mission.vehicles.radius_m", OutOfRange, [](W& m) { m.vehicles()[0].radius_m(-1e-9); }},
       {"mission.vehicles.safety_radius_m", OutOfRange, [](W& m) { m.vehicles()[1].safety_radius_m(1e8); }}});
}

TEST(Refusal, MissionZonesAndOptions) {
  using W = wire::Mission;
  expect_refused<W>(to_wire(examples::mission(), examples::kStamp),
                    {{"mission.zones", BadEnum, [](W& m) { m.zones()[0].shape(2); }},
                     {"mission.zones", NonFinite, [](W& m) { m.zones()[0].min_m().x(kNan); }},
                     {"mission.zones", OutOfRange, [](W& m) { m.zones()[0].radius_m(-9.0); }},
                     {"mission.zones", OutOfRange, [](W& m) { m.zones()[1].max_m().x(1e9); }},
                     {"mission.zones", BadMission, [](W& m) { m.zones()[0].max_m().z(-11.0); }},
                     {"mission.zones", BadMission, [](W& m) { m.zones()[1].max_m().x(0.0); }},
                     {"mission.zones", BadMission, [](W& m) { m.zones()[1].max_m().y(0.0); }},
                     {"mission.planner", BadOptions, [](W& m) { m.planner().name("nonesuch"); }},
                     {"mission.planner", BadOptions, [](W& m) { m.planner().particles(-5); }},
                     {"mission.planner", BadOptions, [](W& m) { m.planner().search_min_chords(50.0); }},
                     {"mission.planner", NonFinite, [](W& m) { m.planner().inertia_end(kNan); }},
                     {"mission.controller", BadOptions, [](W& m) { m.controller_name("nonesuch"); }},
                     {"mission.controller", OutOfRange, [](W& m) { m.controller_values().pop_back(); }},
                     {"mission.controller", BadOptions, [](W& m) { m.controller_values()[1] = -1.0; }},
                     {"mission.announced", OutOfRange, [](W& m) { m.announced().resize(65); }},
                     {"mission.announced", NonFinite, [](W& m) { m.announced()[0].place().min_m().x(kNan); }},
                     {"mission.announced", OutOfRange, [](W& m) { m.announced()[1].early_s(-1.0); }},
                     {"mission.announced.to_s", BadMission, [](W& m) { m.announced()[0].to_s(59.0); }}});
}

TEST(Refusal, Tick) {
  using W = wire::Tick;
  expect_refused<W>(to_wire(examples::tick(), examples::kStamp),
                    {{"tick.head.sender", WrongSender, [](W& t) { t.head().sender(3); }},
                     {"tick.head.run", WrongRun, [](W& t) { t.head().run(0); }},
                     {"tick.phase", BadEnum, [](W& t) { t.phase(4); }},
                     {"tick.time_s", NonFinite, [](W& t) { t.time_s(kNan); }},
                     {"tick.time_s", OutOfRange, [](W& t) { t.time_s(-0.5); }},
                     {"tick.roster", OutOfRange, [](W& t) { t.roster().resize(257); }},
                     {"tick.refused", OutOfRange, [](W& t) { t.refused().resize(257); }},
                     {"tick.roster", BadOrder, [](W& t) { t.roster()[0].agent(3); }},
                     {"tick.roster", BadOrder, [](W& t) { std::swap(t.roster()[0], t.roster()[1]); }},
                     {"tick.roster.agent", UnknownAgent, [](W& t) { t.roster()[0].agent(2); }},
                     {"tick.roster.incarnation", OutOfRange, [](W& t) { t.roster()[0].incarnation(0); }},
                     {"tick.refused.reason", BadEnum, [](W& t) { t.refused()[0].reason(0); }},
                     {"tick.given", OutOfRange, [](W& t) { t.given().resize(257); }},
                     {"tick.given.agent", UnknownAgent, [](W& t) { t.given()[0].agent(2); }}});
}

TEST(Refusal, Sense) {
  using W = wire::Sense;
  expect_refused<W>(to_wire(examples::sense(), examples::kStamp),
                    {{"sense.head.sender", WrongSender, [](W& s) { s.head().sender(3); }},
                     {"sense.head.run", WrongRun, [](W& s) { s.head().run(1); }},
                     {"sense.agent", UnknownAgent, [](W& s) { s.agent(2); }},
                     {"sense.agent", UnknownAgent, [](W& s) { s.agent(0); }},
                     {"sense.head.incarnation", WrongIncarnation, [](W& s) { s.head().incarnation(1); }},
                     {"sense.own", NonFinite, [](W& s) { s.own().heading_rad(kNan); }},
                     {"sense.own", OutOfRange, [](W& s) { s.own().heading_rad(1e4); }},
                     {"sense.velocity_mps", OutOfRange, [](W& s) { s.velocity_mps().x(1e5); }},
                     {"sense.velocity_mps", NonFinite, [](W& s) { s.velocity_mps().y(kInfinity); }}});
}

TEST(Refusal, WhatASensorSaw) {
  using W = wire::Sense;
  expect_refused<W>(to_wire(examples::sense(), examples::kStamp),
                    {{"sense.heard", OutOfRange, [](W& s) { s.heard().resize(257); }},
                     {"sense.heard.agent", UnknownAgent, [](W& s) { s.heard()[0].agent(2); }},
                     {"sense.heard.agent", UnknownAgent, [](W& s) { s.heard()[0].agent(3); }},
                     {"sense.heard", BadOrder, [](W& s) { s.heard().push_back(s.heard()[0]); }},
                     {"sense.heard.position_m", NonFinite, [](W& s) { s.heard()[0].position_m().x(kNan); }},
                     {"sense.heard.velocity_mps", OutOfRange, [](W& s) { s.heard()[0].velocity_mps().z(1e5); }},
                     {"sense.sight.low", OutOfRange, [](W& s) { s.sight().j(1 << 21); }},
                     {"sense.sight.size", OutOfRange, [](W& s) { s.sight().ni(-1); }},
                     {"sense.sight.size", OutOfRange, [](W& s) { s.sight().nk(1 << 20); }},
                     {"sense.sight.packed", OutOfRange, [](W& s) { s.sight().nk(2); }},
                     {"sense.sight.packed", OutOfRange, [](W& s) { s.sight().packed().clear(); }},
                     {"sense.sight.packed", OutOfRange, [](W& s) { s.sight().packed().resize(49153); }},
                     {"sense.sight.packed", BadEnum, [](W& s) { s.sight().packed()[0] = 2; }}});
}

TEST(Refusal, WhatIsSensedBesideCells) {
  using W = wire::Sense;
  expect_refused<W>(to_wire(examples::sense(), examples::kStamp),
                    {{"sense.tracks", OutOfRange, [](W& s) { s.tracks().resize(257); }},
                     {"sense.tracks", BadOrder, [](W& s) { s.tracks()[0].id(0); }},
                     {"sense.tracks", BadOrder, [](W& s) { s.tracks()[1].id(2); }},
                     {"sense.tracks", NonFinite, [](W& s) { s.tracks()[1].position_m().z(kNan); }},
                     {"sense.tracks", OutOfRange, [](W& s) { s.tracks()[0].velocity_mps().x(2e4); }},
                     {"sense.tracks", OutOfRange, [](W& s) { s.tracks()[0].radius_m(-0.5); }},
                     {"sense.zones", OutOfRange, [](W& s) { s.zones().resize(65); }},
                     {"sense.zones", BadEnum, [](W& s) { s.zones()[1] = 4; }}});
}

TEST(Refusal, ObstacleMap) {
  using W = wire::ObstacleMap;
  expect_refused<W>(to_wire(examples::obstacle_map(), examples::kStamp),
                    {{"obstacle_map.agent", UnknownAgent, [](W& m) { m.agent(2); }},
                     {"obstacle_map.head.sender", WrongSender, [](W& m) { m.head().sender(1); }},
                     {"obstacle_map.head.run", WrongRun, [](W& m) { m.head().run(0); }},
                     {"obstacle_map.head.incarnation", WrongIncarnation, [](W& m) { m.head().incarnation(1); }},
                     {"obstacle_map.intent.to_m", NonFinite, [](W& m) { m.intent().to_m().x(kNan); }},
                     {"obstacle_map.intent.to_m", OutOfRange, [](W& m) { m.intent().to_m().y(1e8); }},
                     {"obstacle_map.intent.to_go_m", NonFinite, [](W& m) { m.intent().to_go_m(kInfinity); }},
                     {"obstacle_map.intent.status", BadEnum, [](W& m) { m.intent().status(0); }},
                     {"obstacle_map.intent.asks", UnknownAgent, [](W& m) { m.intent().asks(2); }},
                     {"obstacle_map.intent.on_behalf_of", UnknownAgent, [](W& m) { m.intent().on_behalf_of(9); }},
                     {"obstacle_map.intent.next_cells", OutOfRange, [](W& m) { m.intent().next_cells()[3] = 240; }},
                     {"obstacle_map.seen", OutOfRange, [](W& m) { m.seen().resize(257); }},
                     {"obstacle_map.seen.agent", UnknownAgent, [](W& m) { m.seen()[0].agent(0); }},
                     {"obstacle_map.seen", BadOrder, [](W& m) { m.seen()[1].agent(1); }},
                     {"obstacle_map.tiles", OutOfRange, [](W& m) { m.tiles().resize(1025); }},
                     {"obstacle_map.tiles.origin", UnknownAgent, [](W& m) { m.tiles()[0].origin(2); }},
                     {"obstacle_map.tiles.tile", OutOfRange, [](W& m) { m.tiles()[0].tile(6); }},
                     {"obstacle_map.tiles.version", OutOfRange, [](W& m) { m.tiles()[1].version(0); }}});
}

TEST(Refusal, MissionOfATransit) {
  using W = wire::Mission;
  expect_refused<W>(
      to_wire(examples::crossing(), examples::kStamp),
      {{"mission.kind", BadEnum, [](W& m) { m.kind(3); }},
       {"mission.transit", BadMission, [](W& m) { m.kind(1); }},
       {"mission.transit", BadMission, [](W& m) { m.transit().clear(); }},
       {"mission.transit.area", NonFinite, [](W& m) { m.transit()[0].area_min_m().x(kNan); }},
       {"mission.transit.area", BadMission, [](W& m) { m.transit()[0].area_max_m().z(-0.5); }},
       {"mission.transit.goal_radius_m", OutOfRange, [](W& m) { m.transit()[0].goal_radius_m(-1.0); }},
       {"mission.transit.goals_m", BadMission, [](W& m) { m.transit()[0].goals_m().resize(1); }},
       {"mission.transit.goals_m", NonFinite, [](W& m) { m.transit()[0].goals_m()[1].z(kNan); }},
       {"mission.transit.planner", BadOptions, [](W& m) { m.transit()[0].planner_name("nonesuch"); }},
       {"mission.transit.planner", OutOfRange, [](W& m) { m.transit()[0].planner_values().pop_back(); }},
       {"mission.transit.planner", BadOptions, [](W& m) { m.transit()[0].planner_values()[0] = -1.0; }},
       {"mission.transit.radio", NonFinite, [](W& m) { m.transit()[0].radio_values()[0] = kNan; }},
       {"mission.transit.radio", BadOptions, [](W& m) { m.transit()[0].radio_values()[3] = 1.5; }},
       {"mission.transit.sensor", OutOfRange, [](W& m) { m.transit()[0].sensor_values().push_back(1.0); }},
       {"mission.transit.sensor", BadOptions, [](W& m) { m.transit()[0].sensor_values()[4] = 1.0; }}});
}

TEST(Refusal, Representative) {
  using W = wire::Representative;
  expect_refused<W>(to_wire(examples::representative(), examples::kStamp),
                    {{"representative.agent", UnknownAgent, [](W& r) { r.agent(2); }},
                     {"representative.head.sender", WrongSender, [](W& r) { r.head().sender(1); }},
                     {"representative.head.run", WrongRun, [](W& r) { r.head().run(0); }},
                     {"representative.head.incarnation", WrongIncarnation, [](W& r) { r.head().incarnation(0); }},
                     {"representative.head.incarnation", WrongIncarnation, [](W& r) { r.head().incarnation(3); }},
                     {"representative.stage", BadEnum, [](W& r) { r.stage(0); }},
                     {"representative.violated", BadEnum, [](W& r) { r.violated(8); }},
                     {"representative.particle", OutOfRange, [](W& r) { r.particle().resize(17); }},
                     {"representative.particle", OutOfRange, [](W& r) { r.particle().resize(1); }},
                     {"representative.particle", NonFinite, [](W& r) { r.particle()[1] = kNan; }},
                     {"representative.particle", OutOfRange, [](W& r) { r.particle()[0] = -1e11; }},
                     {"representative.cost", NonFinite, [](W& r) { r.cost(kInfinity); }},
                     {"representative.own_length_m", OutOfRange, [](W& r) { r.own_length_m(-1.0); }},
                     {"representative.path_length_m", NonFinite, [](W& r) { r.path_length_m(kNan); }}});
}

TEST(Refusal, Revision) {
  using W = wire::Representative;
  expect_refused<W>(
      to_wire(examples::revision(), examples::kStamp),
      {{"representative.revision", OutOfRange, [](W& r) { r.reopening().resize(2); }},
       {"representative.revision.reason", BadEnum, [](W& r) { r.reopening()[0].reason(9); }},
       {"representative.revision.pose", NonFinite, [](W& r) { r.reopening()[0].own().heading_rad(kNan); }},
       {"representative.revision.speed_mps", OutOfRange, [](W& r) { r.reopening()[0].speed_mps(-1.0); }},
       {"representative.revision.obstacles", OutOfRange, [](W& r) { r.reopening()[0].obstacles().resize(65); }},
       {"representative.revision.obstacles", NonFinite,
        [](W& r) { r.reopening()[0].obstacles()[0].position_m().x(kNan); }}});
}

TEST(Refusal, Beacon) {
  using W = wire::Beacon;
  expect_refused<W>(to_wire(examples::beacon(), examples::kStamp),
                    {{"beacon.agent", UnknownAgent, [](W& b) { b.agent(300); }},
                     {"beacon.head.sender", WrongSender, [](W& b) { b.head().sender(0); }},
                     {"beacon.head.run", WrongRun, [](W& b) { b.head().run(76); }},
                     {"beacon.head.run", WrongRun, [](W& b) { b.head().run(76), b.head().incarnation(0); }},
                     {"beacon.head.incarnation", WrongIncarnation, [](W& b) { b.head().incarnation(1); }},
                     {"beacon.head.incarnation", WrongIncarnation, [](W& b) { b.nonce(0x3334); }},
                     {"beacon.matched", OutOfRange, [](W& b) { b.matched().resize(258); }},
                     {"beacon.needs", OutOfRange, [](W& b) { b.needs().resize(513); }},
                     {"beacon.matched", BadOrder, [](W& b) { b.matched()[1] = b.matched()[0]; }},
                     {"beacon.needs.agent", UnknownAgent, [](W& b) { b.needs()[0].agent(0); }},
                     {"beacon.needs.topic", BadEnum, [](W& b) { b.needs()[1].topic(2); }},
                     {"beacon.mode", BadEnum, [](W& b) { b.mode(15); }},
                     {"beacon.failing", BadEnum, [](W& b) { b.failing(255); }},
                     {"beacon.failing_peer", UnknownAgent, [](W& b) { b.failing_peer(2); }},
                     {"beacon.own", NonFinite, [](W& b) { b.own().position_m().z(kNan); }},
                     {"beacon.commanded_velocity_mps", OutOfRange, [](W& b) { b.commanded_velocity_mps().z(-2e4); }},
                     {"beacon.planned_length_m", OutOfRange, [](W& b) { b.planned_length_m(-1.0); }},
                     {"beacon.cost", NonFinite, [](W& b) { b.cost(kNan); }},
                     {"beacon.acknowledged", OutOfRange, [](W& b) { b.acknowledged().resize(17, 1); }},
                     {"beacon.safety_mode", BadEnum, [](W& b) { b.safety_mode(3); }},
                     {"beacon.safety_reason", BadEnum, [](W& b) { b.safety_reason(9); }},
                     {"beacon.deviation_m", OutOfRange, [](W& b) { b.deviation_m(-1.0); }},
                     {"beacon.predicted_separation_m", NonFinite, [](W& b) { b.predicted_separation_m(kNan); }}});
}

TEST(Refusal, AnIntroductionPassesWithoutRunAndRoster) {
  Beacon introduction = examples::beacon();
  introduction.incarnation = 0;
  introduction.run = 0;
  introduction.nonce = 0x9999;
  EXPECT_EQ(from_wire(to_wire(introduction, examples::kStamp), strict()).value(), introduction);
}

TEST(Refusal, AnEmptyRosterLetsNobodyPass) {
  WireContext context = strict();
  context.roster = std::span<const RosterEntry>();
  const auto checked = from_wire(to_wire(examples::representative(), examples::kStamp), context);
  ASSERT_FALSE(checked.ok());
  EXPECT_EQ(checked.fault().reason, WrongIncarnation);
}

TEST(Refusal, WithoutContextAnyLegalIdRunAndIncarnationPasses) {
  Representative other = examples::representative();
  other.run = 5;
  other.agent = kMaxAgents;
  other.incarnation = 9;
  EXPECT_TRUE(from_wire(to_wire(other, examples::kStamp), {}).ok());
  other.agent = kMaxAgents + 1;
  EXPECT_EQ(from_wire(to_wire(other, examples::kStamp), {}).fault().reason, UnknownAgent);
}

}  // namespace
}  // namespace skein
