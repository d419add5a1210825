// What one agent contributed to the map, as another one holds it: per tile the newest version.
//
// An agent's log has one writer. Each change of a tile in it gets the log's next version and replaces the older one,
// which it includes. The digest of a log up to version v, the sum of hash(tile, version) over the tiles whose version
// is at most v, tells whether two agents hold the same of it. Source: van Renesse, Dumitriu, Gough, Thomas, 'Efficient
// reconciliation and flow control for anti-entropy protocols', LADIS 2008. Departs from source: digests, so that tiles
// may come in any order. Complexity: put O(log n) and a move of entries, digest O(n), for n tiles in the log.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planner/core/obstacle_map/tile.hpp"

namespace skein {

struct LogEntry {
  std::uint32_t tile = 0;
  std::uint32_t version = 0;
  TileState state;
  std::uint32_t known_round = 0;  ///< since when it is here
  std::uint32_t sent_round = 0;   ///< when this version was last sent from here; 0: never
  std::uint64_t mark = 0;         ///< hash(tile, version), set by the log

  /// When something last became of it.
  [[nodiscard]] std::uint32_t touched_round() const { return known_round > sent_round ? known_round : sent_round; }
};

class TileLog {
 public:
  /// Takes the entry over if its version is newer than that of the tile here. @return whether it was
  bool put(const LogEntry& entry);
  /// The log's own writer: the entry replaces one of the same version, too. @pre a version of newest() or over it
  void write(const LogEntry& entry);
  /// The state of a tile in this log; epoch 0 without a known cell if it is not there.
  [[nodiscard]] TileState at(std::uint32_t tile) const;

  [[nodiscard]] std::uint64_t digest(std::uint32_t up_to_version) const;
  [[nodiscard]] std::uint32_t newest() const { return newest_; }
  /// By ascending tile.
  [[nodiscard]] std::span<const LogEntry> entries() const { return entries_; }
  [[nodiscard]] std::span<LogEntry> entries() { return entries_; }

 private:
  [[nodiscard]] std::vector<LogEntry>::iterator place_of(std::uint32_t tile);

  std::vector<LogEntry> entries_;
  std::uint32_t newest_ = 0;
};

}  // namespace skein
