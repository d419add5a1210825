// Draws what can be drawn of an input and writes its page: for the verbs report and sweep.
#pragma once

#include <string>
#include <vector>

#include "groundstation/figure/input.hpp"

namespace skein {

/// @param command that is said to have written the page
/// @throws figure::NoGnuplot; std::runtime_error with one line if nothing can be drawn or the file cannot be written
void write_report(const figure::Input& input, const std::string& path, const std::string& command);

/// Whether something can be drawn at all: before something long is done for it. @throws as write_report()
void check_gnuplot();

/// The files that figure::read_input() reads of a FILE or DIR.
[[nodiscard]] std::vector<std::string> input_files(const std::string& path);

}  // namespace skein
