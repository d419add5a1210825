#include "simworld/process/world_process.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iostream>

#include "idl/process/dds_config.hpp"
#include "idl/process/network_watch.hpp"
#include "idl/process/poll.hpp"
#include "idl/process/signals.hpp"
#include "idl/process/turn.hpp"
#include "planner/core/lockstep/names.hpp"
#include "simworld/checkpoint/checkpoint.hpp"
#include "simworld/control/control_channel.hpp"
#include "simworld/process/progress.hpp"
#include "simworld/report/report.hpp"

namespace skein {
namespace {

/// The launcher as the session sees it.
class LauncherControl final : public ProcessControl {
 public:
  explicit LauncherControl(ControlChannel& channel) : channel_(channel) {}
  void kill(AgentId agent) override { channel_.send({{"kill", agent}}); }
  void stop(AgentId agent) override { channel_.send({{"stop", agent}}); }
  void cont(AgentId agent) override { channel_.send({{"cont", agent}}); }
  void restart(AgentId agent) override { channel_.send({{"restart", agent}}); }

 private:
  ControlChannel& channel_;
};

constexpr double kSilence_s = 2.5;  ///< a tick is repeated every second
constexpr double kLook_s = 0.25;    ///< at most, between two looks at what may be due: others serve meanwhile

// The last tick says how the run ended, and observers read best effort: they get it again.
constexpr int kLastTicks = 3;
constexpr double kLastTick_s = 0.05;

class WorldProcess {
 public:
  /// @param checkpoint that the run is kept in and goes on from; nullptr for none
  WorldProcess(const WorldArguments& arguments, Scenario scenario, Checkpoint* checkpoint)
      : scenario_(std::move(scenario)),
        checkpoint_(checkpoint),
        run_id_(checkpoint == nullptr ? random_id() : checkpoint->run()),
        signals_({SIGINT, SIGTERM}),
        channel_(arguments.control_fd),
        launcher_(channel_),
        nonce_(random_id()),
        port_(world_config(arguments), ids_of(scenario_.mission), [this] { return turn_.take(); }),
        session_(scenario_, session_options(arguments), port_, channel_.open() ? &launcher_ : nullptr, steady_now_s()),
        launched_(channel_.open()) {}

  void run() {
    if (checkpoint_ != nullptr) checkpoint_->restore(session_, steady_now_s());
    if (session_.world_restarts() > 0) {
      spdlog::warn("goes on with the run from its checkpoint at round {}, step {}", session_.run().rounds(),
                   session_.run().step());
    }
    channel_.send({{"launch", ids_of(scenario_.mission)}});
    // what is due before the own thread would look again (the next tick of a paced run) is its own to wait for
    const Turn::Service service(turn_, [this] { return serve() && session_.idle_s(steady_now_s()) >= kLook_s; });
    for (double idle_s = 0.0;;) {
      wait_readable({port_.wake_fd(), signals_.fd(), channel_.fd(), network_.fd()}, std::min(idle_s, kLook_s));
      const auto lock = turn_.own();
      take_signals();
      take_messages();
      follow_network();
      if (const auto conflict = port_.conflict()) session_.refuse_start(*conflict, steady_now_s());
      if (!serve()) break;
      idle_s = session_.idle_s(steady_now_s());
    }
    if (!port_.flush(std::chrono::milliseconds(1000))) spdlog::warn("not all samples were acknowledged");
    for (int copy = 0; copy < kLastTicks && port_.observed(); ++copy) {
      wait_readable({signals_.fd()}, kLastTick_s);
      session_.remind(steady_now_s());
    }
  }

  [[nodiscard]] nlohmann::ordered_json report() const {
    return make_report(session_, scenario_, {"dds", port_.lost()});
  }
  [[nodiscard]] bool launched() const { return launched_; }

 private:
  /// @return whether the run goes on
  bool serve() {
    session_.poll(steady_now_s());
    if (checkpoint_ != nullptr && !checkpoint_->failure().empty() && !std::exchange(checkpoint_lost_, true)) {
      spdlog::error("the run goes on without its checkpoint: {}", checkpoint_->failure());
    }
    if (session_.recorder_given_up() && !std::exchange(recorder_lost_, true)) {
      spdlog::error("the run goes on without its recorder");
    }
    progress_.show(session_, steady_now_s());
    log_silence(steady_now_s());
    return session_.state() != WorldSession::State::Done;
  }

  /// Says once of a tick that it is unanswered, and by whom, and once that the run goes on.
  void log_silence(double now_s) {
    const std::uint32_t round = session_.run().rounds();
    if (silent_round_ && *silent_round_ != round) {
      spdlog::info("goes on at round {}, step {}", round, session_.run().step());
      silent_round_.reset();
    }
    if (silent_round_) return;
    const std::vector<AgentId> silent = session_.silent_for(kSilence_s, now_s);
    if (silent.empty()) return;
    spdlog::warn("no answer for {} s from {} {}, holding at round {}, step {}", kSilence_s,
                 silent.size() == 1 ? "agent" : "agents", fmt::join(silent, ", "), round, session_.run().step());
    silent_round_ = round;
  }

