// Any bytes as a round of a world's journal: refused, or exactly those that the round is written as.
#include <cstddef>
#include <cstdint>
#include <span>

#include "simworld/checkpoint/round_record.hpp"
#include "tests/fuzz/require.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  const auto inputs = skein::round_inputs_from(bytes, skein::WireContext{});
  if (!inputs) return 0;
  const skein::Bytes written = skein::to_bytes(*inputs);
  skein::require(skein::round_inputs_from(written, skein::WireContext{}).has_value(), "what was read can be written");
  return 0;
}
