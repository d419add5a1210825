// Draws what can be drawn of an input and writes its page: for the verbs report and sweep.
#pragma once

#include <string>

#include "groundstation/figure/input.hpp"

namespace skein {

/// @param command that is said to have written the page
/// @throws figure::NoGnuplot; std::runtime_error with one line if nothing can be drawn or the file cannot be written
void write_report(const figure::Input& input, const std::string& path, const std::string& command);

/// Whether there will be a page: before something long is done for it. Empties the file. @throws as write_report()
void check_report(const std::string& path);

/// A whole file. @throws std::runtime_error with one line
void write_whole(const std::string& path, const std::string& bytes);

}  // namespace skein
