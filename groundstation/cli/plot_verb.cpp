// skein plot FILE: pictures of a run or a sweep, drawn by gnuplot.
#include <fmt/core.h>

#include <filesystem>
#include <iostream>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/cli/write_report.hpp"
#include "groundstation/figure/figures.hpp"
#include "groundstation/figure/gnuplot.hpp"
#include "groundstation/output/output_file.hpp"

namespace skein {
namespace {

using figure::Sketch;

constexpr int kBad = 2;
constexpr int kNoProgram = 3;

struct PlotArguments {
  std::string file;
  std::string figure = "all";
  std::string format;  ///< empty: as the ending of `out` says, else svg
  std::string value;
  std::string out;
  bool json = false;
};

/// @throws std::runtime_error if the ending of the one file to be drawn contradicts it
figure::Format format_of(const PlotArguments& arguments) {
  std::string ending = arguments.figure == "all" ? "" : std::filesystem::path(arguments.out).extension().string();
  if (ending != ".svg" && ending != ".png") ending.clear();
  if (!arguments.format.empty() && !ending.empty() && ending.substr(1) != arguments.format) {
    throw std::runtime_error(fmt::format("--format {} contradicts the name {}", arguments.format, arguments.out));
  }
  return arguments.format == "png" || ending == ".png" ? figure::Format::Png : figure::Format::Svg;
}

std::string folder_for(const std::string& out) {
  std::string folder = out.empty() ? "." : out;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(fmt::format("cannot make {}: {}", folder, error.message()));
  return folder;
}

/// All that can be drawn, by name of its file. @throws std::runtime_error if nothing can
std::vector<std::pair<std::string, Sketch>> sketches_of(const PlotArguments& arguments, const figure::Input& input,
                                                        figure::Format format) {
  std::vector<std::pair<std::string, Sketch>> sketches;
  std::string reasons;
  const bool all = arguments.figure == "all";
  const std::string folder = all ? folder_for(arguments.out) : "";
  for (const std::string_view name : figure::kFigureNames) {
    if (!all && name != arguments.figure) continue;
    figure::Sketched sketched = figure::sketch(*figure::figure_from(name), input, arguments.value);
    if (const auto* none = std::get_if<figure::NoSketch>(&sketched)) {
      reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", name, none->reason);
      continue;
    }
    const std::string own = fmt::format("{}.{}", name, format == figure::Format::Png ? "png" : "svg");
    const std::string path = all ? folder + "/" + own : arguments.out.empty() ? own : arguments.out;
    sketches.emplace_back(path, std::get<Sketch>(std::move(sketched)));
  }
  if (sketches.empty()) throw std::runtime_error(fmt::format("{}: nothing can be drawn: {}", arguments.file, reasons));
  return sketches;
}

const std::vector<std::string>& notes_of(const figure::Input& input) {
  return std::visit([](const auto& of) -> const std::vector<std::string>& { return of.notes; }, input);
}

int plot(const PlotArguments& arguments) {
  try {
    const auto format = format_of(arguments);
    const figure::Input input = figure::read_input(arguments.file);
    for (const std::string& note : notes_of(input)) std::cerr << fmt::format("{}: {}\n", arguments.file, note);
    figure::Json files = figure::Json::array();
    const auto sketches = sketches_of(arguments, input, format);
    for (const auto& [path, sketch] : sketches) check_output(path, input_files(arguments.file));
    for (const auto& [path, sketch] : sketches) {
      write_output(path, figure::draw(figure::script_of(sketch, format)));
      files.push_back({{"file", path}, {"caption", sketch.caption}});
      if (!arguments.json) std::cout << path << "\n";
    }
    if (arguments.json) std::cout << figure::Json{{"figures", files}, {"notes", notes_of(input)}}.dump(2) << "\n";
    if (std::cout.flush()) return 0;
    throw std::runtime_error("cannot write to standard output");
  } catch (const figure::NoGnuplot& error) {
    std::cerr << "skein plot: " << error.what() << "\n";
    return kNoProgram;
  } catch (const std::exception& error) {
    std::cerr << "skein plot: " << error.what() << "\n";
    return kBad;
  }
}

}  // namespace

VerbAction add_plot_verb(CLI::App& app) {
  auto arguments = std::make_shared<PlotArguments>();
  CLI::App* verb = app.add_subcommand("plot", "draw figures of a recording, a run's folder or a sweep's JSON");
  std::vector<std::string> names(figure::kFigureNames.begin(), figure::kFigureNames.end());
  names.emplace_back("all");
  verb->add_option("FILE", arguments->file, "recording, folder of a run, or JSON of a sweep")->required();
  verb->add_option("--figure", arguments->figure, "which one")->check(CLI::IsMember(names))->capture_default_str();
  verb->add_option("--format", arguments->format, "svg or png; by default as the name ends, else svg")
      ->check(CLI::IsMember({"svg", "png"}));
  verb->add_option("--value", arguments->value, "of a box figure: one of the sweep's figures, such as steps");
  verb->add_option("-o,--output", arguments->out, "the file; of all figures the folder (here)");
  verb->add_flag("--json", arguments->json, "print the names of the files as JSON");
  verb->footer(
      "Exit code 0; 2: a bad file, or nothing can be drawn; 3: there is no gnuplot (Debian: gnuplot-nox).\n"
      "Example: skein plot run.mcap --figure paths -o paths.png");
  return [arguments] { return plot(*arguments); };
}

}  // namespace skein
