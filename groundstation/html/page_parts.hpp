// Parts that the pages of runs and sweeps share.
#pragma once

#include "groundstation/html/page.hpp"
#include "groundstation/html/pages.hpp"

namespace skein::html {

/// The figures, and why others are not there.
void add_figures(Page& page, const Drawn& drawn);
/// The text of a scenario, or that it is not known.
void add_scenario(Page& page, const std::string& text);
/// "sent_samples" -> "sent samples"
[[nodiscard]] std::string words_of(std::string name);
/// The command that runs it, with neither carrier nor folder; empty if its scenario is not known.
[[nodiscard]] std::string run_command(const figure::RunInput& input);

}  // namespace skein::html
