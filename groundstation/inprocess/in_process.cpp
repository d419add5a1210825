#include "groundstation/inprocess/in_process.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "agent/runtime/agent_session.hpp"
#include "idl/process/poll.hpp"
#include "simworld/checkpoint/checkpoint.hpp"
#include "simworld/report/report.hpp"

namespace skein {
namespace {

constexpr std::uint64_t kRun = 1;
constexpr std::uint64_t kWorldNonce = 1;
constexpr double kLeastWait_s = 1e-3;

struct Member {
  std::unique_ptr<bus::AgentPort> port;
  std::unique_ptr<AgentSession> session;
  bool stopped = false;
};

class Harness final : public ProcessControl {
 public:
  Harness(const Scenario& scenario, const InProcessOptions& options)
      : scenario_(scenario), options_(options), bus_(kWorldNonce) {
    if (options.tap) bus_.set_tap(options.tap);  // the world publishes the mission at once
    make_world();
    if (options.tamper) bus_.set_tamper(options.tamper);
    wall_.created_s = steady_now_s();
    for (const VehicleSpec& vehicle : scenario.mission.vehicles) start(vehicle.id);
  }

  void kill(AgentId agent) override {
    if (agent == kWorldId) {
      world_dies_ = true;
    } else if (members_.erase(agent) > 0) {
      session_->process_ended(agent, now_s_);
    }
  }
  void stop(AgentId agent) override {
    members_.at(agent).stopped = true;
    session_->process_stopped(agent);
  }
  void cont(AgentId agent) override { members_.at(agent).stopped = false; }
  void restart(AgentId agent) override {
    kill(agent);
    start(agent);
  }

  InProcessResult run() {
    std::optional<int> signal;
    while (session_->state() != WorldSession::State::Done) {
      const std::uint32_t round = session_->run().rounds();
      for (auto& [id, member] : members_) {
        if (!member.stopped) member.session->poll(now_s_);
      }
      session_->poll(now_s_);
      if (std::exchange(world_dies_, false)) replace_world();
      note_times();
      if (options_.signal && !signal && (signal = options_.signal())) {
        session_->interrupt(fmt::format("ended by signal {}", *signal), 128 + *signal, now_s_);
      }
      if (session_->run().rounds() == round) {
        now_s_ += wait_s();
      } else if (options_.on_round) {
        options_.on_round(*session_);
      }
    }
    const ReportContext context{"in-process", bus_.overflowed(), wall_};
    if (checkpoint_) checkpoint_->end(session_->outcome().reason);
    return {make_report(*session_, scenario_, context), session_->outcome().exit_code};
  }

 private:
  void make_world() {
    SessionOptions session;
    session.run = kRun;
    session.nonce = kWorldNonce;
    session.fail_fast = options_.fail_fast;
    session.faults = options_.faults;
    session.replay = options_.replay;
    session.orders = options_.orders;
    session.injections = options_.injections;
    if (options_.checkpoint.empty()) {
      const auto on_world = [](const Fault& fault) { return fault.agent == kWorldId; };
      if (std::ranges::any_of(options_.faults, on_world)) {
        throw std::invalid_argument("a world that is killed needs a checkpoint to go on from");
      }
    } else {
      const CheckpointOwner owner{kRun,
                                  scenario_.mission.name,
                                  scenario_.scenario_hash,
                                  scenario_.mission.seed,
                                  std::string(version()),
                                  options_.fail_fast};
      checkpoint_ = std::make_unique<Checkpoint>(options_.checkpoint, owner, false);
      session.recorder = checkpoint_.get();
    }
    session_ = std::make_unique<WorldSession>(scenario_, session, bus_.world(), this, now_s_);
    if (checkpoint_) checkpoint_->restore(*session_, now_s_);
  }

  /// As a new process: what had arrived for the old one is lost.
  void replace_world() {
    session_.reset();
    checkpoint_.reset();
    std::vector<bus::WorldInbound> unread;
    bus_.world().take(unread);
    make_world();
    for (const VehicleSpec& vehicle : scenario_.mission.vehicles) {
      const auto member = members_.find(vehicle.id);
      if (member == members_.end()) {
        session_->process_ended(vehicle.id, now_s_);
      } else if (member->second.stopped) {
        session_->process_stopped(vehicle.id);
      }
    }
  }

  /// A new agent, as a new process is: under a nonce of its own.
  void start(AgentId id) {
    const std::uint64_t nonce = ++last_nonce_;
    Member member;
    member.port = bus_.attach(id, nonce);
    member.session = std::make_unique<AgentSession>(id, nonce, *member.port, now_s_);
    members_[id] = std::move(member);
  }

  /// Until somebody has something to do.
  [[nodiscard]] double wait_s() const {
    double wait_s = session_->idle_s(now_s_);
    for (const auto& [id, member] : members_) {
      if (!member.stopped) wait_s = std::min(wait_s, member.session->idle_s(now_s_));
    }
    return std::max(wait_s, kLeastWait_s);
  }

  void note_times() {
    const PhaseTimes& reached = session_->times();
    for (double PhaseTimes::*time : {&PhaseTimes::started_s, &PhaseTimes::flying_s, &PhaseTimes::finished_s}) {
      if (reached.*time >= 0.0 && wall_.*time < 0.0) wall_.*time = steady_now_s();
    }
  }

  const Scenario& scenario_;
  const InProcessOptions& options_;
  double now_s_ = 0.0;
  bus::MemoryBus bus_;
  std::unique_ptr<Checkpoint> checkpoint_;
  std::unique_ptr<WorldSession> session_;
  bool world_dies_ = false;
  PhaseTimes wall_;
  std::uint64_t last_nonce_ = kWorldNonce;
  std::map<AgentId, Member> members_;
};

}  // namespace

InProcessResult run_in_process(const Scenario& scenario, const InProcessOptions& options) {
  return Harness(scenario, options).run();
}

}  // namespace skein
