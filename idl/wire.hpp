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
inline constexpr std::uint32_t kWireVersion = 6;

using v6::Announced;
using v6::Area;
using v6::Beacon;
using v6::CellBlock;
using v6::Crossing;
using v6::DirectedPoint;
using v6::GivenId;
using v6::Ground;
using v6::Header;
using v6::HeardPeer;
using v6::Lack;
using v6::LiveAgent;
using v6::LogMark;
using v6::MapPatch;
using v6::Mission;
using v6::NextMove;
using v6::ObstacleMap;
using v6::Point3;
using v6::RendezvousPlanner;
using v6::Reopening;
using v6::Representative;
using v6::Sense;
using v6::Sighting;
using v6::Tick;
using v6::TurnedAway;
using v6::Vehicle;

/// Any sample of the protocol.
using Sample = std::variant<Mission, Tick, Sense, Representative, ObstacleMap, Beacon>;

// Bounds of the sequences and strings of idl/msg, which the converters hold.
inline constexpr std::size_t kMaxName = 128;
inline constexpr std::size_t kMaxVehicles = 256;
inline constexpr std::size_t kMaxZones = 1024;
inline constexpr std::size_t kMaxAnnounced = 64;
inline constexpr std::size_t kMaxTracks = 256;
inline constexpr std::size_t kMaxKnown = 64;
inline constexpr std::size_t kMaxParticle = 16;
inline constexpr std::size_t kMaxRefused = 256;
inline constexpr std::size_t kMaxReason = 512;
inline constexpr std::size_t kMaxMatched = 257;
inline constexpr std::size_t kMaxNeeds = 512;

}  // namespace skein::wire
