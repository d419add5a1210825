// Any bytes as a round of a world's journal: refused, or a round that is written and comes back unchanged.
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
  const auto again = skein::round_inputs_from(written, skein::WireContext{});
  skein::require(again.has_value(), "what was read can be written");
  skein::require(skein::to_bytes(*again) == written, "what was written comes back unchanged");
  return 0;
}
