// gnuplot as a child process: a text goes in, a picture comes out.
//
// The text is its standard input, the picture its standard output; all three streams are files in memory, so that no
// pipe can fill. It reads no start-up file, and is killed at the deadline, and when this process ends.
// Source: gnuplot(1), memfd_create(2), pidfd_open(2). Departs from source: none. Complexity: that of the figure.
#pragma once

#include <stdexcept>
#include <string>

namespace skein::figure {

/// There is no gnuplot here; what() is one line that names the package.
struct NoGnuplot : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr double kGnuplotDeadline_s = 60.0;

/// The picture that the script draws. @param program looked up in PATH
/// @throws NoGnuplot; std::runtime_error with one line if it fails, draws nothing, or takes longer than the deadline
[[nodiscard]] std::string draw(const std::string& script, double deadline_s = kGnuplotDeadline_s,
                               const std::string& program = "gnuplot");

}  // namespace skein::figure
