#include "agent/process/agent_process.hpp"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <csignal>

#include "agent/runtime/agent_session.hpp"
#include "idl/process/dds_config.hpp"
#include "idl/process/poll.hpp"
#include "idl/process/signals.hpp"
#include "planner/core/lockstep/names.hpp"

namespace skein {
namespace {

constexpr int kStartUp = 3;
constexpr int kLost = 4;
constexpr double kWorldTimeout_s = 30.0;

/// Logs what changed since the last call.
void log_course(const AgentSession& session, AgentMode& mode) {
  if (session.mode() == mode) return;
  mode = session.mode();
  spdlog::info("{} at round {}, step {}", name_of(mode), session.round(), session.step());
}

int serve(const AgentArguments& arguments) {
  const SignalWatch signals({SIGINT, SIGTERM});
  const std::uint64_t nonce = random_id();
  bus::DdsAgentPort port(dds_config(arguments.common, arguments.id, nonce));
  AgentSession session(arguments.id, nonce, port, steady_now_s());
  AgentMode mode = AgentMode::Waiting;
  spdlog::info("agent {} introduces itself to swarm {} in domain {}", arguments.id, swarm_of(arguments.common),
               arguments.common.domain);
  while (session.state() == AgentSession::State::Introducing || session.state() == AgentSession::State::Live) {
    wait_readable({port.wake_fd(), signals.fd()}, session.idle_s(steady_now_s()));
    if (const auto signal = signals.take()) {
      session.leave(steady_now_s());
      const bool heard = port.flush(std::chrono::milliseconds(500));
      spdlog::info("ended by signal {}{} at round {}, step {}", *signal, heard ? "" : ", unheard,", session.round(),
                   session.step());
      return 128 + *signal;
    }
    if (const auto conflict = port.conflict()) {
      spdlog::error("{}", *conflict);
      return kStartUp;
    }
    session.poll(steady_now_s());
    log_course(session, mode);
    const double default_s = session.heard_world() ? kWorldTimeout_s : arguments.common.startup_timeout_s;
    const double limit_s = arguments.world_timeout_s.value_or(default_s);
    if (steady_now_s() - session.heard_world_s() > limit_s) {
      spdlog::error("no tick of a world for {} s", limit_s);
      return kStartUp;
    }
  }
  const bool heard = port.flush(std::chrono::milliseconds(500));
  if (session.refused_samples().total() + port.lost() > 0) {
    spdlog::warn("{} samples refused, {} lost", session.refused_samples().total(), port.lost());
  }
  if (session.state() == AgentSession::State::Finished) {
    spdlog::info("the run is over{}: {} at round {}, step {}", heard ? "" : " (last beacon unheard)",
                 name_of(session.mode()), session.round(), session.step());
    return 0;
  }
  spdlog::error("{}", session.reason());
  return session.state() == AgentSession::State::Dropped ? kLost : kStartUp;
}

}  // namespace

int run_agent(const AgentArguments& arguments) {
  start_log(fmt::format("skein-agent-{}", arguments.id), arguments.common);
  try {
    return serve(arguments);
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return kStartUp;
  }
}

}  // namespace skein
