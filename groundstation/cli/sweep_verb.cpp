// skein sweep SCENARIO: many runs, a table of their figures.
#include <fmt/core.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <thread>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/cli/write_report.hpp"
#include "groundstation/figure/gnuplot.hpp"
#include "groundstation/html/page.hpp"
#include "groundstation/output/output_file.hpp"
#include "groundstation/sweep/curves.hpp"
#include "groundstation/sweep/journal.hpp"
#include "groundstation/sweep/junit.hpp"
#include "groundstation/sweep/progress.hpp"
#include "groundstation/sweep/sweep.hpp"
#include "groundstation/sweep/table.hpp"
#include "idl/process/number_within.hpp"
#include "idl/process/poll.hpp"
#include "idl/process/signals.hpp"
#include "simworld/lockstep/run.hpp"
#include "simworld/process/world_process.hpp"
#include "simworld/report/report.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

struct SweepArguments {
  WorldArguments world;
  std::uint32_t runs = 100;
  unsigned jobs = 0;
  std::optional<double> require_success;
  std::string curves;
  std::string report;
  std::string junit;
  std::string resume;
  bool progress = false;
  bool json = false;
};

/// Splits at commas that are not inside brackets or braces.
std::vector<std::string> values_of(const std::string& list) {
  std::vector<std::string> values{""};
  int depth = 0;
  for (const char c : list) {
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (c == ',' && depth == 0) {
      values.emplace_back();
    } else {
      values.back() += c;
    }
  }
  return values;
}

constexpr std::size_t kFailuresShown = 3;

/// Several rows: side by side, with the first failures of each. What else there is, --json has.
void print_side_by_side(const Json& rows, const Json& table) {
  std::cout << text_of_table(table);
  for (const Json& row : rows) {
    const Json& failures = row.at("failures");
    for (std::size_t i = 0; i < std::min(failures.size(), kFailuresShown); ++i) {
      std::cout << fmt::format("{}: seed {} failed: {}\n", title_of(row), failures[i].at("seed").dump(),
                               failures[i].at("reason").get<std::string>());
    }
    if (failures.size() > kFailuresShown) {
      std::cout << fmt::format("{}: and {} more failed\n", title_of(row), failures.size() - kFailuresShown);
    }
  }
}

void print_table(const Json& rows) {
  for (const Json& row : rows) {
    std::cout << fmt::format("{}: {} runs, success rate {:.4f}\n", title_of(row), row.at("runs").get<std::size_t>(),
                             row.at("success_rate").get<double>());
    std::cout << fmt::format("  {:<34} {:>13} {:>12} {:>13} {:>13} {:>13} {:>13}\n", "figure", "mean", "sd", "min",
                             "p50", "p95", "max");
    for (const auto& [name, s] : row.at("figures").items()) {
      if (!is_printed(name, row.at("figures"))) continue;
      std::cout << fmt::format("  {:<34} {:>13.6g} {:>12.4g} {:>13.6g} {:>13.6g} {:>13.6g} {:>13.6g}\n", name,
                               s.at("mean").get<double>(), s.at("sd").get<double>(), s.at("min").get<double>(),
                               s.at("p50").get<double>(), s.at("p95").get<double>(), s.at("max").get<double>());
    }
    for (const Json& failure : row.at("failures")) {
      std::cout << fmt::format("  seed {} failed: {}\n", failure.at("seed").dump(),
                               failure.at("reason").get<std::string>());
    }
  }
}

SweepPlan plan_of(const SweepArguments& arguments) {
  SweepPlan plan;
  plan.scenario = arguments.world.scenario;
  for (const Override& item : arguments.world.overrides) plan.keys.push_back({item.key, values_of(item.value)});
  plan.first_seed = arguments.world.seed.value_or(0);
  plan.runs = arguments.runs;
  plan.curves = arguments.curves;
  plan.journal = arguments.resume;
  plan.jobs = arguments.jobs > 0 ? arguments.jobs : std::max(1U, std::thread::hardware_concurrency());
  return plan;
}

