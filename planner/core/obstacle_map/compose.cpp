// What goes into the next sample: which tiles peers lack, who is to send them, and which come first.
#include <algorithm>
#include <cmath>

#include "planner/core/obstacle_map/obstacle_map.hpp"

namespace skein {
namespace {

/// How far a point is from a segment.
double distance_m(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double length2 = along.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp((point - from).dot(along) / length2, 0.0, 1.0) : 0.0;
  return std::sqrt((point - from - s * along).squaredNorm());
}

}  // namespace

std::vector<ObstacleMap::Target> ObstacleMap::targets_of(const MapRequest& request) {
  std::vector<Target> targets;
  for (const MapPeer& listed : request.peers) {
    const auto rank = rank_of(listed.agent);
    if (!rank || *rank == self_) continue;
    Peer& peer = peers_[*rank];
    if (peer.listed_round == 0 || peer.listed_round != composed_round_) peer.met_round = request.round;
    peer.listed_round = request.round;
    targets.push_back({*rank, listed});
  }
  std::ranges::sort(targets, {}, &Target::rank);
  return targets;
}

/// Whether this agent should send a tile of `origin` to a peer that lacks it, in this sample.
bool ObstacleMap::is_due(const LogEntry& entry, std::size_t origin, const Target& to, const MapRequest& request,
                         std::span<const Target> targets) const {
  const Peer& peer = peers_[to.rank];
  // an answer that cannot know of the last sending says nothing
  if (entry.sent_round > 0 && peer.answered_round < entry.sent_round + 1 + request.latency_rounds) return false;
  if (origin == self_) return true;
  const std::size_t n = ids_.size();
  const auto turn = [&](std::size_t rank) { return (rank + n - origin) % n; };
  if (peer.answered_round == 0) return false;
  // a tile at the edge of a sensor changes with every look: it is passed on once it rests, but to one just met at once
  const bool rests = request.round - entry.known_round >= request.patience_rounds;
  const bool just_met = request.round - peer.met_round < request.patience_rounds;
  if (!rests && !just_met) return false;
  const std::uint32_t since = std::max(entry.touched_round(), peer.met_round);
  const std::uint32_t waited = request.round > since ? request.round - since : 0;
  std::uint32_t passes = waited / std::max(request.patience_rounds, 1U);  // those before this one who had their time
  const auto first = std::ranges::lower_bound(targets, origin, {}, &Target::rank);
  const auto start = static_cast<std::size_t>(first - targets.begin());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Target& other = targets[(start + i) % targets.size()];
    if (turn(other.rank) >= turn(self_)) break;
    if (other.rank == to.rank) continue;
    const bool holds = other.rank == origin || peers_[other.rank].holds[origin] >= entry.version;
    const bool reaches = (other.peer.at_m - to.peer.at_m).squaredNorm() <= request.range_m * request.range_m;
    if (!holds || !reaches) continue;
    if (passes == 0) return false;
    --passes;
  }
  return true;
}

std::vector<ObstacleMap::Candidate> ObstacleMap::lacked(const MapRequest& request, std::span<const Target> targets) {
  std::vector<Candidate> candidates;
  const double tile_m = kTileEdge * grid().cell_m;
  std::vector<const Target*> behind;
  for (std::size_t origin = 0; origin < logs_.size(); ++origin) {
    behind.clear();
    for (const Target& target : targets) {
      if (target.rank != origin && peers_[target.rank].holds[origin] < logs_[origin].newest())
        behind.push_back(&target);
    }
    if (behind.empty()) continue;
    for (LogEntry& entry : logs_[origin].entries()) {
      double nearest_m = std::numeric_limits<double>::infinity();
      for (const Target* target : behind) {
        if (peers_[target->rank].holds[origin] >= entry.version) continue;
        if (!is_due(entry, origin, *target, request, targets)) continue;
        const Vec3 centre_m = tiles_.centre_m(entry.tile);
        nearest_m = std::min(nearest_m, distance_m(centre_m, target->peer.at_m, target->peer.to_m));
      }
      if (!(nearest_m < std::numeric_limits<double>::infinity())) continue;
      const auto tiles_away = static_cast<std::int64_t>(std::floor(nearest_m / tile_m));
      const auto waited = static_cast<std::int64_t>(request.round) - entry.touched_round();
      candidates.push_back({2 * tiles_away - waited, origin, &entry});
    }
  }
  std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
    if (a.key != b.key) return a.key < b.key;
    const int a_cells = known_cells(a.entry->state.cells);
    const int b_cells = known_cells(b.entry->state.cells);
    if (a_cells != b_cells) return a_cells > b_cells;
    return a.rank != b.rank ? a.rank < b.rank : a.entry->tile < b.entry->tile;
  });
  return candidates;
}

