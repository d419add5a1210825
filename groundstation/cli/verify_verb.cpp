// skein verify A B, and skein verify A --rerun: whether two runs are the same, sample by sample.
#include <fmt/core.h>

#include <csignal>
#include <iostream>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/mcap/file.hpp"
#include "groundstation/verify/compare.hpp"
#include "groundstation/verify/rerun.hpp"
#include "idl/process/signals.hpp"

namespace skein {
namespace {

constexpr int kDifferent = 1;
constexpr int kBad = 2;
constexpr int kNotStarted = 3;
constexpr int kSignalled = 128;

struct VerifyArguments {
  std::string a, b;
  bool rerun = false;
  bool json = false;
};

/// A file with what it says of its run; every byte is checked.
struct Opened {
  explicit Opened(const std::string& path) : file(path), reader(file.bytes()) {
    reader.check();
    run = run_of(reader);
    if (!reader.missing().empty()) std::cerr << fmt::format("{}: {}\n", path, reader.missing());
    if (run.unreadable() > 0) std::cerr << fmt::format("{}: {} samples that are none\n", path, run.unreadable());
    if (run.last_round() == 0) throw std::runtime_error("it holds no round of a run");
  }
  mcap::MappedFile file;
  mcap::Reader reader;
  RecordedRun run;
};

/// A run that never started, or was interrupted, or whose recording was cut, is repeated beyond that; its last round is
/// not whole.
std::uint32_t compared_before(const RecordedRun& run) {
  const auto outcome = run.outcome();
  const bool to_its_end = outcome && outcome->exit_code < kSignalled && outcome->exit_code != kNotStarted;
  return to_its_end ? UINT32_MAX : run.last_round();
}

Comparison compare_rerun(const Opened& a) {
  const SignalWatch signals({SIGINT, SIGTERM});
  std::optional<int> signal;
  const RecordedRun again = rerun(a.reader, a.run, [&] {
    if (const auto arrived = signals.take()) signal = arrived;
    return signal;
  });
  if (signal) throw *signal;
  return compare(a.run, again, compared_before(a.run));
}

int verify(const VerifyArguments& arguments) {
  std::string opening = arguments.a;
  try {
    const Opened a(arguments.a);
    Comparison comparison;
    if (arguments.rerun) {
      comparison = compare_rerun(a);
    } else {
      opening = arguments.b;
      comparison = compare(a.run, Opened(arguments.b).run);
    }
    if (arguments.json) {
      std::cout << json_of(comparison).dump(2) << "\n";
    } else {
      std::cout << text_of(comparison) << "\n";
    }
    return comparison.difference ? kDifferent : 0;
  } catch (const std::exception& error) {
    const std::string what = error.what();
    const bool named = what.starts_with(opening + ":");
    std::cerr << "skein verify: " << (named ? what : opening + ": " + what) << "\n";
    return kBad;
  } catch (int signal) {
    return kSignalled + signal;
  }
}

}  // namespace

VerbAction add_verify_verb(CLI::App& app) {
  auto arguments = std::make_shared<VerifyArguments>();
  CLI::App* verb = app.add_subcommand("verify", "compare two recordings, or one and a fresh run of its scenario");
  verb->add_option("A", arguments->a, "recording")->required();
  CLI::Option* b = verb->add_option("B", arguments->b, "the other recording");
  CLI::Option* rerun =
      verb->add_flag("--rerun", arguments->rerun, "run A's scenario, seed and roster changes again, in this process");
  rerun->excludes(b);
  verb->add_flag("--json", arguments->json, "print JSON");
  verb->footer("Exit code 0: equal; 1: different; 2: a bad file.\nExample: skein verify a.mcap --rerun");
  verb->final_callback([b, rerun] {
    if (b->count() + rerun->count() == 0) throw CLI::ValidationError("B is required, or --rerun");
  });
  return [arguments] { return verify(*arguments); };
}

}  // namespace skein
