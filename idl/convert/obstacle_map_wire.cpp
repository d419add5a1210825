#include "idl/convert/checker.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/parts.hpp"
#include "planner/core/obstacle_map/tile.hpp"

namespace skein {
namespace {

wire::NextMove wire_intent(const Intent& intent) {
  wire::NextMove out;
  out.to_m(wire_point(intent.to_m));
  out.to_go_m(intent.to_go_m);
  out.decision(intent.decision);
  out.waited(static_cast<std::uint16_t>(std::min(intent.waited, kMaxWaited)));
  out.asks(static_cast<std::uint16_t>(intent.asks));
  out.on_behalf_of(static_cast<std::uint16_t>(intent.on_behalf_of));
  out.next_cells(intent.next_cells);
  out.status(static_cast<std::uint8_t>(intent.status));
  return out;
}

Intent plain_intent(const wire::NextMove& move) {
  Intent out;
  out.decision = move.decision();
  out.to_m = plain_point(move.to_m());
  out.waited = move.waited();
  out.to_go_m = move.to_go_m();
  out.status = static_cast<NavStatus>(move.status());
  out.asks = move.asks();
  out.on_behalf_of = move.on_behalf_of();
  out.next_cells = move.next_cells();
  return out;
}

std::array<std::uint32_t, 4> halves_of(const TileCells& cells) {
  std::array<std::uint32_t, 4> halves{};
  for (std::size_t i = 0; i < halves.size(); ++i) {
    halves[i] = static_cast<std::uint32_t>(cells[i / 2] >> (32 * (i % 2)));
  }
  return halves;
}

TileCells words_of(const std::array<std::uint32_t, 4>& halves) {
  const auto word = [](std::uint32_t low, std::uint32_t high) {
    return (static_cast<std::uint64_t>(high) << 32) | low;
  };
  return {word(halves[0], halves[1]), word(halves[2], halves[3])};
}

void check_intent(Checker& check, const wire::NextMove& move, const std::optional<CellGrid>& grid) {
  check.position(move.to_m(), "obstacle_map.intent.to_m");
  check.within(move.to_go_m(), -limits::kLength_m, limits::kLength_m, "obstacle_map.intent.to_go_m");
  check.enumerator(move.status(), NavStatus::Flying, NavStatus::Held, "obstacle_map.intent.status");
  if (move.asks() != 0) check.agent(move.asks(), "obstacle_map.intent.asks");
  if (move.on_behalf_of() != 0) check.agent(move.on_behalf_of(), "obstacle_map.intent.on_behalf_of");
  const std::size_t cells = grid ? grid->size() : limits::kCells;
  for (const std::uint32_t cell : move.next_cells()) {
    check.require(cell < cells, WireFaultReason::OutOfRange, "obstacle_map.intent.next_cells");
  }
}

void check_map(Checker& check, const wire::ObstacleMap& sample, const std::optional<CellGrid>& grid) {
  check.size_at_most(sample.seen().size(), kMaxSeen, "obstacle_map.seen");
  check.size_at_most(sample.tiles().size(), kMaxMapTiles, "obstacle_map.tiles");
  if (!check.ok()) return;
  std::uint32_t before = 0;
  for (const wire::LogMark& mark : sample.seen()) {
    check.agent(mark.agent(), "obstacle_map.seen.agent");
    check.require(mark.agent() > before, WireFaultReason::BadOrder, "obstacle_map.seen");
    before = mark.agent();
  }
  const std::size_t tiles = grid ? TileGrid(*grid).size() : limits::kCells;
  for (const wire::MapPatch& patch : sample.tiles()) {
    check.agent(patch.origin(), "obstacle_map.tiles.origin");
    check.require(patch.tile() < tiles, WireFaultReason::OutOfRange, "obstacle_map.tiles.tile");
    check.require(patch.version() > 0, WireFaultReason::OutOfRange, "obstacle_map.tiles.version");
  }
}

}  // namespace

wire::ObstacleMap to_wire(const ObstacleMapSample& map, const Stamp& stamp) {
  require_bound(map.seen.size(), kMaxSeen, "obstacle_map.seen");
  require_bound(map.tiles.size(), kMaxMapTiles, "obstacle_map.tiles");
  wire::ObstacleMap out;
  out.head(wire_head(map.run, stamp.stamp_ns, map.agent, map.incarnation));
  out.agent(map.agent);
  out.round(map.round);
  out.intent(wire_intent(map.intent));
  out.seen().resize(map.seen.size());
  for (std::size_t i = 0; i < map.seen.size(); ++i) {
    out.seen()[i].agent(map.seen[i].agent);
    out.seen()[i].version(map.seen[i].version);
    out.seen()[i].digest(map.seen[i].digest);
  }
  out.tiles().resize(map.tiles.size());
  for (std::size_t i = 0; i < map.tiles.size(); ++i) {
    const MapTile& tile = map.tiles[i];
    wire::MapPatch& patch = out.tiles()[i];
    patch.origin(static_cast<std::uint16_t>(tile.origin));
    patch.tile(tile.tile);
    patch.epoch(static_cast<std::uint16_t>(std::min(tile.epoch, kMaxEpoch)));
    patch.version(tile.version);
    patch.cells(halves_of(tile.cells));
  }
  return out;
}

Checked<ObstacleMapSample> from_wire(const wire::ObstacleMap& sample, const WireContext& context) {
  Checker check(context);
  check.agent(sample.agent(), "obstacle_map.agent");
  check.sender(sample.head(), sample.agent(), "obstacle_map.head.sender");
  check.run(sample.head().run(), "obstacle_map.head.run");
  check.incarnation(sample.agent(), sample.head().incarnation(), std::nullopt, "obstacle_map.head.incarnation");
  check_intent(check, sample.intent(), context.grid);
  check_map(check, sample, context.grid);
  if (!check.ok()) return check.fault();

  ObstacleMapSample out;
  out.run = sample.head().run();
  out.agent = sample.agent();
  out.incarnation = sample.head().incarnation();
  out.round = sample.round();
  out.intent = plain_intent(sample.intent());
  out.seen.reserve(sample.seen().size());
  for (const wire::LogMark& mark : sample.seen()) out.seen.push_back({mark.agent(), mark.version(), mark.digest()});
  out.tiles.reserve(sample.tiles().size());
  for (const wire::MapPatch& patch : sample.tiles()) {
    out.tiles.push_back({patch.origin(), patch.tile(), patch.epoch(), patch.version(), words_of(patch.cells())});
  }
  return out;
}

}  // namespace skein
