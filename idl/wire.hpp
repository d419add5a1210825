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
inline constexpr std::uint32_t kWireVersion = 5;

using v5::Announced;
using v5::Area;
using v5::Beacon;
using v5::CellBlock;
using v5::Crossing;
using v5::DirectedPoint;
using v5::GivenId;
using v5::Ground;
using v5::Header;
using v5::HeardPeer;
using v5::Lack;
using v5::LiveAgent;
using v5::LogMark;
using v5::MapPatch;
using v5::Mission;
using v5::NextMove;
using v5::ObstacleMap;
using v5::Point3;
using v5::RendezvousPlanner;
using v5::Reopening;
using v5::Representative;
using v5::Sense;
using v5::Sighting;
using v5::Tick;
using v5::TurnedAway;
using v5::Vehicle;

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
