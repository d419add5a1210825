#include "planner/core/obstacle_map/tile_log.hpp"

#include <algorithm>

#include "planner/core/hash/state_hash.hpp"

namespace skein {

std::vector<LogEntry>::iterator TileLog::place_of(std::uint32_t tile) {
  return std::ranges::lower_bound(entries_, tile, {}, &LogEntry::tile);
}

bool TileLog::put(const LogEntry& entry) {
  const auto place = place_of(entry.tile);
  if (place != entries_.end() && place->tile == entry.tile && place->version >= entry.version) return false;
  write(entry);
  return true;
}

void TileLog::write(const LogEntry& entry) {
  auto place = place_of(entry.tile);
  if (place != entries_.end() && place->tile == entry.tile) {
    *place = entry;
  } else {
    place = entries_.insert(place, entry);
  }
  place->mark = StateHash(entry.tile).add(entry.version).value();
  newest_ = std::max(newest_, entry.version);
}

TileState TileLog::at(std::uint32_t tile) const {
  const auto place = std::ranges::lower_bound(entries_, tile, {}, &LogEntry::tile);
  return place != entries_.end() && place->tile == tile ? place->state : TileState{};
}

std::uint64_t TileLog::digest(std::uint32_t up_to_version) const {
  std::uint64_t sum = 0;
  for (const LogEntry& entry : entries_) {
    if (entry.version <= up_to_version) sum += entry.mark;
  }
  return sum;
}

}  // namespace skein
