// Between the plain values of the protocol and the wire structs, checked in the direction that may lie.
//
// to_wire never fails for a value within the bounds of idl/msg; from_wire refuses whatever a correct sender of this run
// would not say, and names the first field that is wrong. Magnitudes are bounded (idl/convert/limits.hpp), so that
// arithmetic on a checked value cannot overflow. from_wire(to_wire(x)) == x for every x that from_wire accepts.
// Complexity: linear in the sample; no allocation but the value's own vectors.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "idl/convert/wire_fault.hpp"
#include "idl/wire.hpp"
#include "planner/core/lockstep/map_sample.hpp"
#include "planner/core/lockstep/samples.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

/// What a sample says about its publication and the plain value does not hold.
struct Stamp {
  std::int64_t stamp_ns = 0;  ///< the sender's clock; in no hash
  std::uint64_t run = 0;      ///< for the mission alone; the other values carry their run
};

/// What the receiver knows and a sample must agree with.
struct WireContext {
  std::optional<std::uint64_t> run;  ///< must match, if given; an introduction (incarnation 0) may say 0
  std::span<const AgentId> known;    ///< ascending; empty: any id from 1 to kMaxAgents
  /// Live agents by ascending id: a sample of an agent must agree in incarnation (a beacon in its nonce as well).
  std::optional<std::span<const RosterEntry>> roster;
  std::size_t particle_size = 0;   ///< length that a representative's particle must have; 0: any
  std::optional<CellGrid> grid{};  ///< that the cells and tiles of an obstacle map must be in, if given
};

/// @throws std::invalid_argument if a list or text is longer than its bound on the wire (any of them).
[[nodiscard]] wire::Mission to_wire(const Mission& mission, const Stamp& stamp);
[[nodiscard]] wire::Tick to_wire(const Tick& tick, const Stamp& stamp);
[[nodiscard]] wire::Sense to_wire(const Sense& sense, const Stamp& stamp);
[[nodiscard]] wire::Representative to_wire(const Representative& representative, const Stamp& stamp);
[[nodiscard]] wire::ObstacleMap to_wire(const ObstacleMapSample& map, const Stamp& stamp);
[[nodiscard]] wire::Beacon to_wire(const Beacon& beacon, const Stamp& stamp);
[[nodiscard]] wire::Command to_wire(const Command& command, const Stamp& stamp);
[[nodiscard]] wire::Inject to_wire(const Inject& inject, const Stamp& stamp);

/// The mission's run is `sample.head().run()`; `known` and `roster` are not used, for the mission itself says who is.
[[nodiscard]] Checked<Mission> from_wire(const wire::Mission& sample, const WireContext& context);
/// The tick's own roster is checked against `known`; the context's roster is not used.
[[nodiscard]] Checked<Tick> from_wire(const wire::Tick& sample, const WireContext& context);
[[nodiscard]] Checked<Sense> from_wire(const wire::Sense& sample, const WireContext& context);
[[nodiscard]] Checked<Representative> from_wire(const wire::Representative& sample, const WireContext& context);
[[nodiscard]] Checked<ObstacleMapSample> from_wire(const wire::ObstacleMap& sample, const WireContext& context);
/// An introduction (incarnation 0) passes the roster check.
[[nodiscard]] Checked<Beacon> from_wire(const wire::Beacon& sample, const WireContext& context);
/// Whether the mission has the agent, the world says in its answer: `known` is not used.
[[nodiscard]] Checked<Command> from_wire(const wire::Command& sample, const WireContext& context);
[[nodiscard]] Checked<Inject> from_wire(const wire::Inject& sample, const WireContext& context);

}  // namespace skein
