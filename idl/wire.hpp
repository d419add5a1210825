// The wire structs of the current wire version, under one name: skein::wire.
//
// They are generated from idl/msg/*.idl (fastddsgen), hold what the plain values of planner/core/lockstep hold, and are
// read and written by idl/convert alone. Only `kWireVersion` and the module in the .idl files name the version.
#pragma once

#include <cstdint>
#include <variant>

#include "idl/msg/beacon.h"
#include "idl/msg/command.h"
#include "idl/msg/inject.h"
#include "idl/msg/mission.h"
#include "idl/msg/obstacle_map.h"
#include "idl/msg/representative.h"
#include "idl/msg/sense.h"
#include "idl/msg/tick.h"

namespace skein::wire {

/// The version that type names carry; processes of different versions never match.
inline constexpr std::uint32_t kWireVersion = 7;

using v7::Announced;
using v7::Answered;
using v7::Area;
using v7::Beacon;
using v7::CellBlock;
using v7::Command;
using v7::Crossing;
using v7::DirectedPoint;
using v7::GivenId;
using v7::Ground;
using v7::Header;
using v7::HeardPeer;
using v7::Inject;
using v7::Lack;
using v7::LiveAgent;
using v7::LogMark;
using v7::MapPatch;
using v7::Mission;
using v7::NextMove;
using v7::ObstacleMap;
using v7::Ordered;
using v7::Point3;
using v7::RendezvousPlanner;
using v7::Reopening;
using v7::Representative;
using v7::Sense;
using v7::Sighting;
using v7::Tick;
using v7::TurnedAway;
using v7::Vehicle;

/// Any sample of the protocol.
using Sample = std::variant<Mission, Tick, Sense, Representative, ObstacleMap, Beacon, Command, Inject>;

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
inline constexpr std::size_t kMaxOrders = 16;  // of a tick, and of an agent's acknowledgements
inline constexpr std::size_t kMaxAnswers = 16;
inline constexpr std::size_t kMaxAnswer = 256;

}  // namespace skein::wire
