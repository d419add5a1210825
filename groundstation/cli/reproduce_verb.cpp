// skein reproduce: the papers' experiments, our figures beside theirs.
#include <fmt/core.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <thread>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/output/output_file.hpp"
#include "groundstation/reproduce/document.hpp"
#include "groundstation/sweep/journal.hpp"
#include "groundstation/sweep/progress.hpp"
#include "idl/process/poll.hpp"
#include "idl/process/signals.hpp"
#include "simworld/lockstep/run.hpp"

namespace skein {
namespace {

struct ReproduceArguments {
  std::string what;
  bool quick = false;
  std::optional<std::uint32_t> seeds;
  unsigned jobs = 0;
  std::string out;
  std::string resume;
  bool json = false;
};

std::string command_of(const ReproduceArguments& arguments) {
  std::string command = "skein reproduce " + arguments.what;
  if (arguments.quick) command += " --quick";
  if (arguments.seeds) command += fmt::format(" --seeds {}", *arguments.seeds);
  return command;
}

/// "rendezvous-2d: 12 of 100 runs; 30 % in all, 2 min 5 s left", at the pace so far.
std::string progress_of(const reproduce::Campaign& campaign, std::size_t done, std::size_t of, double share,
                        double before, double elapsed_s) {
  const std::string left = share > before ? duration_text(elapsed_s * (1.0 - share) / (share - before)) : "?";
  return fmt::format("{}: {} of {} runs; {:.0f} % in all, {} left", campaign.name, done, of, 100.0 * share, left);
}

std::vector<reproduce::Paper> papers_of(const std::string& what) {
  using reproduce::Paper;
  if (what == "all") return {Paper::Rendezvous, Paper::Transit};
  return {what == "transit" ? Paper::Transit : Paper::Rendezvous};
}

int run_reproduce(const ReproduceArguments& arguments) {
  if (!arguments.out.empty()) check_output(arguments.out, {});
  std::error_code failed;
  if (!arguments.resume.empty()) std::filesystem::create_directories(arguments.resume, failed);
  if (failed) throw JournalRefused(fmt::format("{}: it cannot be made: {}", arguments.resume, failed.message()));
  const std::vector<reproduce::Paper> papers = papers_of(arguments.what);
  std::vector<reproduce::Campaign> campaigns;
  for (const reproduce::Paper paper : papers) {
    for (reproduce::Campaign& campaign : reproduce::campaigns_of(paper)) campaigns.push_back(std::move(campaign));
  }
  const SignalWatch signals({SIGINT, SIGTERM});
  std::optional<int> signal;
  reproduce::CampaignOptions options;
  options.quick = arguments.quick;
  options.seeds = arguments.seeds;
  options.jobs = arguments.jobs > 0 ? arguments.jobs : std::max(1U, std::thread::hardware_concurrency());
  options.stop = [&] {
    if (const auto arrived = signals.take()) signal = arrived;
    return signal.has_value();
  };
  options.journals = arguments.resume;
  const bool terminal = isatty(STDERR_FILENO) == 1;
  ProgressLine line(std::cerr, terminal ? ProgressKind::Terminal : ProgressKind::Lines, "reproduce", steady_now_s());
  options.on_progress = [&](const reproduce::Campaign& campaign, std::size_t done, std::size_t of, double share,
                            double before) {
    const double now_s = steady_now_s();
    line.show(progress_of(campaign, done, of, share, before, line.elapsed_s(now_s)), false, now_s);
  };
  const reproduce::Results results = reproduce::run_campaigns(campaigns, options);
  line.end();
  const reproduce::Document document = reproduce::document_of(command_of(arguments), papers, results);
  // a file that was whole stays whole: what there is of an interrupted run goes to standard output
  const bool to_file = !arguments.out.empty() && results.complete;
  if (to_file) write_output(arguments.out, text_of(document, reproduce::Layout::File));
  if (arguments.json) {
    std::cout << json_of(document).dump(2) << "\n";
  } else if (!to_file) {
    std::cout << text_of(document, reproduce::Layout::Terminal);
  }
  if (!signal) return static_cast<int>(ExitCode::Success);
  std::cerr << "interrupted: what was run so far is printed"
            << (arguments.out.empty() ? "" : ", " + arguments.out + " is as it was") << "\n";
  return 128 + *signal;
}

}  // namespace

VerbAction add_reproduce_verb(CLI::App& app) {
  auto arguments = std::make_shared<ReproduceArguments>();
  CLI::App* verb = app.add_subcommand("reproduce", "run the papers' experiments, print our figures beside theirs");
  verb->add_option("WHAT", arguments->what, "rendezvous, transit or all")
      ->required()
      ->check(CLI::IsMember({"rendezvous", "transit", "all"}));
  verb->add_flag("--quick", arguments->quick, "fewer seeds: a minute or two instead of ten");
  verb->add_option("--seeds", arguments->seeds, "seeds of every experiment, instead of its own number")
      ->check(CLI::Range(1U, 1'000'000U));
  verb->add_option("--jobs", arguments->jobs, "threads; by default one a core")->check(CLI::Range(1U, 1024U));
  verb->add_option("-o,--out", arguments->out, "Markdown file to write instead of standard output, without wall times");
  verb->add_option("--resume", arguments->resume,
                   "FOLDER of the runs that are done: what it has is not run again; it is made if it is not there");
  verb->add_flag("--json", arguments->json, "print JSON, with each figure's number and the sweeps' tables");
  verb->footer(
      "Exit code 130 after Ctrl-C, with what was run so far.\nExample: skein reproduce all --quick -o tables.md");
  return [arguments] {
    try {
      return run_reproduce(*arguments);
    } catch (const JournalRefused& refused) {
      std::cerr << fmt::format("--resume: {}\n", refused.what());
    } catch (const std::runtime_error& error) {
      std::cerr << fmt::format("skein reproduce: {}\n", error.what());
    }
    return static_cast<int>(ExitCode::Usage);
  };
}

}  // namespace skein
