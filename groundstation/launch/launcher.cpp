#include "groundstation/launch/launcher.hpp"

#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>

#include "idl/process/id_list.hpp"
#include "idl/process/poll.hpp"

namespace skein {
namespace {

constexpr double kGrace_s = 3.0;       ///< for an agent to end by itself, and then after SIGTERM
constexpr double kListen_s = 0.1;      ///< between two calls of who listens
constexpr double kWorldGrace_s = 8.0;  ///< for the world to end after a signal

}  // namespace

Launcher::Launcher(LaunchPlan plan) : plan_(std::move(plan)), signals_({SIGINT, SIGTERM, SIGCHLD}) {}

int Launcher::run() {
  for (const char* name : {"/skein-simworld", "/skein-agent"}) {
    if (access((plan_.binaries + name).c_str(), X_OK) != 0) {
      throw StartFailure(fmt::format("cannot start {}{}: {}", plan_.binaries, name, std::strerror(errno)));
    }
  }
  for (bool again = true; again; again = may_restart_world()) {
    start_world();
    serve_world();
  }
  end_agents();
  return *world_->status();
}

void Launcher::start_world() {
  auto [near, far] = ControlChannel::pair();
  channel_ = std::make_unique<ControlChannel>(std::move(near));
  std::vector<std::string> arguments = plan_.world_arguments;
  arguments.insert(arguments.begin(), {"--control-fd", std::to_string(far.fd())});
  world_ = std::make_unique<Child>(plan_.binaries + "/skein-simworld", arguments, plan_.out + "/world.log", far.fd());
  far.close();
}

void Launcher::serve_world() {
  while (world_->running()) {
    wait_readable({signals_.fd(), channel_->fd(), listened_fd_}, serve_ ? kListen_s : 1.0);
    serve_listened();
    take_signals();
    take_messages();
    reap();
    if (signal_ && steady_now_s() > signalled_s_ + kWorldGrace_s) world_->signal(SIGKILL);
  }
}

void Launcher::listen(int fd, std::function<std::optional<nlohmann::json>()> serve) {
  listened_fd_ = fd;
  serve_ = std::move(serve);
}

void Launcher::serve_listened() {
  if (!serve_) return;
  if (const auto message = serve_()) channel_->send(*message);
}

bool Launcher::may_restart_world() {
  take_messages();  // what it still had to say
  const int status = *world_->status();
  if (!plan_.restart_world || signal_ || !WIFSIGNALED(status) || world_restarts_ == kWorldRestarts) return false;
  ++world_restarts_;
  world_died_s_ = steady_now_s();
  repeated_round_.reset();
  if (plan_.on_world_restart) plan_.on_world_restart(describe_status(status));
  return true;
}

/// A world that was started again knows of no process.
void Launcher::tell_ends() {
  for (const Group& group : groups_) {
    const AgentProcess& record = records_[group.record];
    if (record.wait_status) {
      channel_->send({{"ended", group.ids}, {"pid", record.pid}, {"status", *record.wait_status}});
    } else if (group.child->stopped()) {
      for (const AgentId id : group.ids) channel_->send({{"stopped", id}});
    }
  }
}

void Launcher::start_agents(const std::vector<AgentId>& ids) {
  for (std::size_t first = 0; first < ids.size(); first += plan_.per_process) {
    const std::size_t count = std::min(plan_.per_process, ids.size() - first);
    const auto begin = ids.begin() + static_cast<std::ptrdiff_t>(first);
    start(groups_.emplace_back(Group{{begin, begin + static_cast<std::ptrdiff_t>(count)}, nullptr, 0}));
  }
}

void Launcher::start(Group& group) {
  const std::string ids = text_of(group.ids);
  std::vector<std::string> arguments = plan_.agent_arguments;
  arguments.insert(arguments.end(), {"--id", ids});
  const std::string log = fmt::format("{}/agent-{}.log", plan_.out, ids);
  group.child = std::make_unique<Child>(plan_.binaries + "/skein-agent", arguments, log, -1);
  group.record = records_.size();
  for (const AgentId id : group.ids) records_.push_back({.id = id, .pid = group.child->pid()});
  channel_->send({{"started", group.ids}, {"pid", group.child->pid()}});
}

void Launcher::take_messages() {
  while (const auto message = channel_->receive()) {
    if (const auto ids = message->find("launch"); ids != message->end() && !signal_) {
      if (groups_.empty()) {
        start_agents(ids->get<std::vector<AgentId>>());
      } else {
        tell_ends();
      }
    }
    act_on(*message);
    if (const auto progress = message->find("progress"); progress != message->end()) {
      if (progress->value("phase", "") == "flying") note_memory();
      note_recovery(progress->value("round", 0U));
      if (plan_.on_progress) plan_.on_progress(*progress);
    }
  }
}

/// Faults on purpose: they befall the process of an agent, and with it all that share it. What a kill or the end of a
/// restarted process came to, the world hears as any other end.
void Launcher::act_on(const nlohmann::json& message) {
  for (const char* order : {"kill", "cont", "stop", "restart"}) {
    const auto id = message.find(order);
    if (id == message.end()) continue;
    if (*id == kWorldId) {
      world_->signal(SIGKILL);
      continue;
    }
    const auto group = std::ranges::find_if(
        groups_, [&](const Group& each) { return std::ranges::find(each.ids, id->get<AgentId>()) != each.ids.end(); });
    if (group != groups_.end()) act_on(*group, order, id->get<AgentId>());
  }
}

void Launcher::act_on(Group& group, std::string_view order, AgentId id) {
  if (order == "kill") group.child->signal(SIGKILL);
  if (order == "cont") group.child->signal(SIGCONT);
  if (order == "stop") {
    group.child->stop();
    channel_->send({{"stopped", id}});
  }
  if (order == "restart" && !signal_) {
    group.child->kill_and_reap();
    note_end(group);
    start(group);
  }
}

void Launcher::take_signals() {
  while (const auto number = signals_.take()) {
    if (*number == SIGCHLD) continue;
    if (!signal_) {
      signal_ = number;
      signalled_s_ = steady_now_s();
      world_->signal(*number);
    } else {
      for (const Group& group : groups_) group.child->signal(SIGKILL);
      world_->signal(SIGKILL);
    }
  }
}

void Launcher::reap() {
  for (Group& group : groups_) {
    if (!group.child->running()) note_end(group);
  }
}

void Launcher::note_end(Group& group) {
  if (records_[group.record].wait_status) return;
  for (std::size_t i = 0; i < group.ids.size(); ++i) records_[group.record + i].wait_status = group.child->status();
  channel_->send({{"ended", group.ids}, {"pid", group.child->pid()}, {"status", *group.child->status()}});
}

void Launcher::note_memory() {
  if (std::exchange(memory_noted_, true)) return;
  for (const Group& group : groups_) {
    std::optional<double> share_mb = pss_mb(group.child->pid());
    if (share_mb) *share_mb /= static_cast<double>(group.ids.size());
    for (std::size_t i = 0; i < group.ids.size(); ++i) records_[group.record + i].pss_mb = share_mb;
  }
}

void Launcher::note_recovery(std::uint32_t round) {
  if (!world_died_s_) return;
  if (!repeated_round_) repeated_round_ = round;
  if (round == *repeated_round_) return;
  recoveries_s_.push_back(steady_now_s() - *std::exchange(world_died_s_, std::nullopt));
}

bool Launcher::agents_running() {
  return std::ranges::any_of(groups_, [](const Group& group) { return group.child->running(); });
}

void Launcher::end_agents() {
  for (const int number : {0, SIGTERM, SIGKILL}) {
    for (const Group& group : groups_) {
      if (number != 0 && group.child->running()) group.child->signal(number);
      if (group.child->stopped()) group.child->signal(SIGKILL);  // it cannot end by itself
    }
    const double until_s = steady_now_s() + (signal_ && number == 0 ? 0.5 : kGrace_s);
    while (agents_running() && steady_now_s() < until_s) {
      wait_readable({signals_.fd()}, 0.1);
      serve_listened();
      take_signals();
    }
  }
  reap();
}

}  // namespace skein
