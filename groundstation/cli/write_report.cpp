#include "groundstation/cli/write_report.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "groundstation/figure/figures.hpp"
#include "groundstation/figure/gnuplot.hpp"
#include "groundstation/html/pages.hpp"
#include "groundstation/output/output_file.hpp"
#include "simworld/report/report.hpp"

namespace skein {

std::vector<std::string> input_files(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path folder = fs::is_directory(path, ignored) ? fs::path(path) : fs::path(path).parent_path();
  return {path, (folder / "report.json").string(), (folder / "scenario.yaml").string()};
}

void check_gnuplot() {
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
  write_output(path, std::visit([&](const auto& of) { return html::page_of(of, drawn); }, input));
}

}  // namespace skein
