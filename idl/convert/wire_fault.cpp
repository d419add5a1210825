#include "idl/convert/wire_fault.hpp"

namespace skein {
namespace {

constexpr std::array<std::string_view, kWireFaultReasons> kNames{
    "non_finite",   "out_of_range", "unknown_agent", "wrong_run",   "wrong_incarnation",
    "wrong_sender", "bad_enum",     "bad_order",     "bad_mission", "bad_options"};

}  // namespace

std::string_view name_of(WireFaultReason reason) {
  const auto index = static_cast<std::size_t>(reason);
  return index < kNames.size() ? kNames[index] : std::string_view("unknown");
}

std::uint64_t FaultCounts::total() const {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : counts_) sum += count;
  return sum;
}

}  // namespace skein
