// The fields of a sample, by name, from its bytes and its type.
//
// CDR bytes with their 4 bytes of encapsulation, of either byte order; numbers stand aligned to their own size, from
// the end of the encapsulation. 64-bit integers become decimal texts, as in the JSON of protobuf: a reader that holds
// numbers as doubles would change them. Numbers that are not finite become the texts "nan", "inf" and "-inf".
// Source: OMG CDR (XCDR1, plain). Departs from source: none. Complexity: linear in the bytes.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "groundstation/schema/idl.hpp"

namespace skein::schema {

using Json = nlohmann::ordered_json;

/// An object with the fields of `type`; nothing if the bytes are no such sample.
[[nodiscard]] std::optional<Json> decode(const Struct& type, std::span<const std::uint8_t> payload);

/// As far as the bytes are such a sample: the field at which they stop being one is null, and the last; null if their
/// encapsulation is none.
[[nodiscard]] Json decode_partly(const Struct& type, std::span<const std::uint8_t> payload);

/// Where two values differ first, and both values there.
struct Difference {
  std::string field;  ///< "roster[2].incarnation"
  Json a, b;          ///< null: it is not there
};

/// In the order of the fields; nothing if they are equal.
[[nodiscard]] std::optional<Difference> first_difference(const Json& a, const Json& b);

/// The field of `partial` that is null, with its value in `a`; nothing if there is none.
[[nodiscard]] std::optional<Difference> first_null(const Json& a, const Json& partial);

}  // namespace skein::schema
