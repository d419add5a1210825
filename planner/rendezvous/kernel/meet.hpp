// Separation from peers (Eq. 17), in lanes: over candidates for distances, over peers for leaving peers out.
//
// At each number k all candidates lie in a box. A peer whose point k is beyond the box by its separation or more along
// an axis comes near none of them: subtraction, squares and sums round monotonically, so every computed distance would
// be at least the separation too, and leaving the peer out changes no result.
//
// Source: papers/001, Eq. 15 and 17. Departs from source: none.
// Complexity: O(points (lanes + peers)), and O(lanes) for each point of a peer near the box.
#pragma once

#include "planner/rendezvous/kernel/kernel.hpp"
#include "planner/rendezvous/kernel/lanes.hpp"

namespace skein::rendezvous::kernel {
namespace {

struct Range {
  double low;
  double high;
};

template <typename Lanes>
Range range_of(const double* row, std::size_t lanes) {
  using Pack = typename Lanes::Pack;
  Pack low = Lanes::load(row);
  Pack high = low;
  for (std::size_t l = Lanes::kWidth; l < lanes; l += Lanes::kWidth) {
    const Pack here = Lanes::load(row + l);
    low = Lanes::least(low, here);
    high = Lanes::most(high, here);
  }
  double lows[Lanes::kWidth];
  double highs[Lanes::kWidth];
  Lanes::store(lows, low);
  Lanes::store(highs, high);
  Range range{lows[0], highs[0]};
  for (std::size_t i = 1; i < Lanes::kWidth; ++i) {
    range.low = LanesOf<1>::least(range.low, lows[i]);
    range.high = LanesOf<1>::most(range.high, highs[i]);
  }
  return range;
}

/// Point number k: of all candidates, and of all peers, axis by axis.
template <std::size_t Dimensions>
struct Place {
  const double* own[Dimensions];
  const double* peers[Dimensions];
};

/// Marks the lanes that are nearer than the separation to a peer's point.
template <std::size_t Dimensions, typename Lanes>
void mark_near(const Place<Dimensions>& at, std::size_t lanes, std::size_t peer, double separation, double* collided) {
  using Pack = typename Lanes::Pack;
  const double least_squared = separation * separation;
  for (std::size_t l = 0; l < lanes; l += Lanes::kWidth) {
    Pack squared = Lanes::all(0.0);
    for (std::size_t axis = 0; axis < Dimensions; ++axis) {
      const Pack apart = Lanes::load(at.own[axis] + l) - at.peers[axis][peer];
      squared = squared + apart * apart;
    }
    const auto near = squared < least_squared;
    if (Lanes::any(near)) Lanes::store(collided + l, near ? Lanes::all(1.0) : Lanes::load(collided + l));
  }
}

template <std::size_t Dimensions, typename Lanes>
void meet(ConstTable points_m, std::size_t points, std::size_t lanes, const Peers& peers, double* collided) {
  using Pack = typename Lanes::Pack;
  for (std::size_t l = 0; l < lanes; l += Lanes::kWidth) Lanes::store(collided + l, Lanes::all(0.0));
  for (std::size_t k = 0; k < points; ++k) {
    Place<Dimensions> at;
    Range box[Dimensions];
    for (std::size_t axis = 0; axis < Dimensions; ++axis) {
      at.own[axis] = points_m.data + (axis * points + k) * points_m.stride;
      at.peers[axis] = peers.points_m.data + (axis * points + k) * peers.points_m.stride;
      box[axis] = range_of<Lanes>(at.own[axis], lanes);
    }
    for (std::size_t p = 0; p < peers.count; p += Lanes::kWidth) {
      const Pack separation = Lanes::load(peers.separation_m + p);
      const auto reaches = [&](std::size_t axis) {
        const Pack peer = Lanes::load(at.peers[axis] + p);
        return Lanes::most(box[axis].low - peer, peer - box[axis].high) < separation;
      };
      auto near = reaches(0) & reaches(1);
      if constexpr (Dimensions == 3) near = near & reaches(2);
      for (unsigned left = Lanes::bits(near); left != 0; left &= left - 1) {
        const std::size_t peer = p + static_cast<std::size_t>(__builtin_ctz(left));
        mark_near<Dimensions, Lanes>(at, lanes, peer, peers.separation_m[peer], collided);
      }
    }
  }
}

}  // namespace
}  // namespace skein::rendezvous::kernel
