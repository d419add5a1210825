// All fields of all samples, as Cyclone DDS has decoded them, by name: what `skein dump` prints of the same samples.
#pragma once

#include <nlohmann/json.hpp>

#include <cyclone/beacon.h>
#include <cyclone/command.h>
#include <cyclone/inject.h>
#include <cyclone/mission.h>
#include <cyclone/obstacle_map.h>
#include <cyclone/representative.h>
#include <cyclone/sense.h>
#include <cyclone/tick.h>

namespace skein::cyclone {
using Json = nlohmann::json;
}

/// Cyclone's sequence of anything.
template <typename Sequence>
requires requires(const Sequence& sequence) {
  sequence._length;
  sequence._buffer;
}
void to_json(skein::cyclone::Json& json, const Sequence& sequence) {
  json = skein::cyclone::Json::array();
  for (std::uint32_t i = 0; i < sequence._length; ++i) json.push_back(sequence._buffer[i]);
}

// A struct of the wire and all its members; the inner macros are those of nlohmann/json, which name json and struct so.
#define SKEIN_FIELDS(Struct, ...)                                                             \
  inline void to_json(skein::cyclone::Json& nlohmann_json_j, const Struct& nlohmann_json_t) { \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_TO, __VA_ARGS__))                  \
  }

SKEIN_FIELDS(skein_v7_Header, run, stamp_ns, sender, incarnation)
SKEIN_FIELDS(skein_v7_Point3, x, y, z)
SKEIN_FIELDS(skein_v7_Sighting, id, position_m, velocity_mps, radius_m, column, immobile)
SKEIN_FIELDS(skein_v7_DirectedPoint, position_m, heading_rad, climb_rad)

SKEIN_FIELDS(skein_v7_Vehicle, agent, start, slot_offset_m, kind, speed_mps, max_curvature_per_m, radius_m,
             safety_radius_m, max_torsion_per_m, max_acceleration_mps2)
SKEIN_FIELDS(skein_v7_Area, shape, no_fly, min_m, max_m, radius_m)
SKEIN_FIELDS(skein_v7_Ground, a, b, c, d, e, f, g, h, l)
SKEIN_FIELDS(skein_v7_RendezvousPlanner, name, particles, generations, length_weight, inertia_start, inertia_end,
             cognitive, social, search_min_chords, search_max_chords, velocity_limit, reinitialise_probability,
             check_points, dense_points, penalty, length_penalty, clearance_margin_m, equalise_directions,
             equalise_rounds, cooperate, own_reference, refresh_costs, equalise, length_tolerance_m,
             crossover_probability, mutation_probability, max_segments, replan, rounds_per_step)
SKEIN_FIELDS(skein_v7_Crossing, area_min_m, area_max_m, goal_radius_m, planner_name, planner_values, radio_values,
             sensor_values, goals_m)
SKEIN_FIELDS(skein_v7_Announced, place, from_s, to_s, early_s, clear_s)
SKEIN_FIELDS(skein_v7_Mission, head, name, kind, seed, length_unit_m, step_s, formation, arrival_radius_m, vehicles,
             zones, terrain, planner, transit, controller_name, controller_values, announced)

SKEIN_FIELDS(skein_v7_LiveAgent, agent, incarnation, nonce, counts_representative, gets_sense, counts_obstacle_map)
SKEIN_FIELDS(skein_v7_TurnedAway, nonce, reason)
SKEIN_FIELDS(skein_v7_GivenId, nonce, agent)
SKEIN_FIELDS(skein_v7_Ordered, id, agent, kind, to_m, speed_mps)
SKEIN_FIELDS(skein_v7_Answered, id, result, round, acknowledged, text)
SKEIN_FIELDS(skein_v7_Tick, head, step, round, phase, time_s, roster, refused, given, world_hash, exit_code, reason,
             commands, answers)
SKEIN_FIELDS(skein_v7_Command, head, id, agent, kind, to_m, speed_mps, deadline_s)
SKEIN_FIELDS(skein_v7_Inject, head, id, kind, agent, position_m, velocity_mps, radius_m, column, deadline_s)

SKEIN_FIELDS(skein_v7_HeardPeer, agent, position_m, velocity_mps, landed)
SKEIN_FIELDS(skein_v7_CellBlock, i, j, k, ni, nj, nk, packed)
SKEIN_FIELDS(skein_v7_Sense, head, agent, round, own, velocity_mps, heard, sight, tracks, zones, obeyed)

SKEIN_FIELDS(skein_v7_Lack, agent, round, topic)
SKEIN_FIELDS(skein_v7_Beacon, head, agent, nonce, step, round, closes_round, sent_representative, sent_obstacle_map,
             matched, needs, mode, failing, failing_peer, own, commanded_velocity_mps, planned_length_m, cost,
             generation, map_hash, plan_view, safety_mode, safety_reason, deviation_m, predicted_separation_m,
             state_hash, acknowledged)

SKEIN_FIELDS(skein_v7_Reopening, attempt, switch_step, reason, own, speed_mps, obstacles)
SKEIN_FIELDS(skein_v7_Representative, head, agent, round, stage, violated, particle, cost, own_length_m, path_length_m,
             reopening)

SKEIN_FIELDS(skein_v7_NextMove, to_m, to_go_m, decision, next_cells, asks, on_behalf_of, waited, status)
SKEIN_FIELDS(skein_v7_LogMark, agent, version, digest)
SKEIN_FIELDS(skein_v7_MapPatch, tile, version, cells, origin, epoch)
SKEIN_FIELDS(skein_v7_ObstacleMap, head, agent, round, intent, seen, tiles)
