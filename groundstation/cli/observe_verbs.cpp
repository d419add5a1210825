// skein monitor, status and topics: what a swarm that others started is doing, on a terminal and for scripts.
#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <memory>
#include <optional>

#include "groundstation/attach/choose_swarm.hpp"
#include "groundstation/cli/verbs.hpp"
#include "groundstation/monitor/monitor.hpp"
#include "groundstation/watch/figures.hpp"
#include "groundstation/watch/observer.hpp"
#include "idl/process/number_within.hpp"
#include "idl/process/poll.hpp"

namespace skein {
namespace {

constexpr double kRateWindow_s = 1.0;  ///< that rates are taken over at least
constexpr double kPatience_s = 3.0;    ///< for agents that say nothing
constexpr double kLookForSwarm_s = 5.0;
constexpr std::size_t kEvents = 5;
constexpr int kUsage = 2;

struct ObserveArguments {
  CommonFlags common;
  bool json = false;
  bool watch = false;
  double interval_s = 1.0;
};

/// What a verb prints of a view. @param line JSON in one line
using Print = std::function<std::string(const watch::SwarmView&, const std::string& swarm, bool line)>;

int complain(const char* verb, int exit_code, const std::string& reason) {
  std::cerr << fmt::format("skein {}: {}\n", verb, reason);
  return exit_code;
}

int put(const char* verb, const std::string& text, int exit_code) {
  std::cout << text << std::flush;
  return std::cout ? exit_code : complain(verb, 1, "cannot write to standard output");
}

/// Until every live agent was heard and rates say something, or the run is over.
bool knows_enough(const watch::Observer& observer) {
  const std::optional<double> observed_s = observer.observed_s();
  if (!observed_s || *observed_s < kRateWindow_s) return false;
  return observer.watch().complete() || *observed_s > kPatience_s;
}

int observe(const char* verb, const ObserveArguments& arguments, const Print& print) {
  const SignalWatch signals({SIGINT, SIGTERM});
  const SwarmChoice choice = choose_swarm(arguments.common, signals);
  if (choice.swarm.empty()) return complain(verb, choice.exit_code, choice.reason);
  CommonFlags flags = arguments.common;
  flags.swarm = choice.swarm;
  watch::Observer observer(flags);
  double next_s = 0.0;
  while (true) {
    wait_readable({signals.fd()}, watch::kTake_s);
    if (const std::optional<int> signal = signals.take()) return complain(verb, 128 + *signal, ended_by(*signal));
    observer.take();
    const std::optional<watch::Ending> ending = observer.ended();
    const bool has_outcome = observer.watch().outcome().has_value();
    if (ending && !has_outcome) return complain(verb, ending->exit_code, ending->reason);
    if (!ending && (!knows_enough(observer) || steady_now_s() < next_s)) continue;
    const int shown = put(verb, print(observer.view(), flags.swarm, arguments.watch), 0);
    if (shown != 0 || !arguments.watch) return shown;
    if (ending) return ending->exit_code;
    next_s = std::max(next_s + arguments.interval_s, steady_now_s());
  }
}

int guarded(const char* verb, const std::function<int()>& action) {
  try {
    return action();
  } catch (const std::exception& error) {
    return complain(verb, kUsage, error.what());
  }
}

std::string text_of(const nlohmann::ordered_json& json, bool line) {
  return json.dump(line ? -1 : 2) + "\n";
}

CLI::App* add_observer(CLI::App& app, const char* name, const char* about, ObserveArguments& arguments) {
  CLI::App* verb = app.add_subcommand(name, about);
  arguments.common.startup_timeout_s = kLookForSwarm_s;
  add_common_flags(*verb, arguments.common);
  verb->get_option("--startup-timeout")->description("seconds in which a swarm must be heard");
  verb->add_flag("--json", arguments.json, "print JSON on standard output");
  CLI::Option* watch = verb->add_flag("--watch", arguments.watch, "again and again, until the run ends; JSON in lines");
  verb->add_option("--interval", arguments.interval_s, "seconds between two of --watch")
      ->check(number_within(0.1, 3600.0))
      ->capture_default_str()
      ->needs(watch);
  return verb;
}

}  // namespace

VerbAction add_status_verb(CLI::App& app) {
  auto arguments = std::make_shared<ObserveArguments>();
  add_observer(app, "status", "what a running swarm is doing, for scripts", *arguments)
      ->footer("Example: skein status --json | jq '.agents[] | {id, mode, to_go_m}'");
  return [arguments] {
    return guarded("status", [&] {
      return observe("status", *arguments, [&](const auto& view, const auto& swarm, bool line) {
        return arguments->json ? text_of(watch::status_json(view, swarm), line)
                               : watch::status_text(view, swarm, kEvents);
      });
    });
  };
}

VerbAction add_topics_verb(CLI::App& app) {
  auto arguments = std::make_shared<ObserveArguments>();
  add_observer(app, "topics", "the topics of a running swarm, with rates, bytes, writers", *arguments)
      ->footer("Example: skein topics --swarm geese");
  return [arguments] {
    return guarded("topics", [&] {
      return observe("topics", *arguments, [&](const auto& view, const auto& swarm, bool line) {
        return arguments->json ? text_of(watch::topics_json(view, swarm), line) : watch::topics_text(view);
      });
    });
  };
}

VerbAction add_monitor_verb(CLI::App& app) {
  struct Arguments {
    CommonFlags common;
    monitor::MonitorOptions options;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = app.add_subcommand("monitor", "watch a running swarm on the whole terminal");
  add_common_flags(*verb, arguments->common);
  verb->get_option("--startup-timeout")->description("seconds in which a swarm must be heard");
  verb->add_flag("--keep", arguments->options.keep, "when the run has ended, keep the last picture until q");
  verb->add_flag("--ascii", arguments->options.ascii, "draw without Braille patterns");
  verb->footer("Example: skein monitor --swarm geese");
  return [arguments] {
    return guarded("monitor", [&] {
      const monitor::MonitorEnd end = monitor::monitor(arguments->common, arguments->options);
      if (!end.reason.empty()) std::cerr << fmt::format("skein monitor: {}\n", end.reason);
      return end.exit_code;
    });
  };
}

}  // namespace skein