/// As the user may say it again: --planner and its like are told as the keys that they stand for.
std::string command_of(const SweepArguments& arguments) {
  std::string command = fmt::format("skein sweep {} --runs {} --seed {}", html::shell_word(arguments.world.scenario),
                                    arguments.runs, arguments.world.seed.value_or(0));
  for (const Override& item : arguments.world.overrides)
    command.append(" ").append(html::override_words(item.key, item.value));
  return command;
}

Json document_of(const SweepArguments& arguments, const SweepResult& result) {
  Json document{{"scenario", arguments.world.scenario}, {"complete", !result.stopped}};
  document["version"] = version();
  document["command"] = command_of(arguments);
  document["table"] = table_of(result.rows);
  document["rows"] = result.rows;
  return document;
}

/// @return the exit code if an output of that flag cannot be written, said in one line
std::optional<int> guarded(const char* flag, const std::function<void()>& action) {
  try {
    action();
    return std::nullopt;
  } catch (const figure::NoGnuplot& error) {
    std::cerr << fmt::format("{}: {}\n", flag, error.what());
    return static_cast<int>(ExitCode::StartUp);
  } catch (const std::exception& error) {
    std::cerr << fmt::format("{}: {}\n", flag, error.what());
    return static_cast<int>(ExitCode::Usage);
  }
}

int complain(const std::string& line) {
  std::cerr << line << "\n";
  return static_cast<int>(ExitCode::Usage);
}

ProgressKind progress_kind(const SweepArguments& arguments) {
  if (isatty(STDERR_FILENO) == 1) return ProgressKind::Terminal;
  return arguments.progress ? ProgressKind::Lines : ProgressKind::None;
}

/// Nothing, and a line, if it cannot be made.
std::optional<SweepResult> run_shown(SweepPlan& plan, ProgressKind kind) {
  ProgressLine line(std::cerr, kind, "sweep", steady_now_s());
  plan.on_progress = [&](std::size_t done, std::size_t of) { line.show(done, of, steady_now_s()); };
  plan.on_resume = [&](std::size_t done) { line.set_before(done); };
  std::string fault;
  try {
    SweepResult result = run_sweep(plan);
    line.end();
    return result;
  } catch (const std::invalid_argument& error) {
    fault = error.what();
  } catch (const CurvesNotWritten& error) {
    fault = fmt::format("--curves: {}", error.what());
  } catch (const JournalRefused& error) {
    fault = fmt::format("--resume: {}", error.what());
  }
  line.end();
  complain(fault);
  return std::nullopt;
}

std::size_t runs_of(const SweepResult& result) {
  std::size_t runs = 0;
  for (const Json& row : result.rows) runs += row.at("runs").get<std::size_t>();
  return runs;
}

/// Before the runs. @return the exit code if one cannot be written
std::optional<int> check_outputs(const SweepArguments& arguments) {
  const std::string& scenario = arguments.world.scenario;
  const auto check_report = [&] {
    check_output(arguments.report, {scenario, arguments.resume});
    check_gnuplot();
  };
  const auto check_junit = [&] { check_output(arguments.junit, {scenario, arguments.resume, arguments.report}); };
  std::optional<int> code;
  if (!arguments.junit.empty()) code = guarded("--junit", check_junit);
  if (!code && !arguments.report.empty()) code = guarded("--report", check_report);
  return code;
}

/// After the runs. @return the exit code if one cannot be written
std::optional<int> write_outputs(const SweepArguments& arguments, const SweepResult& result) {
  const auto write_junit = [&] {
    write_output(arguments.junit, junit_xml(arguments.world.scenario, junit_suites(result.rows, arguments.runs)));
  };
  const auto write_page = [&] {
    const figure::Json document = document_of(arguments, result);
    write_report(figure::input_of_sweep(arguments.world.scenario, document), arguments.report,
                 command_of(arguments) + " --report " + html::shell_word(arguments.report));
  };
  std::optional<int> code;
  if (!arguments.junit.empty()) code = guarded("--junit", write_junit);
  if (!code && !arguments.report.empty()) code = guarded("--report", write_page);
  return code;
}

