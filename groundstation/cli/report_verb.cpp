// skein report FILE|DIR: one self-contained HTML page of a run or a sweep.
#include <fmt/core.h>

#include <iostream>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/cli/write_report.hpp"
#include "groundstation/figure/gnuplot.hpp"
#include "groundstation/html/page.hpp"
#include "groundstation/output/output_file.hpp"

namespace skein {
namespace {

constexpr int kBad = 2;
constexpr int kNoProgram = 3;

struct ReportArguments {
  std::string file;
  std::string out = "report.html";
  bool json = false;
};

int report(const ReportArguments& arguments) {
  try {
    check_output(arguments.out, input_files(arguments.file));
    const figure::Input input = figure::read_input(arguments.file);
    const auto notes = std::visit([](const auto& of) { return of.notes; }, input);
    for (const std::string& note : notes) std::cerr << fmt::format("{}: {}\n", arguments.file, note);
    write_report(
        input, arguments.out,
        fmt::format("skein report {} -o {}", html::shell_word(arguments.file), html::shell_word(arguments.out)));
    if (arguments.json) {
      std::cout << figure::Json{{"file", arguments.out}, {"notes", notes}}.dump(2) << "\n";
    } else {
      std::cout << arguments.out << "\n";
    }
    if (std::cout.flush()) return 0;
    throw std::runtime_error("cannot write to standard output");
  } catch (const figure::NoGnuplot& error) {
    std::cerr << "skein report: " << error.what() << "\n";
    return kNoProgram;
  } catch (const std::exception& error) {
    std::cerr << "skein report: " << error.what() << "\n";
    return kBad;
  }
}

}  // namespace

VerbAction add_report_verb(CLI::App& app) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* verb = app.add_subcommand("report", "write one HTML page of a recording, a run's folder or a sweep's JSON");
  verb->add_option("FILE", arguments->file, "recording, folder of a run, or JSON of a sweep")->required();
  verb->add_option("-o,--output", arguments->out, "the page")->capture_default_str();
  verb->add_flag("--json", arguments->json, "print the name of the page as JSON");
  verb->footer(
      "Exit code 0; 2: a bad file; 3: there is no gnuplot (Debian: gnuplot-nox).\n"
      "Example: skein report run.mcap -o report.html");
  return [arguments] { return report(*arguments); };
}

}  // namespace skein
