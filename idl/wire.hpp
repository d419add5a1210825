// The wire structs of the current wire version, under one name: skein::wire.
//
// They are generated from idl/msg/*.idl (fastddsgen), hold what the plain values of planner/core/lockstep hold, and are
// read and written by idl/convert alone. Only `kWireVersion` and the module in the .idl files name the version.
#pragma once

#include <cstdint>
#include <variant>

#include "idl/msg/beacon.h"
#include "idl/msg/mission.h"
#include "idl/msg/representative.h"
#include "idl/msg/sense.h"
#include "idl/msg/tick.h"

namespace skein::wire {

/// The version that type names carry; processes of different versions never match.
inline constexpr std::uint32_t kWireVersion = 2;

using v2::Area;
using v2::Beacon;
using v2::DirectedPoint;
using v2::Ground;
using v2::Header;
using v2::Lack;
using v2::LiveAgent;
using v2::Mission;
using v2::Point3;
using v2::RendezvousPlanner;
using v2::Representative;
using v2::Sense;
using v2::Tick;
using v2::TurnedAway;
using v2::Vehicle;

/// Any sample of the protocol.
using Sample = std::variant<Mission, Tick, Sense, Representative, Beacon>;

// Bounds of the sequences and strings of idl/msg, which the converters hold.
inline constexpr std::size_t kMaxName = 128;
inline constexpr std::size_t kMaxVehicles = 256;
inline constexpr std::size_t kMaxZones = 1024;
inline constexpr std::size_t kMaxParticle = 16;
inline constexpr std::size_t kMaxRefused = 256;
inline constexpr std::size_t kMaxMatched = 257;
inline constexpr std::size_t kMaxNeeds = 512;

}  // namespace skein::wire
