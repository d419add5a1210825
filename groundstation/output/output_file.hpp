// Files that verbs write for people: checked before anything long is done, and never left half written.
//
// A file is written under another name beside its own and then renamed, so what was there before stays whole until what
// replaces it is. What is no regular file (/dev/stdout, a pipe) is written as it is. Source: rename(2). Departs from
// source: none. Complexity: O(bytes).
#pragma once

#include <string>
#include <vector>

namespace skein {

/// Whether it can be written; it is left as it is. @param others what the same command reads or writes: it must be none
/// of these; empty names are none @throws std::runtime_error "cannot write PATH: WHY"
void check_output(const std::string& path, const std::vector<std::string>& others);

/// @throws std::runtime_error "cannot write PATH: WHY"; then what was there still is
void write_output(const std::string& path, const std::string& bytes);

}  // namespace skein
