#include "idl/convert/checker.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/parts.hpp"
#include "planner/core/obstacle_map/tile.hpp"

namespace skein {
namespace {

wire::NextMove wire_intent(const Intent& intent) {
  wire::NextMove out;
  out.from_m(wire_point(intent.from_m));
  out.to_m(wire_point(intent.to_m));
  out.to_go_m(intent.to_go_m);
  out.decision(intent.decision);
  out.waited(intent.waited);
  out.asks(intent.asks);
  out.on_behalf_of(intent.on_behalf_of);
  out.next_cells(intent.next_cells);
  out.status(static_cast<std::uint8_t>(intent.status));
  return out;
}

Intent plain_intent(const wire::NextMove& move) {
  Intent out;
  out.decision = move.decision();
  out.from_m = plain_point(move.from_m());
  out.to_m = plain_point(move.to_m());
  out.waited = move.waited();
  out.to_go_m = move.to_go_m();
  out.status = static_cast<NavStatus>(move.status());
  out.asks = move.asks();
  out.on_behalf_of = move.on_behalf_of();
  out.next_cells = move.next_cells();
  return out;
}

void check_intent(Checker& check, const wire::NextMove& move, const std::optional<CellGrid>& grid) {
  check.position(move.from_m(), "obstacle_map.intent.from_m");
  check.position(move.to_m(), "obstacle_map.intent.to_m");
  check.within(move.to_go_m(), -limits::kLength_m, limits::kLength_m, "obstacle_map.intent.to_go_m");
  check.enumerator(move.status(), NavStatus::Flying, NavStatus::Deadlock, "obstacle_map.intent.status");
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
    patch.origin(tile.origin);
    patch.tile(tile.tile);
    patch.epoch(tile.epoch);
    patch.version(tile.version);
    patch.cells(tile.cells);
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
    out.tiles.push_back({patch.origin(), patch.tile(), patch.epoch(), patch.version(), patch.cells()});
  }
  return out;
}

}  // namespace skein
