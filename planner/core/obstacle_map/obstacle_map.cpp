#include "planner/core/obstacle_map/obstacle_map.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

namespace skein {
namespace {

std::size_t place_of_self(AgentId self, std::span<const AgentId> ids) {
  const bool ascends = std::ranges::adjacent_find(ids, std::greater_equal<>()) == ids.end();
  const auto place = std::ranges::find(ids, self);
  if (!ascends || place == ids.end()) {
    throw std::invalid_argument("the agents of a map must ascend, and " + std::to_string(self) + " be one of them");
  }
  return static_cast<std::size_t>(place - ids.begin());
}

}  // namespace

ObstacleMap::ObstacleMap(const CellGrid& grid, AgentId self, std::span<const AgentId> ids, std::uint32_t first_version)
    : tiles_(grid),
      ids_(ids.begin(), ids.end()),
      self_(place_of_self(self, ids)),
      version_(first_version),
      logs_(ids.size()),
      seen_(ids.size(), 0),
      told_(ids.size(), 0),
      first_(ids.size(), 0),
      peers_(ids.size()) {
  if (grid.nx < 1 || grid.ny < 1 || grid.nz < 1) throw std::invalid_argument("the grid of a map has no cell");
  merged_.resize(tiles_.size());
  taken_.resize(tiles_.size());
  seen_[self_] = version_;
  for (Peer& peer : peers_) peer.holds.resize(ids.size(), 0);
}

std::optional<std::size_t> ObstacleMap::rank_of(AgentId agent) const {
  const auto place = std::ranges::lower_bound(ids_, agent);
  if (place == ids_.end() || *place != agent) return std::nullopt;
  return static_cast<std::size_t>(place - ids_.begin());
}

TilePlace ObstacleMap::place_of(CellIndex cell) const {
  if (cell >= grid().size()) throw std::invalid_argument("the map has no cell " + std::to_string(cell));
  return tiles_.place_of(grid().cell_at(cell));
}

CellState ObstacleMap::at(CellIndex cell) const {
  const TilePlace place = tiles_.place_of(grid().cell_at(cell));
  return cell_in(merged_[place.tile].cells, place.n);
}

std::uint32_t ObstacleMap::seen_of(AgentId agent) const {
  const auto rank = rank_of(agent);
  return rank ? seen_[*rank] : 0;
}

void ObstacleMap::change(std::uint32_t tile, const TileState& state) {
  if (merged_[tile] == state) return;
  if (merged_[tile].cells != state.cells) dirty_.push_back(tile);
  merged_[tile] = state;
}

/// Into the own log, under the version of the change that is going on.
void ObstacleMap::contribute(std::uint32_t tile, const TileState& state) {
  TileLog& own = logs_[self_];
  const TileState before = own.at(tile);
  const TileState after = join(before, state);
  if (after == before) return;
  own.write({tile, version_ + 1, after, round_, 0, 0});  // once more in one change: nobody has seen the first yet
}

void ObstacleMap::close_change() {
  version_ = std::max(version_, logs_[self_].newest());
  seen_[self_] = version_;
}

/// Of each tile once, with all its contradicted cells set as they are seen.
void ObstacleMap::open_epochs(std::span<const CellChange> contradictions) {
  std::vector<TilePlace> places;
  for (const CellChange& seen : contradictions) places.push_back(place_of(seen.cell));
  std::ranges::sort(places, {}, &TilePlace::tile);
  for (std::size_t i = 0; i < places.size();) {
    const std::uint32_t tile = places[i].tile;
    TileState opened = merged_[tile];
    for (; i < places.size() && places[i].tile == tile; ++i) set_cell(opened.cells, places[i].n, CellState::Free);
    if (opened.epoch == kMaxEpoch) continue;
    ++opened.epoch;
    contribute(tile, opened);
    change(tile, opened);
  }
}

void ObstacleMap::observe(std::span<const CellChange> changes) {
  std::vector<CellChange> contradictions;
  for (const CellChange& seen : changes) {
    const TilePlace place = place_of(seen.cell);
    const CellState known = cell_in(merged_[place.tile].cells, place.n);
    if (seen.state == CellState::Free && known == CellState::Occupied) contradictions.push_back(seen);
  }
  open_epochs(contradictions);
  for (const CellChange& seen : changes) {
    const TilePlace place = place_of(seen.cell);
    const TileState& before = merged_[place.tile];
    if (seen.state <= cell_in(before.cells, place.n)) continue;
    TileState own{before.epoch, {}};
    set_cell(own.cells, place.n, seen.state);
    contribute(place.tile, own);
    change(place.tile, join(before, own));
  }
  close_change();
}

void ObstacleMap::unmark(std::span<const CellIndex> cells) {
  std::vector<CellChange> marked;
  for (const CellIndex cell : cells) {
    const TilePlace place = place_of(cell);
    if (cell_in(merged_[place.tile].cells, place.n) == CellState::Revisited) marked.push_back({cell, CellState::Free});
  }
  open_epochs(marked);
  close_change();
}

/// Whether a log of this rank holds of a tile what no other one does.
bool ObstacleMap::only_in(std::size_t rank, const LogEntry& entry) const {
  TileState others;
  for (std::size_t other = 0; other < logs_.size(); ++other) {
    if (other != rank) others = join(others, logs_[other].at(entry.tile));
  }
  return join(others, entry.state) != others;
}

void ObstacleMap::begin_life(AgentId agent, std::uint32_t first_version) {
  const auto rank = rank_of(agent);
  if (!rank || *rank == self_) return;
  for (const LogEntry& entry : logs_[*rank].entries()) {
    if (only_in(*rank, entry)) contribute(entry.tile, entry.state);
  }
  close_change();
  logs_[*rank] = TileLog{};
  seen_[*rank] = told_[*rank] = 0;
  first_[*rank] = first_version;
}

void ObstacleMap::absorb(const MapTile& tile) {
  const auto origin = rank_of(tile.origin);
  if (!origin || tile.tile >= merged_.size()) return;
  if (*origin != self_ && tile.version <= first_[*origin]) return;  // of a former life, and in the sender's own log
  const TileState theirs{tile.epoch, tile.cells};
  if (*origin == self_) {
    contribute(tile.tile, theirs);  // new to the own log only if of a former life
  } else if (!logs_[*origin].put({tile.tile, tile.version, theirs, round_, 0, 0})) {
    return;
  }
  const TileState before = merged_[tile.tile];
  TileState after = join(before, theirs);
  if (theirs.epoch > before.epoch) {
    const TileCells carried = missing_in(theirs.cells, before.cells);
    if (known_cells(carried) > 0) {
      contribute(tile.tile, {theirs.epoch, carried});
      after = join(after, {theirs.epoch, carried});
    }
  }
  change(tile.tile, after);
}

void ObstacleMap::hear_vector(const ObstacleMapSample& sample, std::size_t sender) {
  Peer& peer = peers_[sender];
  if (sample.incarnation < peer.incarnation) return;
  if (sample.incarnation > peer.incarnation) std::ranges::fill(peer.holds, 0);  // it knows nothing any more
  peer.incarnation = sample.incarnation;
  if (!sample.seen.empty()) peer.answered_round = std::max(peer.answered_round, sample.round);
  for (const Seen& claim : sample.seen) {
    const auto rank = rank_of(claim.agent);
    if (!rank) continue;
    peer.holds[*rank] = std::max(peer.holds[*rank], claim.version);
    if (*rank == self_ || claim.version <= seen_[*rank]) continue;
    if (logs_[*rank].digest(claim.version) == claim.digest) seen_[*rank] = claim.version;
  }
}

void ObstacleMap::merge(const ObstacleMapSample& sample) {
  const auto sender = rank_of(sample.agent);
  if (!sender || *sender == self_) return;
  round_ = std::max(round_, sample.round);
  for (const MapTile& tile : sample.tiles) absorb(tile);
  owes_answer_ = owes_answer_ || !sample.tiles.empty();
  close_change();
  hear_vector(sample, *sender);
}

std::vector<CellChange> ObstacleMap::take_changes() {
  std::ranges::sort(dirty_);
  dirty_.erase(std::unique(dirty_.begin(), dirty_.end()), dirty_.end());
  std::vector<CellChange> changes;
  for (const std::uint32_t tile : dirty_) {
    const TileCells& now = merged_[tile].cells;
    for (std::uint32_t n = 0; n < kTileEdge * kTileEdge; ++n) {
      const CellState state = cell_in(now, n);
      const Cell cell = tiles_.cell_at({tile, n});
      if (state != cell_in(taken_[tile], n) && grid().contains(cell)) changes.push_back({grid().index_of(cell), state});
    }
    taken_[tile] = now;
  }
  dirty_.clear();
  return changes;
}

std::uint64_t ObstacleMap::map_hash() const {
  StateHash hash;
  for (std::size_t tile = 0; tile < merged_.size(); ++tile) {
    const TileState& state = merged_[tile];
    if (state != TileState{}) hash.add(tile).add(state.epoch).add(state.cells[0]).add(state.cells[1]);
  }
  return hash.value();
}

void ObstacleMap::add_to(StateHash& hash) const {
  hash.add(map_hash()).add(seen_.size());
  for (const std::uint32_t version : seen_) hash.add(version);
}

}  // namespace skein
