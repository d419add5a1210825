// From the bus over DDS into a recording.
//
// Who writes missions and ticks is the world; what else comes from its process (sense, what it repeats of an agent) is
// the world's too. Source: none. Departs from source: none. Complexity: O(bytes).
#pragma once

#include <array>
#include <set>
#include <utility>

#include "groundstation/record/gaps.hpp"
#include "groundstation/record/recording.hpp"
#include "groundstation/record/round_book.hpp"

namespace skein {

class BusRecorder {
 public:
  /// @param port outlives it
  BusRecorder(bus::DdsRecorderPort& port, TakeSample record) : port_(port), record_(std::move(record)) {}

  /// Records what has arrived. @return how many samples
  std::size_t take();

  [[nodiscard]] const RoundBook& rounds() const { return rounds_; }
  [[nodiscard]] const Gaps& gaps() const { return gaps_; }
  /// Up to where each writer was heard, as far as ticks tell.
  [[nodiscard]] const HeardEnds& ends() const { return ends_; }
  /// Whether a tick of any phase was heard.
  [[nodiscard]] bool heard_tick() const { return heard_tick_; }

 private:
  using Process = std::array<std::uint8_t, 12>;

  bus::DdsRecorderPort& port_;
  TakeSample record_;
  RoundBook rounds_;
  Gaps gaps_;
  HeardEnds ends_;
  std::set<Process> worlds_;
  bool heard_tick_ = false;
  std::vector<bus::RawSample> arrived_;
};

}  // namespace skein
