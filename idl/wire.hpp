// The wire structs of the current wire version, under one name: skein::wire.
//
// They are generated from idl/msg/*.idl (fastddsgen), hold what the plain values of planner/core/lockstep hold, and are
// read and written by idl/convert alone. Only `kWireVersion` and the module in the .idl files name the version.
#pragma once

#include <cstdint>
#include <variant>

#include "idl/msg/beacon.h"
#include "idl/msg/mission.h"
#include "idl/msg/obstacle_map.h"
#include "idl/msg/representative.h"
#include "idl/msg/sense.h"
#include "idl/msg/tick.h"

namespace skein::wire {

/// The version that type names carry; processes of different versions never match.
inline constexpr std::uint32_t kWireVersion = 3;

using v3::Area;
using v3::Beacon;
using v3::CellBlock;
using v3::Crossing;
using v3::DirectedPoint;
using v3::Ground;
using v3::Header;
using v3::HeardPeer;
using v3::Lack;
using v3::LiveAgent;
using v3::LogMark;
using v3::MapPatch;
using v3::Mission;
using v3::NextMove;
using v3::ObstacleMap;
using v3::Point3;
using v3::RendezvousPlanner;
using v3::Representative;
using v3::Sense;
using v3::Tick;
using v3::TurnedAway;
using v3::Vehicle;

/// Any sample of the protocol.
using Sample = std::variant<Mission, Tick, Sense, Representative, ObstacleMap, Beacon>;

// Bounds of the sequences and strings of idl/msg, which the converters hold.
inline constexpr std::size_t kMaxName = 128;
inline constexpr std::size_t kMaxVehicles = 256;
inline constexpr std::size_t kMaxZones = 1024;
inline constexpr std::size_t kMaxParticle = 16;
inline constexpr std::size_t kMaxSight = 49152;  ///< bytes
inline constexpr std::size_t kMaxRefused = 256;
inline constexpr std::size_t kMaxReason = 512;
inline constexpr std::size_t kMaxMatched = 257;
inline constexpr std::size_t kMaxNeeds = 512;

}  // namespace skein::wire
