// How many bytes a UAV may put on air in a decision, so that it never exceeds its share of the channel.
//
// N UAVs share a half-duplex channel in frames of T = send_period_s. In each frame each has one slot of T / N, hence
//   header_bits * samples + 8 * bytes <= bit_rate * T / N   of every UAV, in every frame.
// Every decision it sends a sample with a control part; in one decision of the frame, given by its rank, a map as well.
// What the control parts of the rest of the frame need is set aside. Where not even a control part fits, it is silent.
// With send_period_s shorter than a decision, a decision has the frame that it falls into, and the frames between are
// idle. Source: papers/004, section IV-B2 and appendix. Departs from source: control parts. Complexity: O(1).
#pragma once

#include <cstdint>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/lockstep/map_sample.hpp"
#include "planner/core/options/transit_options.hpp"

namespace skein {

struct RadioShare {
  double decision_s = 1.0;                    ///< between two decisions
  std::uint32_t rank = 0;                     ///< of the UAV among all, by ascending id, from 0
  std::uint32_t count = 1;                    ///< of UAVs
  std::size_t control_bytes = kControlBytes;  ///< CDR bytes of a sample without map
};

/// The share of the vehicle at that rank, from 0. @pre mission.transit
[[nodiscard]] RadioShare share_of(const Mission& mission, std::size_t rank);

/// What a sample may hold.
struct Allowance {
  bool map_slot = false;          ///< it may hold a part of the map
  std::size_t payload_bytes = 0;  ///< CDR bytes in all; 0: nothing may be sent
};

class RadioBudget {
 public:
  /// @throws std::invalid_argument if decision_s is not over 0 or rank not under count
  RadioBudget(const RadioOptions& options, const RadioShare& share);

  /// Of the sample of a decision. @param decision from 1, not before the last one that was sent
  [[nodiscard]] Allowance at(std::uint32_t decision) const;
  /// A sample was sent, of that many CDR bytes. @throws std::invalid_argument if that is over what at() allows
  void sent(std::uint32_t decision, std::size_t payload_bytes);
  /// Nothing was sent, because nothing fits.
  void silent() { ++silent_; }

  /// Bits that this UAV may send in a frame.
  [[nodiscard]] double slot_bits() const { return slot_bits_; }
  /// The most that it sent in one so far.
  [[nodiscard]] double peak_bits() const { return peak_bits_; }
  [[nodiscard]] std::uint64_t silences() const { return silent_; }
  /// Decisions from the slot of one map to that of the next, 1 or more.
  [[nodiscard]] std::uint32_t decisions_per_frame() const;
  void add_to(StateHash& hash) const;

 private:
  struct Frame {
    std::uint64_t index = 0;
    std::uint32_t first = 1;  ///< decision
    std::uint32_t count = 1;  ///< of decisions in it
  };
  [[nodiscard]] std::uint64_t frame_index(std::uint32_t decision) const;
  [[nodiscard]] Frame frame_of(std::uint32_t decision) const;
  [[nodiscard]] double bits_of(std::size_t payload_bytes) const;

  RadioOptions options_;
  RadioShare share_;
  double slot_bits_;
  std::uint64_t frame_ = 0;  ///< in which `used_bits_` were sent
  double used_bits_ = 0.0;
  double peak_bits_ = 0.0;
  std::uint64_t silent_ = 0;
};

}  // namespace skein
