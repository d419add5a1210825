// UTF-8 in texts that people and other programs gave: where a character ends, and what to do with bytes that are none.
//
// JSON and XML hold no byte that is not UTF-8, so texts from outside are checked where they enter.
// Source: RFC 3629. Departs from source: none. Complexity: linear.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace skein {

/// Bytes of the first character; 0 if the text does not begin with one. @pre text is not empty
[[nodiscard]] std::size_t utf8_size(std::string_view text);

[[nodiscard]] bool is_utf8(std::string_view text);

/// For a message: bytes that are no UTF-8 and control characters become '?', and of a text of more than `most` bytes
/// the beginning and the end are left, with " ... " between them. @pre most >= 16
[[nodiscard]] std::string one_line(std::string_view text, std::size_t most = 400);

}  // namespace skein
