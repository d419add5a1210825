#include "planner/core/radio/radio_budget.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace skein {
namespace {

constexpr double kRounding = 1e-9;      ///< of decisions per frame: decision_s and send_period_s are decimal numbers
constexpr double kMostBytes = 1048576;  ///< over what any sample holds

}  // namespace

RadioShare share_of(const Mission& mission, std::size_t rank) {
  RadioShare share;
  share.decision_s = mission.transit->planner.decision_s;
  share.rank = static_cast<std::uint32_t>(rank);
  share.count = static_cast<std::uint32_t>(mission.vehicles.size());
  return share;
}

RadioBudget::RadioBudget(const RadioOptions& options, const RadioShare& share)
    : options_(options),
      share_(share),
      slot_bits_(std::floor(options.bit_rate_bps * options.send_period_s / std::max(share.count, 1U))) {
  if (!(share.decision_s > 0.0) || share.rank >= share.count) {
    throw std::invalid_argument("a radio budget needs a time between decisions over 0, and a rank under the count");
  }
}

double RadioBudget::bits_of(std::size_t payload_bytes) const {
  return options_.header_bits + 8.0 * static_cast<double>(payload_bytes);
}

std::uint64_t RadioBudget::frame_index(std::uint32_t decision) const {
  return static_cast<std::uint64_t>(
      std::floor((decision - 1.0) * share_.decision_s / options_.send_period_s + kRounding));
}

std::uint32_t RadioBudget::decisions_per_frame() const {
  return static_cast<std::uint32_t>(std::max(1.0, std::ceil(options_.send_period_s / share_.decision_s - kRounding)));
}

RadioBudget::Frame RadioBudget::frame_of(std::uint32_t decision) const {
  Frame frame{frame_index(decision), decision, 1};
  while (frame.first > 1 && frame_index(frame.first - 1) == frame.index) --frame.first;
  frame.count = decision - frame.first + 1;
  while (frame_index(frame.first + frame.count) == frame.index) ++frame.count;
  return frame;
}

Allowance RadioBudget::at(std::uint32_t decision) const {
  const Frame frame = frame_of(decision);
  const std::uint32_t slot =
      frame.first + static_cast<std::uint32_t>(std::uint64_t{share_.rank} * frame.count / share_.count);
  const double used = frame.index == frame_ ? used_bits_ : 0.0;
  const std::uint32_t later = frame.first + frame.count - 1 - decision;
  const double reserved = later * bits_of(share_.control_bytes);
  const double bits = slot_bits_ - used - reserved - options_.header_bits;
  const double bytes = std::clamp(std::floor(bits / 8.0), 0.0, kMostBytes);
  const auto most = static_cast<std::size_t>(bytes);
  if (most < share_.control_bytes) return {};
  if (decision != slot) return {false, share_.control_bytes};
  return {true, most};
}

void RadioBudget::sent(std::uint32_t decision, std::size_t payload_bytes) {
  if (payload_bytes > at(decision).payload_bytes) {
    throw std::invalid_argument("a sample of " + std::to_string(payload_bytes) + " bytes is over the radio's budget");
  }
  const std::uint64_t index = frame_index(decision);
  if (index != frame_) used_bits_ = 0.0;
  frame_ = index;
  used_bits_ += bits_of(payload_bytes);
  peak_bits_ = std::max(peak_bits_, used_bits_);
}

void RadioBudget::add_to(StateHash& hash) const {
  hash.add(frame_).add(used_bits_).add(peak_bits_).add(silent_);
}

}  // namespace skein