void print(const SweepArguments& arguments, const SweepResult& result, std::size_t total) {
  if (arguments.json) {
    std::cout << document_of(arguments, result).dump(2) << "\n";
    return;
  }
  if (result.stopped) std::cout << fmt::format("PARTIAL: {} of {} runs\n", runs_of(result), total);
  if (result.rows.size() > 1) {
    print_side_by_side(result.rows, table_of(result.rows));
  } else {
    print_table(result.rows);
  }
}

int sweep(const SweepArguments& arguments) {
  SweepPlan plan = plan_of(arguments);
  if (plan.first_seed + (plan.runs - 1) < plan.first_seed) {
    std::cerr << fmt::format("--seed {}: {} runs from it go beyond 2^64 - 1\n", plan.first_seed, plan.runs);
    return static_cast<int>(ExitCode::Usage);
  }
  if (const auto code = check_outputs(arguments)) return *code;
  const SignalWatch signals({SIGINT, SIGTERM});
  std::optional<int> signal;
  plan.stop = [&] {
    if (const auto arrived = signals.take()) signal = arrived;
    return signal.has_value();
  };
  const std::optional<SweepResult> made = run_shown(plan, progress_kind(arguments));
  if (!made) return static_cast<int>(ExitCode::Usage);
  const SweepResult& result = *made;
  const std::size_t total = result.rows.size() * plan.runs;
  print(arguments, result, total);
  if (const auto code = write_outputs(arguments, result)) return *code;
  if (signal) {
    std::cerr << interrupted_text(runs_of(result), total, arguments.resume) << "\n";
    return 128 + *signal;
  }
  for (const Json& row : result.rows) {
    if (arguments.require_success && row.at("success_rate").get<double>() < *arguments.require_success) {
      std::cerr << fmt::format("{}: success rate {:.4f} is under the required {}\n", title_of(row),
                               row.at("success_rate").get<double>(), *arguments.require_success);
      return static_cast<int>(ExitCode::Failed);
    }
  }
  return 0;
}

}  // namespace

VerbAction add_sweep_verb(CLI::App& app) {
  auto arguments = std::make_shared<SweepArguments>();
  CLI::App* verb = app.add_subcommand("sweep", "run many seeds in this process, print statistics");
  add_scenario_options(*verb, arguments->world);
  verb->get_option("--set")->description("key=a,b,c: a scenario key and the values it takes in turn; may be repeated");
  verb->get_option("--planner")->description("a,b,c: the same as --set planner.name=a,b,c");
  verb->get_option("--agents")->description("a,b,c: how many vehicles in turn");
  verb->get_option("--controller")->description("a,b: the same as --set controller.name=a,b");
  verb->get_option("--seed")->description("seed of the first run (0); run i has this seed + i");
  verb->add_option("--runs", arguments->runs, "runs of each combination")
      ->check(CLI::Range(1U, 10'000'000U))
      ->capture_default_str();
  verb->add_option("--jobs", arguments->jobs, "threads; by default one a core")->check(CLI::Range(1U, 1024U));
  verb->add_option("--require-success", arguments->require_success, "exit 1 if a success rate is lower")
      ->check(number_within(0.0, 1.0));
  verb->add_option("--curves", arguments->curves, "folder for the curves (CSV) of each combination's first run");
  verb->add_option("--report", arguments->report, "FILE.html: a page with tables and box plots (docs/reports.md)");
  verb->add_option("--junit", arguments->junit, "FILE.xml: a test case a run, failures with their reason");
  verb->add_option("--resume", arguments->resume,
                   "FILE of the runs that are done: what it has is not run again; it is made if it is not there");
  verb->add_flag("--progress", arguments->progress, "a line every 10 s where standard error is no terminal");
  verb->add_flag("--json", arguments->json, "print JSON, with every run");
  verb->footer("Example: skein sweep deploy/scenarios/rendezvous-2d.yaml --runs 1000 --set planner.particles=10,20");
  return [arguments] { return sweep(*arguments); };
}

}  // namespace skein
