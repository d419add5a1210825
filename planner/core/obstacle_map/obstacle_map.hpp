// One agent's map of the cells, which all agents of a swarm bring to the same state by what they tell each other.
//
// The map is the join (tile.hpp) of the agents' logs (tile_log.hpp), each with one writer: what an agent sees and the
// map does not show yet goes into its own log. Seeing an Occupied cell free opens the tile's next epoch, with all that
// the agent knows of the other cells; who knows more of them when that epoch reaches it adds it to its own log. If
// openings race, the join may keep the obstacle, until somebody looks again.
//
// Version vectors. seen[a] = v holds the promise: of a's log, every tile whose newest version is at most v is here in
// that version. A sample tells seen[a] with the digest of what its sender holds of a's log up to there; who holds the
// same digest takes the entry over. The promise passes on: a tile whose newest version is at most v is in the sender's
// set by its promise, the sets are equal, so it is in the receiver's; and a's later changes take a tile out of the
// promise's range. Nothing else raises an entry, so loss, order, repetition and samples cut short cannot break it; only
// a collision of 64-bit digests could.
// Anti-entropy: a peer lacks the tiles whose version is over its entry. Of those who hold such a tile and reach that
// peer its origin sends it, else the next id after it; the others step in only after `patience_rounds` each. A tile
// sent waits for the answer before it is sent again. What was longest without being sent outranks the nearest in the
// end, so nothing starves.
// Lives. Who comes back knows nothing any more and begins a log anew, over all versions of its former life. All others
// take over into their own logs what only that former log held, and forget it (begin_life), in the same round: so that
// it reaches the one who came back as any other tile does, and digests are of one life. Source: papers/004, section
// IV-B2 (maps of 2 bits a cell); Shapiro et al. 2011; van Renesse et al. 2008. Departs from source: the paper sends the
// whole matrix. Complexity: observe O(changes log tiles); merge O(tiles log tiles), and a pass over a log for each
// entry that rises; compose O(peers x tiles that one of them lacks). Memory: 48 bytes for each tile and agent that
// contributed to it.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/lockstep/map_sample.hpp"
#include "planner/core/obstacle_map/tile_log.hpp"

namespace skein {

/// A peer in reach, and where it is going.
struct MapPeer {
  AgentId agent = 0;
  Vec3 at_m = Vec3::Zero();
  Vec3 to_m = Vec3::Zero();  ///< its goal, or the cells that it comes to next
};

struct MapRequest {
  std::size_t budget_bytes = SIZE_MAX;  ///< of the whole sample, as payload_bytes() counts
  std::uint32_t round = 0;              ///< of the sample, over 0; it ascends from request to request
  std::span<const MapPeer> peers;       ///< in reach now; one never heard from is assumed to know nothing
  double range_m = std::numeric_limits<double>::infinity();  ///< of the radio: which peers reach each other
  std::uint32_t latency_rounds = 0;                          ///< of the radio, beyond the next round
  std::uint32_t patience_rounds = 4;                         ///< twice the rounds from map to map, or more
};

struct MapPart {
  std::vector<Seen> seen;      ///< by ascending agent
  std::vector<MapTile> tiles;  ///< most useful first
  std::size_t left = 0;        ///< tiles for which there was no room
  /// It need not be sent: nobody lacks what this agent holds, its vector is as last told, and that was not long ago (a
  /// peer waits for an answer to tiles that may have been lost).
  bool idle = false;
};

class ObstacleMap {
 public:
  /// @param ids of all agents, ascending, `self` among them
  /// @param first_version an agent that came back starts its log over all versions of its former life
  /// @throws std::invalid_argument if they are not, or the grid has no cell
  ObstacleMap(const CellGrid& grid, AgentId self, std::span<const AgentId> ids, std::uint32_t first_version = 0);

  [[nodiscard]] const CellGrid& grid() const { return tiles_.cells; }
  /// @pre a cell of the grid
  [[nodiscard]] CellState at(CellIndex cell) const;

