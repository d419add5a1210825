// skein reproduce: the papers' experiments, our figures beside theirs.
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/reproduce/document.hpp"
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
  bool json = false;
};

std::string command_of(const ReproduceArguments& arguments) {
  std::string command = "skein reproduce " + arguments.what;
  if (arguments.quick) command += " --quick";
  if (arguments.seeds) command += fmt::format(" --seeds {}", *arguments.seeds);
  return command;
}

/// Whether a file can be written there, found out before the runs. @return what is wrong, or nothing
std::optional<std::string> unwritable(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return "it is a folder";
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  const bool exists = std::filesystem::exists(file, error);
  if (access((exists ? file : folder).c_str(), W_OK) != 0) return std::strerror(errno);
  return std::nullopt;
}

std::string time_text(double seconds) {
  const auto whole = static_cast<long>(std::floor(seconds + 0.5));
  return whole < 60 ? fmt::format("{} s", whole) : fmt::format("{} min {} s", whole / 60, whole % 60);
}

/// One line on a terminal, written over itself; elsewhere a line as each campaign begins. The time left is what the
/// rest takes at the pace so far.
class ProgressLine {
 public:
  void show(const reproduce::Campaign& campaign, std::size_t done, std::size_t of, double share) const {
    if (!terminal_) {
      if (done == 1) std::cerr << fmt::format("reproduce: {}: {} runs\n", campaign.name, of);
      return;
    }
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begun_;
    const double left_s = spent.count() * (1.0 - share) / share;
    std::cerr << fmt::format("\r\033[Kreproduce: {}: {} of {} runs; {:.0f} % in all, {} left", campaign.name, done, of,
                             100.0 * share, time_text(left_s))
              << std::flush;
  }
  void clear() const {
    if (terminal_) std::cerr << "\r\033[K" << std::flush;
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) == 1;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

std::vector<reproduce::Paper> papers_of(const std::string& what) {
  using reproduce::Paper;
  if (what == "all") return {Paper::Rendezvous, Paper::Transit};
  return {what == "transit" ? Paper::Transit : Paper::Rendezvous};
}

/// @return whether the text is in the file
bool write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) std::cerr << fmt::format("cannot write {}: {}\n", path, std::strerror(errno));
  return static_cast<bool>(file);
}

int run_reproduce(const ReproduceArguments& arguments) {
  if (const auto fault = arguments.out.empty() ? std::nullopt : unwritable(arguments.out)) {
    std::cerr << fmt::format("cannot write {}: {}\n", arguments.out, *fault);
    return static_cast<int>(ExitCode::Usage);
  }
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
  const ProgressLine progress;
  options.on_progress = [&](const reproduce::Campaign& campaign, std::size_t done, std::size_t of, double share) {
    progress.show(campaign, done, of, share);
  };
  const reproduce::Results results = reproduce::run_campaigns(campaigns, options);
  progress.clear();
  const reproduce::Document document = reproduce::document_of(command_of(arguments), papers, results);
  // a file that was whole stays whole: what there is of an interrupted run goes to standard output
  const bool to_file = !arguments.out.empty() && results.complete;
  if (to_file && !write_file(arguments.out, text_of(document, reproduce::Layout::File))) {
    return static_cast<int>(ExitCode::Usage);
  }
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
  verb->add_flag("--json", arguments->json, "print JSON, with each figure's number and the sweeps' tables");
  verb->footer(
      "Exit code 130 after Ctrl-C, with what was run so far.\nExample: skein reproduce all --quick -o tables.md");
  return [arguments] { return run_reproduce(*arguments); };
}

}  // namespace skein
