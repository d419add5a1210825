#include "groundstation/cli/write_report.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "groundstation/figure/figures.hpp"
#include "groundstation/figure/gnuplot.hpp"
#include "groundstation/html/pages.hpp"
#include "simworld/report/report.hpp"

namespace skein {

void write_whole(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  file.close();
  if (!file) throw std::runtime_error(fmt::format("cannot write {}: {}", path, std::strerror(errno)));
}

void check_report(const std::string& path) {
  write_whole(path, "");
  (void)figure::draw("set terminal svg\nplot 0\n");
}

void write_report(const figure::Input& input, const std::string& path, const std::string& command) {
  html::Drawn drawn{{}, {}, std::string(version()), command};
  const bool sweep = std::holds_alternative<figure::SweepInput>(input);
  for (const std::string_view name : figure::kFigureNames) {
    const auto kind = *figure::figure_from(name);
    if (sweep != (kind == figure::FigureKind::Box)) continue;
    const figure::Sketched sketched = figure::sketch(kind, input);
    if (const auto* none = std::get_if<figure::NoSketch>(&sketched)) {
      drawn.undrawn.push_back(fmt::format("{}: {}", name, none->reason));
      continue;
    }
    const auto& figure = std::get<figure::Sketch>(sketched);
    drawn.drawings.push_back(
        {std::string(name), figure::draw(figure::script_of(figure, figure::Format::Svg)), figure.caption});
  }
  write_whole(path, std::visit([&](const auto& of) { return html::page_of(of, drawn); }, input));
}

}  // namespace skein
