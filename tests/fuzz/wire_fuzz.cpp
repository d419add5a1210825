// Any bytes that arrive under a topic: no sample, or a refused one, or one that goes out and comes back unchanged.
//
// The first byte chooses the topic, the rest are the bytes of CDR.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "idl/convert/cdr.hpp"
#include "idl/convert/convert.hpp"
#include "tests/fuzz/require.hpp"

namespace skein {
namespace {

template <typename Wire>
void receive(std::span<const std::uint8_t> bytes) {
  const std::optional<Wire> sample = from_cdr<Wire>(bytes);
  if (!sample) return;
  const auto value = from_wire(*sample, WireContext{});
  if (!value.ok()) return;
  const Bytes sent = to_cdr(to_wire(value.value(), Stamp{}));
  const std::optional<Wire> heard = from_cdr<Wire>(sent);
  require(heard.has_value(), "what was accepted can be sent");
  const auto again = from_wire(*heard, WireContext{});
  require(again.ok(), "what was accepted is accepted again");
  require(to_cdr(to_wire(again.value(), Stamp{})) == sent, "what was accepted comes back unchanged");
}

constexpr std::array kReceivers{receive<wire::Mission>, receive<wire::Tick>,           receive<wire::Sense>,
                                receive<wire::Beacon>,  receive<wire::Representative>, receive<wire::ObstacleMap>,
                                receive<wire::Command>, receive<wire::Inject>};

}  // namespace
}  // namespace skein

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::span<const std::uint8_t> bytes(data, size);
  skein::kReceivers[bytes[0] % skein::kReceivers.size()](bytes.subspan(1));
  return 0;
}
