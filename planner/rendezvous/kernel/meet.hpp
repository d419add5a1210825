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

/// Marks the lanes that are nearer than the separation to a peer's point (x, y).
template <typename Lanes>
void mark_near(const double* x_row, const double* y_row, std::size_t lanes, double x, double y, double separation,
               double* collided) {
  using Pack = typename Lanes::Pack;
  const double least_squared = separation * separation;
  for (std::size_t l = 0; l < lanes; l += Lanes::kWidth) {
    const Pack dx = Lanes::load(x_row + l) - x;
    const Pack dy = Lanes::load(y_row + l) - y;
    const auto near = dx * dx + dy * dy < least_squared;
    if (Lanes::any(near)) Lanes::store(collided + l, near ? Lanes::all(1.0) : Lanes::load(collided + l));
  }
}

template <typename Lanes>
void meet(ConstTable x_m, ConstTable y_m, std::size_t points, std::size_t lanes, const Peers& peers, double* collided) {
  using Pack = typename Lanes::Pack;
  for (std::size_t l = 0; l < lanes; l += Lanes::kWidth) Lanes::store(collided + l, Lanes::all(0.0));
  for (std::size_t k = 0; k < points; ++k) {
    const double* x_row = x_m.data + k * x_m.stride;
    const double* y_row = y_m.data + k * y_m.stride;
    const double* peer_x = peers.x_m.data + k * peers.x_m.stride;
    const double* peer_y = peers.y_m.data + k * peers.y_m.stride;
    const Range xs = range_of<Lanes>(x_row, lanes);
    const Range ys = range_of<Lanes>(y_row, lanes);
    for (std::size_t p = 0; p < peers.count; p += Lanes::kWidth) {
      const Pack x = Lanes::load(peer_x + p);
      const Pack y = Lanes::load(peer_y + p);
      const Pack separation = Lanes::load(peers.separation_m + p);
      const auto near =
          (Lanes::most(xs.low - x, x - xs.high) < separation) & (Lanes::most(ys.low - y, y - ys.high) < separation);
      for (unsigned left = Lanes::bits(near); left != 0; left &= left - 1) {
        const std::size_t peer = p + static_cast<std::size_t>(__builtin_ctz(left));
        mark_near<Lanes>(x_row, y_row, lanes, peer_x[peer], peer_y[peer], peers.separation_m[peer], collided);
      }
    }
  }
}

}  // namespace
}  // namespace skein::rendezvous::kernel
