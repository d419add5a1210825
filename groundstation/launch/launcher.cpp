#include "groundstation/launch/launcher.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>

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

void Launcher::start_agent(unsigned id) {
  std::vector<std::string> arguments = plan_.agent_arguments;
  arguments.insert(arguments.end(), {"--id", std::to_string(id)});
  auto child = std::make_unique<Child>(plan_.binaries + "/skein-agent", arguments,
                                       fmt::format("{}/agent-{}.log", plan_.out, id), -1);
  records_.push_back({.id = id, .pid = child->pid()});
  channel_->send({{"started", id}, {"pid", child->pid()}});
  agents_[id] = {std::move(child), records_.size() - 1};
}

void Launcher::take_messages() {
  while (const auto message = channel_->receive()) {
    if (const auto id = message->find("launch"); id != message->end() && !signal_) start_agent(id->get<unsigned>());
    act_on(*message);
    if (const auto progress = message->find("progress"); progress != message->end()) {
      if (progress->value("phase", "") == "flying") note_memory();
      if (plan_.on_progress) plan_.on_progress(*progress);
    }
  }
}

/// Faults on purpose. What a kill or the end of a restarted process came to, the world hears as any other end.
void Launcher::act_on(const nlohmann::json& message) {
  const auto agent_of = [&](const char* order) {
    const auto id = message.find(order);
    return id == message.end() ? agents_.end() : agents_.find(id->get<unsigned>());
  };
  if (const auto agent = agent_of("kill"); agent != agents_.end()) agent->second.child->signal(SIGKILL);
  if (const auto agent = agent_of("cont"); agent != agents_.end()) agent->second.child->signal(SIGCONT);
  if (const auto agent = agent_of("stop"); agent != agents_.end()) {
    agent->second.child->stop();
    channel_->send({{"stopped", agent->first}});
  }
  if (const auto agent = agent_of("restart"); agent != agents_.end() && !signal_) {
    agent->second.child->kill_and_reap();
    note_end(agent->second);
    start_agent(agent->first);
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
      for (const auto& [id, agent] : agents_) agent.child->signal(SIGKILL);
      world_->signal(SIGKILL);
    }
  }
}

void Launcher::reap() {
  for (auto& [id, agent] : agents_) {
    if (!agent.child->running()) note_end(agent);
  }
}

void Launcher::note_end(Agent& agent) {
  AgentProcess& record = records_[agent.record];
  if (record.wait_status) return;
  record.wait_status = agent.child->status();
  channel_->send({{"ended", record.id}, {"pid", record.pid}, {"status", *record.wait_status}});
}

void Launcher::note_memory() {
  if (std::exchange(memory_noted_, true)) return;
  for (AgentProcess& record : records_) record.pss_mb = pss_mb(record.pid);
}

bool Launcher::agents_running() {
  return std::ranges::any_of(agents_, [](const auto& entry) { return entry.second.child->running(); });
}

void Launcher::end_agents() {
  for (const int number : {0, SIGTERM, SIGKILL}) {
    for (const auto& [id, agent] : agents_) {
      if (number != 0 && agent.child->running()) agent.child->signal(number);
      if (agent.child->stopped()) agent.child->signal(SIGKILL);  // it cannot end by itself
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