/// Its own entry (alone it takes its turn), then those that changed since they were last told, then, in a quarter of
/// the room at least, all others in turn.
std::vector<Seen> ObstacleMap::tell_vector(std::size_t count) {
  const std::size_t n = ids_.size();
  std::vector<bool> is_told(n, false);
  std::size_t told = 0;
  const auto tell = [&](std::size_t rank) {
    is_told[rank] = true;
    ++told;
  };
  if (count > 1) tell(self_);
  const std::size_t changed = count - std::max(count / 4, std::min<std::size_t>(count, 1));
  for (std::size_t i = 0; i < n && told < changed; ++i) {
    const std::size_t rank = (next_told_ + i) % n;
    if (!is_told[rank] && seen_[rank] != told_[rank]) tell(rank);
  }
  for (std::size_t i = 0, start = next_told_; i < n && told < count; ++i) {
    const std::size_t rank = (start + i) % n;
    if (is_told[rank] || (seen_[rank] == 0 && rank != self_)) continue;
    tell(rank);
    next_told_ = (rank + 1) % n;
  }
  std::vector<Seen> vector;
  for (std::size_t rank = 0; rank < n; ++rank) {
    if (!is_told[rank]) continue;
    told_[rank] = seen_[rank];
    vector.push_back({ids_[rank], seen_[rank], logs_[rank].digest(seen_[rank])});
  }
  return vector;
}

/// All to a peer that was met not long ago, or is unheard; else some of those that changed, and of the others, in turn.
std::size_t ObstacleMap::entries_worth_telling(const MapRequest& request, std::span<const Target> targets) const {
  const bool anybody_new = std::ranges::any_of(targets, [&](const Target& to) {
    const Peer& peer = peers_[to.rank];
    return peer.answered_round == 0 || 2 * (request.round - peer.met_round) < request.patience_rounds;
  });
  if (anybody_new) return ids_.size();
  std::size_t changed = 0;
  for (std::size_t rank = 0; rank < seen_.size(); ++rank) changed += seen_[rank] != told_[rank] ? 1 : 0;
  return std::min(ids_.size(), changed + changed / 3 + 2);
}

std::optional<MapPart> ObstacleMap::compose(const MapRequest& request) {
  if (request.budget_bytes < payload_bytes(0, 0)) return std::nullopt;
  round_ = std::max(round_, request.round);
  const std::vector<Target> targets = targets_of(request);
  composed_round_ = request.round;
  std::vector<Candidate> candidates = lacked(request, targets);

  const std::size_t room = request.budget_bytes - payload_bytes(0, 0);
  const std::size_t wanted = std::min(candidates.size(), kMaxMapTiles);
  const std::size_t wanted_bytes = payload_bytes(wanted, 0) - payload_bytes(0, 0);
  const std::size_t vector_bytes = std::max(room / 2, room - std::min(room, wanted_bytes));
  MapPart part;
  const bool fresh = told_round_ > 0 && request.round - told_round_ < 2 * request.patience_rounds;
  part.idle = wanted == 0 && seen_ == told_ && !owes_answer_ && fresh;
  if (!part.idle) told_round_ = request.round;
  owes_answer_ = false;
  part.seen = tell_vector(std::min(entries_worth_telling(request, targets), vector_bytes / kSeenBytes));
  std::size_t fits = wanted;
  while (fits > 0 && payload_bytes(fits, part.seen.size()) > request.budget_bytes) --fits;
  for (std::size_t i = 0; i < fits; ++i) {
    LogEntry& entry = *candidates[i].entry;
    entry.sent_round = request.round;
    part.tiles.push_back({ids_[candidates[i].rank], entry.tile, entry.state.epoch, entry.version, entry.state.cells});
  }
  part.left = candidates.size() - fits;
  return part;
}

}  // namespace skein
