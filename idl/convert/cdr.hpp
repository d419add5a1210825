// Wire structs as the bytes that DDS carries, for files: little endian, with the 4 bytes of encapsulation.
//
// Source: OMG CDR, as Fast CDR writes it. Departs from source: none. Complexity: linear in the sample.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "idl/wire.hpp"

namespace skein {

using Bytes = std::vector<std::uint8_t>;

/// Of any sample of the protocol (wire::Sample).
template <typename Wire>
[[nodiscard]] Bytes to_cdr(const Wire& sample);

/// Nothing if the bytes are no sample of this type. What it says is not checked: that is from_wire's part.
template <typename Wire>
[[nodiscard]] std::optional<Wire> from_cdr(std::span<const std::uint8_t> bytes);

}  // namespace skein
