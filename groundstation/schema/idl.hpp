// Types from the text of an IDL file: enough of OMG IDL to name and decode the fields of every sample of the bus.
//
// Modules, structs, annotations (read over), the basic types, strings, bounded sequences and arrays of one dimension.
// A recording carries its IDL, so that its fields can be named by whoever reads it.
// Source: OMG IDL 4.2. Departs from source: no enums, unions, typedefs, constants or nested sequences.
// Complexity: linear in the text.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace skein::schema {

enum class Basic : std::uint8_t {
  Boolean,
  Octet,
  Char,
  Short,
  UShort,
  Long,
  ULong,
  LongLong,
  ULongLong,
  Float,
  Double,
  String,
  Struct,
};

enum class Shape : std::uint8_t { One, Sequence, Array };

struct Struct;

struct Field {
  std::string name;
  Basic basic = Basic::Octet;  ///< of one item
  Shape shape = Shape::One;
  std::uint32_t length = 0;                      ///< of an array; bound of a sequence, 0: none
  std::shared_ptr<const Struct> type = nullptr;  ///< of Basic::Struct; shared by all fields of that type
};

struct Struct {
  std::string name;  ///< with its modules: a::b::C
  std::vector<Field> fields;
};

/// The struct called `name` (with its modules). @throws std::invalid_argument with line and what is wrong
[[nodiscard]] Struct parse_idl(std::string_view text, std::string_view name);

}  // namespace skein::schema
