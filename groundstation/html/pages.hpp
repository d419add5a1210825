// The report of a run, or of a sweep, as one HTML page (docs/reports.md): verdict, figures, tables, seed, scenario,
// versions, and the commands that made it and would make it again.
//
// Source, Departs from source: none. Complexity: linear in what it shows.
#pragma once

#include <string>
#include <vector>

#include "groundstation/figure/input.hpp"

namespace skein::html {

/// A figure that was drawn.
struct Drawing {
  std::string name;
  std::string svg;  ///< as gnuplot wrote it
  std::string caption;
};

/// What is on a page besides its input.
struct Drawn {
  std::vector<Drawing> drawings;
  std::vector<std::string> undrawn;  ///< "torsion: all is in one plane"
  std::string version;               ///< of the program that wrote the page
  std::string command;               ///< that wrote it
};

[[nodiscard]] std::string page_of(const figure::RunInput& input, const Drawn& drawn);
[[nodiscard]] std::string page_of(const figure::SweepInput& input, const Drawn& drawn);

/// The command that runs it again in process, with the same losses; empty if its scenario is not known.
[[nodiscard]] std::string rerun_command(const figure::RunInput& input);

}  // namespace skein::html
