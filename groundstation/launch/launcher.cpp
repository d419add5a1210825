#include "groundstation/launch/launcher.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>

#include "idl/process/id_list.hpp"
#include "idl/process/poll.hpp"

namespace skein {
namespace {

constexpr double kGrace_s = 3.0;       ///< for an agent to end by itself, and then after SIGTERM
constexpr double kWorldGrace_s = 8.0;  ///< for the world to end after a signal

}  // namespace

Launcher::Launcher(LaunchPlan plan) : plan_(std::move(plan)), signals_({SIGINT, SIGTERM, SIGCHLD}) {}

int Launcher::run() {
  for (const char* name : {"/skein-simworld", "/skein-agent"}) {
    if (access((plan_.binaries + name).c_str(), X_OK) != 0) {
      throw StartFailure(fmt::format("cannot start {}{}: {}", plan_.binaries, name, std::strerror(errno)));
    }
  }
  auto [near, far] = ControlChannel::pair();
  channel_ = std::make_unique<ControlChannel>(std::move(near));
  std::vector<std::string> arguments = plan_.world_arguments;
  arguments.insert(arguments.begin(), {"--control-fd", std::to_string(far.fd())});
  world_ = std::make_unique<Child>(plan_.binaries + "/skein-simworld", arguments, plan_.out + "/world.log", far.fd());
  far.close();
  while (world_->running()) {
    wait_readable({signals_.fd(), channel_->fd()}, 1.0);
    take_signals();
    take_messages();
    reap();
    if (signal_ && steady_now_s() > signalled_s_ + kWorldGrace_s) world_->signal(SIGKILL);
  }
  end_agents();
  return *world_->status();
}

void Launcher::start_agents(const std::vector<AgentId>& ids) {
  for (std::size_t first = 0; first < ids.size(); first += plan_.per_process) {
    const std::size_t count = std::min(plan_.per_process, ids.size() - first);
    const auto begin = ids.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<AgentId> own(begin, begin + static_cast<std::ptrdiff_t>(count));
    std::vector<std::string> arguments = plan_.agent_arguments;
    arguments.insert(arguments.end(), {"--id", text_of(own)});
    const std::string log = fmt::format("{}/agent-{}.log", plan_.out, text_of(own));
    processes_.push_back(
        std::make_unique<Process>(Process{Child(plan_.binaries + "/skein-agent", arguments, log, -1), own}));
    const pid_t pid = processes_.back()->child.pid();
    for (const AgentId id : own) records_[id].pid = pid;
    channel_->send({{"started", own}, {"pid", pid}});
  }
}

Launcher::Process* Launcher::process_of(AgentId id) {
  const auto found = std::ranges::find_if(
      processes_, [&](const auto& process) { return std::ranges::find(process->ids, id) != process->ids.end(); });
  return found == processes_.end() ? nullptr : found->get();
}

void Launcher::take_messages() {
  while (const auto message = channel_->receive()) {
    if (const auto ids = message->find("launch"); ids != message->end() && !signal_) {
      start_agents(ids->get<std::vector<AgentId>>());
    }
    if (const auto id = message->find("kill"); id != message->end()) {
      if (const Process* process = process_of(id->get<AgentId>())) process->child.signal(SIGKILL);
    }
    if (const auto progress = message->find("progress"); progress != message->end()) {
      if (progress->value("phase", "") == "flying") note_memory();
      if (plan_.on_progress) plan_.on_progress(*progress);
    }
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
      for (const auto& process : processes_) process->child.signal(SIGKILL);
      world_->signal(SIGKILL);
    }
  }
}

void Launcher::reap() {
  for (const auto& process : processes_) {
    if (records_[process->ids.front()].wait_status || process->child.running()) continue;
    for (const AgentId id : process->ids) records_[id].wait_status = process->child.status();
    channel_->send({{"ended", process->ids}, {"pid", process->child.pid()}, {"status", *process->child.status()}});
  }
}

void Launcher::note_memory() {
  if (std::exchange(memory_noted_, true)) return;
  for (const auto& process : processes_) {
    std::optional<double> share_mb = pss_mb(process->child.pid());
    if (share_mb) *share_mb /= static_cast<double>(process->ids.size());
    for (const AgentId id : process->ids) records_[id].pss_mb = share_mb;
  }
}

bool Launcher::agents_running() {
  return std::ranges::any_of(processes_, [](const auto& process) { return process->child.running(); });
}

void Launcher::end_agents() {
  for (const int number : {0, SIGTERM, SIGKILL}) {
    for (const auto& process : processes_) {
      if (number != 0 && process->child.running()) process->child.signal(number);
    }
    const double until_s = steady_now_s() + (signal_ && number == 0 ? 0.5 : kGrace_s);
    while (agents_running() && steady_now_s() < until_s) {
      wait_readable({signals_.fd()}, 0.1);
      take_signals();
    }
  }
  reap();
}

}  // namespace skein