  [[nodiscard]] SessionOptions session_options(const WorldArguments& arguments) const {
    SessionOptions options;
    options.run = run_id_;
    options.recorder = checkpoint_;
    options.nonce = nonce_;
    options.startup_timeout_s = arguments.common.startup_timeout_s;
    options.settle_s = arguments.settle_s;
    options.fail_fast = arguments.fail_fast;
    options.recorded = arguments.recorded;
    options.pace = {arguments.realtime, scenario_.lockstep.round_s};
    options.faults = arguments.faults;
    options.wait_start = arguments.wait_start;
    return options;
  }

  [[nodiscard]] bus::DdsConfig world_config(const WorldArguments& arguments) const {
    bus::DdsConfig config = dds_config(arguments.common, kWorldId, nonce_);
    config.run = run_id_;
    return config;
  }

  void take_signals() {
    while (const auto signal = signals_.take()) {
      if (signal_) session_.give_up();  // the second one ends at once
      signal_ = signal;
      session_.interrupt(fmt::format("ended by {}", *signal == SIGINT ? "SIGINT" : "SIGTERM"), 128 + *signal,
                         steady_now_s());
    }
  }

  void take_messages() {
    while (const auto message = channel_.receive()) {
      if (const auto ended = message->find("ended"); ended != message->end()) {
        for (const auto id : ended->get<std::vector<AgentId>>()) session_.process_ended(id, steady_now_s());
      }
      if (const auto stopped = message->find("stopped"); stopped != message->end()) {
        session_.process_stopped(stopped->get<AgentId>());
      }
      if (message->contains("unrecorded")) session_.give_up_recorder();
      if (const auto round = message->find("recorded"); round != message->end()) {
        session_.recorded(round->get<std::uint32_t>(), message->at("lacking").get<std::vector<AgentId>>());
      }
    }
    if (launched_ && !channel_.open())
      session_.interrupt("the launcher ended", static_cast<int>(ExitCode::Failed), steady_now_s());
  }

  /// A participant of another network would be deaf in this one; one that is answered is not. The open tick is
  /// repeated until it is. When the run is over the last samples are under way.
  void follow_network() {
    const double now_s = steady_now_s();
    const bool in_need =
        session_.state() == WorldSession::State::Waiting || !session_.silent_for(kInNeed_s, now_s).empty();
    if (const auto what = network_.follow(
            in_need, [this] { port_.renew(); }, now_s))
      spdlog::warn("{}", *what);
  }

  Scenario scenario_;
  Checkpoint* checkpoint_;
  bool checkpoint_lost_ = false;
  std::optional<std::uint32_t> silent_round_;  ///< the open one, if somebody has left it unanswered
  bool recorder_lost_ = false;
  std::uint64_t run_id_;
  SignalWatch signals_;
  ControlChannel channel_;
  LauncherControl launcher_;
  std::uint64_t nonce_;
  Turn turn_;
  NetworkWatch network_;
  bus::DdsWorldPort port_;
  WorldSession session_;
  bool launched_;
  std::optional<int> signal_;
  ProgressFeed progress_{[this](const nlohmann::json& progress, bool fresh) {
    channel_.send({{"progress", progress}}, !fresh);
    if (!launched_ && fresh) spdlog::info("progress {}", progress.dump());
  }};
};

std::unique_ptr<Checkpoint> checkpoint_of(const WorldArguments& arguments, const Scenario& scenario) {
  if (arguments.checkpoint.empty()) return nullptr;
  const CheckpointOwner owner{random_id(),           scenario.mission.name,  scenario.scenario_hash,
                              scenario.mission.seed, std::string(version()), arguments.fail_fast};
  return std::make_unique<Checkpoint>(arguments.checkpoint, owner, arguments.checkpoint_sync);
}

}  // namespace

int run_world(const WorldArguments& arguments) {
  const std::optional<Scenario> scenario = load_or_complain(arguments);
  if (!scenario) return static_cast<int>(ExitCode::Usage);
  if (arguments.control_fd < 0 && !arguments.faults.empty()) {
    std::cerr << "--fault needs a launcher that can end processes: use skein run\n";
    return static_cast<int>(ExitCode::Usage);
  }
  start_log("skein-simworld", arguments.common);
  std::string folder;
  std::unique_ptr<Checkpoint> checkpoint;
  try {
    checkpoint = checkpoint_of(arguments, *scenario);
    folder = prepare_out(arguments.out, *scenario);
  } catch (const CheckpointRefused& refused) {
    std::cerr << refused.what() << "\n";
    return static_cast<int>(refused.code);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return static_cast<int>(ExitCode::Usage);
  }
  nlohmann::ordered_json report;
  try {
    WorldProcess process(arguments, *scenario, checkpoint.get());
    process.run();
    report = process.report();
  } catch (const CheckpointRefused& refused) {
    std::cerr << refused.what() << "\n";
    return static_cast<int>(refused.code);
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return static_cast<int>(ExitCode::StartUp);
  }
  try {
    write_json(folder + "/report.json", report);
  } catch (const std::exception& error) {
    spdlog::error("{}; {}", report["reason"].get<std::string>(), error.what());
    return std::max(report["exit_code"].get<int>(), static_cast<int>(ExitCode::Failed));
  }
  if (checkpoint) checkpoint->end(report["reason"].get<std::string>());
  const int exit_code = report["exit_code"].get<int>();
  spdlog::log(exit_code == 0 ? spdlog::level::info : spdlog::level::err, "{} (report: {}/report.json)",
              report["reason"].get<std::string>(), folder);
  return exit_code;
}

}  // namespace skein
