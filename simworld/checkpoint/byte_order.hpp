// Numbers as little-endian bytes, whatever the machine's own order.
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

#include "idl/convert/cdr.hpp"

namespace skein {

template <typename Number>
requires std::is_unsigned_v<Number>
void put_number(Bytes& into, Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i) into.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

/// @pre `bytes` holds at least sizeof(Number)
template <typename Number>
requires std::is_unsigned_v<Number>
[[nodiscard]] Number read_number(std::span<const std::uint8_t> bytes) {
  Number number = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    number = static_cast<Number>(number | (static_cast<Number>(bytes[i]) << (8 * i)));
  }
  return number;
}

}  // namespace skein
