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
inline constexpr std::uint32_t kWireVersion = 4;

using v4::Area;
using v4::Beacon;
using v4::CellBlock;
using v4::Crossing;
using v4::DirectedPoint;
using v4::Ground;
using v4::Header;
using v4::HeardPeer;
using v4::Lack;
using v4::LiveAgent;
using v4::LogMark;
using v4::MapPatch;
using v4::Mission;
using v4::NextMove;
using v4::ObstacleMap;
using v4::Point3;
using v4::RendezvousPlanner;
using v4::Representative;
using v4::Sense;
using v4::Tick;
using v4::TurnedAway;
using v4::Vehicle;

/// Any sample of the protocol.
using Sample = std::variant<Mission, Tick, Sense, Representative, ObstacleMap, Beacon>;

// Bounds of the sequences and strings of idl/msg, which the converters hold.
inline constexpr std::size_t kMaxName = 128;
inline constexpr std::size_t kMaxVehicles = 256;
inline constexpr std::size_t kMaxZones = 1024;
inline constexpr std::size_t kMaxParticle = 16;
inline constexpr std::size_t kMaxRefused = 256;
inline constexpr std::size_t kMaxReason = 512;
inline constexpr std::size_t kMaxMatched = 257;
inline constexpr std::size_t kMaxNeeds = 512;

}  // namespace skein::wire
