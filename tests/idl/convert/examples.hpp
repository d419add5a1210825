// One valid sample of each kind, with every field set to a value of its own.
#pragma once

#include "idl/convert/convert.hpp"

namespace skein::examples {

inline constexpr Stamp kStamp{.stamp_ns = 1234567890123, .run = 77};

inline Mission mission() {
  Mission m;
  m.name = "two geese";
  m.seed = 42;
  m.length_unit_m = 1000.0;
  m.step_s = 0.5;
  m.formation = {Vec3(30000.0, 29000.0, 10.0), 0.25, 0.125};
  m.arrival_radius_m = 30.0;
  m.vehicles = {{1,
                 {Vec3(100.0, 200.0, 300.0), 0.5, -0.5},
                 Vec3(0.0, 1.0, 2.0),
                 VehicleType::ConstantSpeed,
                 50.0,
                 0.002,
                 5.0,
                 20.0,
                 0.003},
                {3,
                 {Vec3(-100.0, 5.0, 6.0), -2.0, 0.0},
                 Vec3(-1.0, -2.0, -3.0),
                 VehicleType::Multirotor,
                 49.0,
                 0.001,
                 4.0,
                 21.0,
                 10.0,
                 6.5}};
  m.zones = {{Cylinder{Vec2(7.0, 8.0), 9.0, -10.0, 11.0}, false},
             {Box{Vec3(1.0, 2.0, 3.0), Vec3(4.0, 5.0, 6.0)}, true}};
  m.terrain = Terrain{0.5, 1.0, 0.25, 2.0, 0.125, 3.0, 0.75, 0.1, 0.2, 1000.0};
  m.planner.particles = 21;
  m.planner.search_max_chords = 5.5;
  m.planner.equalise_rounds = 41;
  m.planner.cooperate = 0;
  m.planner.length_tolerance_m = 351.0;
  m.planner.mutation_probability = 0.0625;
  m.planner.max_segments = 3;
  m.planner.replan = 1;
  m.planner.rounds_per_step = 12;
  m.controller.name = "orca";
  m.controller.sensor_range_m = 24.0;
  m.controller.obstacle_speed_mps = 5.0;
  m.announced = {{Box{Vec3(7.0, 8.0, 9.0), Vec3(10.0, 11.0, 12.0)}, 60.0, 90.0, 15.0, 12.0},
                 {Cylinder{Vec2(1.0, 2.0), 3.0, 4.0, 5.0}, 100.0, 101.0, 0.0, 0.5}};
  return m;
}

/// The same vehicles, of kind transit.
inline Mission crossing() {
  Mission m = mission();
  m.kind = MissionKind::Transit;
  m.transit = TransitMission{};
  m.transit->area = {Vec3(-1.0, -2.0, 0.0), Vec3(250.0, 240.0, 20.0)};
  m.transit->goals_m = {Vec3(200.0, 100.0, 10.0), Vec3(201.0, 102.0, 12.0)};
  m.transit->goal_radius_m = 2.5;
  m.transit->planner.name = "peach3d-paper";
  m.transit->planner.cell_m = 2.0;
  m.transit->planner.share_maps = 0.0;
  m.transit->radio.range_m = 90.0;
  m.transit->radio.latency_rounds = 2.0;
  m.transit->sensor.false_alarm = 0.125;
  return m;
}

inline Tick tick() {
  Tick t;
  t.run = 77;
  t.step = 5;
  t.round = 6;
  t.phase = Phase::Flying;
  t.time_s = 2.5;
  t.roster = {{1, 1, 0x1111, true, false, true}, {3, 2, 0x3333, false, true, false}};
  t.refused = {{0x4444, RefusalReason::UnknownId}};
  t.assigned = {{0x5555, 3}};
  t.world_hash = 0xfedcba9876543210;
  t.orders = {{0x99, 3, OrderKind::Goto, Vec3(1.0, -2.0, 3.0), 4.5}};
  t.answers = {{0x99, OrderResult::Accepted, 6, {1, 3}, ""},
               {0x98, OrderResult::UnknownAgent, 0, {}, "the mission has no vehicle 9"}};
  return t;
}

inline Tick last_tick() {
  Tick t = tick();
  t.phase = Phase::Finished;
  t.outcome = Outcome{4, "agent 3 was lost at step 5, round 6: process_ended; the others arrived"};
  return t;
}

inline Sense sense() {
  Sense s{77, 3, 2, 6, {Vec3(1.5, -2.5, 3.5), 0.75, -0.25}, Vec3(4.0, -5.0, 6.0), {}, {}, {}, {}};
  s.heard = {{1, Vec3(7.0, -8.0, 9.0), Vec3(-1.5, 0.5, 0.25), true}};
  s.sight = CellWindow::of({-1, 2, 3}, 3, 2, 1);
  s.sight.set(0, CellState::Free);
  s.sight.set(4, CellState::Occupied);
  s.tracks = {{2, Vec3(1.0, 2.0, 3.0), Vec3(-4.0, 5.0, -6.0), 1.5, true, false},
              {9, Vec3(7.0, 8.0, 9.0), Vec3::Zero(), 2.5, false, true}};
  s.zones = {ZoneState::Clear, ZoneState::Unconfirmed};
  s.obeyed = false;
  return s;
}

inline Representative representative() {
  return {77, 3, 2, 6, PlanStage::Aligning, Constraint::NoFly, {1234.5, -0.0}, 17.25, 35000.0, 35100.0, std::nullopt};
}

/// The same agent calls for a new plan.
inline Representative revision() {
  Representative r = representative();
  r.revision = Revision{5,
                        90,
                        SafetyReason::Blocked,
                        {Vec3(1.0, -2.0, 3.0), 0.5, -0.25},
                        12.5,
                        {{4, Vec3(9.0, 8.0, 7.0), Vec3::Zero(), 6.5, true, true}}};
  return r;
}

inline ObstacleMapSample obstacle_map() {
  ObstacleMapSample m;
  m.run = 77;
  m.agent = 3;
  m.incarnation = 2;
  m.round = 6;
  m.intent = {12, Vec3::Zero(), Vec3(4.0, 5.0, 6.0), 7, 88.5, NavStatus::Unreachable, 1, 3, {9, 10, 11, 11}};
  m.seen = {{1, 13, 0x1122334455667788}, {3, 14, 0x99aabbccddeeff00}};
  m.tiles = {{3, 5, 1, 14, {0x0123456789abcdef, 0xfedcba9876543210}}, {1, 0, 0, 13, {1, 2}}};
  return m;
}

inline Beacon beacon() {
  Beacon b;
  b.run = 77;
  b.agent = 3;
  b.incarnation = 2;
  b.nonce = 0x3333;
  b.step = 5;
  b.round = 6;
  b.closes_round = true;
  b.representative = true;
  b.obstacle_map = true;
  b.matched = {0x10, 0x1111};
  b.needs = {{1, 6}, {1, 5, NeedTopic::ObstacleMap}};
  b.mode = AgentMode::Failed;
  b.constraint = Constraint::Separation;
  b.constraint_peer = 1;
  b.pose = {Vec3(1.0, 2.0, 3.0), 4.0, 0.5};
  b.commanded_velocity_mps = Vec3(6.0, 7.0, 8.0);
  b.map_hash = 0x77;
  b.plan_view = 0x88;
  b.safety_mode = SafetyMode::Controlled;
  b.safety_reason = SafetyReason::Deviation;
  b.deviation_m = 12.5;
  b.predicted_separation_m = 33.0;
  b.planned_length_m = 35050.0;
  b.cost = -3.5;
  b.generation = 9;
  b.state_hash = 0x0123456789abcdef;
  b.acknowledged = {0x99, 0x97};
  return b;
}

inline Command command() {
  return {77, {0x99, 3, OrderKind::Goto, Vec3(1.0, -2.0, 3.0), 4.5}, 5.5};
}

inline Inject inject() {
  return {77, {0x97, InjectionKind::Obstacle, 0, Vec3(1.0, 2.0, 3.0), Vec3(-4.0, 5.0, -6.0), 7.5, true}, 8.5};
}

}  // namespace skein::examples
