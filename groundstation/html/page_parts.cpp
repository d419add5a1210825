#include "groundstation/html/page_parts.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace skein::html {

void add_figures(Page& page, const Drawn& drawn) {
  page.heading("Pictures");
  for (const Drawing& drawing : drawn.drawings) {
    page.figure(inline_svg(drawing.svg, drawing.name + "-", drawing.caption), drawing.caption);
  }
  for (const std::string& line : drawn.undrawn) page.paragraph("Not drawn: " + line + ".");
}

void add_scenario(Page& page, const std::string& text) {
  page.heading("Scenario");
  if (text.empty()) {
    page.paragraph("The scenario is not known.");
  } else {
    page.preformatted(text);
  }
}

std::string words_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

}  // namespace skein::html
