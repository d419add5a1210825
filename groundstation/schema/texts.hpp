// The project's own IDL, embedded when it was built: what a recording carries as its schemas.
//
// Source: idl/msg/*.idl. Departs from source: what a file includes stands in its place.
#pragma once

#include <string_view>

namespace skein::schema {

/// Of "tick", "beacon", ...: the name of its file in idl/msg. Empty for any other.
[[nodiscard]] std::string_view idl_text(std::string_view sample);

}  // namespace skein::schema