  /// What the own sensor saw (Free, Occupied) or the planner marked (Revisited). Free does not lift Revisited.
  /// @throws std::invalid_argument for a cell that is not in the grid
  void observe(std::span<const CellChange> changes);
  /// The planner takes its marks back: cells that are Revisited are Free in the next epoch of their tile.
  void unmark(std::span<const CellIndex> cells);
  /// An agent came back, and writes its log anew, all versions over `first_version`.
  /// @pre no version of its former life is over that
  void begin_life(AgentId agent, std::uint32_t first_version);
  /// What a peer sent: tiles of any agent, in any order. Agents that are not in the mission and tiles that are not in
  /// the grid are left out.
  void merge(const ObstacleMapSample& sample);
  /// The cells whose state is another than when last taken, each once, in its state now.
  [[nodiscard]] std::vector<CellChange> take_changes();

  /// What the next sample tells; nothing if not even its control part fits into the budget.
  [[nodiscard]] std::optional<MapPart> compose(const MapRequest& request);

  /// Of cell states and epochs alone: equal maps, equal hashes.
  [[nodiscard]] std::uint64_t map_hash() const;
  [[nodiscard]] bool same_map(const ObstacleMap& other) const { return merged_ == other.merged_; }
  [[nodiscard]] std::uint32_t seen_of(AgentId agent) const;
  [[nodiscard]] TileState tile_at(std::uint32_t tile) const { return merged_.at(tile); }
  void add_to(StateHash& hash) const;

 private:
  struct Peer {
    std::uint32_t incarnation = 0;
    std::uint32_t answered_round = 0;  ///< of the newest vector heard from it; 0: none
    std::uint32_t met_round = 0;       ///< since when it is in reach
    std::uint32_t listed_round = 0;    ///< of the last request that lists it
    std::vector<std::uint32_t> holds;  ///< its version vector by rank, as heard
  };
  struct Target {
    std::size_t rank = 0;
    MapPeer peer;
  };
  struct Candidate {
    std::int64_t key = 0;  ///< tiles between it and the ways of those who lack it, less the time it waited
    std::size_t rank = 0;
    LogEntry* entry = nullptr;
  };

  [[nodiscard]] std::optional<std::size_t> rank_of(AgentId agent) const;
  [[nodiscard]] TilePlace place_of(CellIndex cell) const;
  void contribute(std::uint32_t tile, const TileState& state);
  [[nodiscard]] bool only_in(std::size_t rank, const LogEntry& entry) const;
  void close_change();
  void open_epochs(std::span<const CellChange> contradictions);
  void absorb(const MapTile& tile);
  void change(std::uint32_t tile, const TileState& state);
  void hear_vector(const ObstacleMapSample& sample, std::size_t sender);
  [[nodiscard]] std::vector<Target> targets_of(const MapRequest& request);
  [[nodiscard]] std::vector<Candidate> lacked(const MapRequest& request, std::span<const Target> targets);
  [[nodiscard]] bool is_due(const LogEntry& entry, std::size_t origin, const Target& to, const MapRequest& request,
                            std::span<const Target> targets) const;
  [[nodiscard]] std::size_t entries_worth_telling(const MapRequest& request, std::span<const Target> targets) const;
  [[nodiscard]] std::vector<Seen> tell_vector(std::size_t count);

  TileGrid tiles_;
  std::vector<AgentId> ids_;
  std::size_t self_;
  std::uint32_t version_;             ///< of the own log
  std::uint32_t round_ = 0;           ///< the newest heard of
  std::vector<TileState> merged_;     ///< by tile
  std::vector<TileCells> taken_;      ///< as take_changes() last told them
  std::vector<std::uint32_t> dirty_;  ///< tiles that changed since, perhaps twice
  std::vector<TileLog> logs_;         ///< by rank
  std::vector<std::uint32_t> seen_;   ///< by rank
  std::vector<std::uint32_t> told_;   ///< `seen_` as last told
  std::vector<std::uint32_t> first_;  ///< by rank: versions up to this one are of a former life
  std::size_t next_told_ = 0;         ///< where a vector that does not fit goes on
  std::uint32_t composed_round_ = 0;
  std::uint32_t told_round_ = 0;  ///< when a part that was not idle was last composed
  bool owes_answer_ = false;      ///< a peer sent tiles since
  std::vector<Peer> peers_;       ///< by rank
};

}  // namespace skein
