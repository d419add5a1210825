#include "groundstation/steer/steering.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>

#include "groundstation/attach/choose_swarm.hpp"
#include "groundstation/steer/conversation.hpp"
#include "idl/bus/dds_steering_port.hpp"
#include "idl/convert/convert.hpp"
#include "idl/process/dds_config.hpp"
#include "idl/process/poll.hpp"
#include "idl/process/signals.hpp"
#include "planner/core/lockstep/names.hpp"

namespace skein {
namespace {

constexpr int kFailed = 1;
constexpr int kStartUp = 3;
constexpr double kLook_s = 0.1;    ///< at most between two looks at the bus
constexpr double kRepeat_s = 1.0;  ///< without an answer: the same id again, which the world takes once
constexpr double kSettle_s = 0.2;  ///< between finding the world's readers and their finding this writer

class Steerer {
 public:
  Steerer(const CommonFlags& flags, const SteerRequest& request, const SignalWatch& signals)
      : flags_(flags),
        request_(request),
        signals_(signals),
        id_(random_id() | 1U),
        port_(dds_config(flags, kWorldId, random_id())),
        heard_(id_, agent_of(request), std::holds_alternative<Order>(request.what)) {}

  SteerResult run() {
    if (!find_world()) return ended_;
    const double since_s = steady_now_s();
    double sent_s = -1e9;
    while (!heard_.complete() && steady_now_s() - since_s < request_.deadline_s) {
      if (!heard_.answer() && steady_now_s() - sent_s >= kRepeat_s) {
        publish(request_.deadline_s - (steady_now_s() - since_s));
        sent_s = steady_now_s();
      }
      if (!look()) return ended_;
    }
    return result();
  }

 private:
  static AgentId agent_of(const SteerRequest& request) {
    return std::visit([](const auto& what) { return what.agent; }, request.what);
  }

  /// Takes what arrives. @return false if a signal ended it
  bool look() {
    wait_readable({port_.wake_fd(), signals_.fd()}, kLook_s);
    if (const auto signal = signals_.take()) {
      ended_ = {128 + *signal, ended_by(*signal), nullptr};
      return false;
    }
    arrived_.clear();
    port_.take(arrived_);
    for (const bus::ObserverInbound& sample : arrived_) heard_.take(sample);
    return true;
  }

  bool find_world() {
    const double until_s = steady_now_s() + flags_.startup_timeout_s;
    double ready_s = -1.0;
    while (true) {
      const double now_s = steady_now_s();
      if (const auto conflict = port_.conflict()) {
        ended_ = {kStartUp, *conflict, nullptr};
        return false;
      }
      if (ready_s < 0.0 && port_.ready() && heard_.run()) ready_s = now_s;
      if (ready_s >= 0.0 && now_s - ready_s >= kSettle_s) return true;
      if (now_s >= until_s) {
        ended_ = {kStartUp,
                  fmt::format("no world of swarm {} in domain {} within {} s", flags_.swarm, flags_.domain,
                              flags_.startup_timeout_s),
                  nullptr};
        return false;
      }
      if (!look()) return false;
    }
  }

  void publish(double deadline_s) {
    const Stamp stamp{wall_now_ns(), *heard_.run()};
    if (const auto* order = std::get_if<Order>(&request_.what)) {
      Command command{*heard_.run(), *order, deadline_s};
      command.order.id = id_;
      (void)port_.publish(to_wire(command, stamp));  // what DDS does not take is repeated
    } else {
      Inject inject{*heard_.run(), std::get<Injection>(request_.what), deadline_s};
      inject.injection.id = id_;
      (void)port_.publish(to_wire(inject, stamp));
    }
  }

  static std::int64_t wall_now_ns() { return static_cast<std::int64_t>(steady_now_s() * 1e9); }

  /// Of the verb.
  [[nodiscard]] std::string name() const {
    const auto* injection = std::get_if<Injection>(&request_.what);
    if (injection != nullptr && injection->kind == InjectionKind::Obstacle) return "inject";
    return std::visit([](const auto& what) { return std::string(name_of(what.kind)); }, request_.what);
  }

  [[nodiscard]] SteerResult result() const {
    const auto& answer = heard_.answer();
    const std::vector<AgentId> missing = heard_.missing();
    SteerResult result;
    if (!answer) {
      result.reason = fmt::format("not taken up by the world within {} s: a round waits for an agent, or it is gone",
                                  request_.deadline_s);
    } else if (!heard_.accepted()) {
      result.reason = fmt::format("refused ({}): {}", name_of(answer->result), answer->text);
    } else if (!missing.empty()) {
      result.reason =
          fmt::format("not acknowledged within {} s by agent {}", request_.deadline_s, fmt::join(missing, ", "));
    }
    result.exit_code = result.reason.empty() ? 0 : kFailed;
    result.json = {{"command", name()},
                   {"swarm", flags_.swarm},
                   {"id", fmt::format("{:016x}", id_)},
                   {"agent", agent_of(request_)},
                   {"result", answer ? nlohmann::ordered_json(name_of(answer->result)) : nullptr},
                   {"round", heard_.accepted() ? nlohmann::ordered_json(answer->round) : nullptr},
                   {"acknowledged", heard_.acknowledged()},
                   {"missing", missing},
                   {"reason", result.reason}};
    return result;
  }

  const CommonFlags& flags_;
  const SteerRequest& request_;
  const SignalWatch& signals_;
  const std::uint64_t id_;
  bus::DdsSteeringPort port_;
  Conversation heard_;
  std::vector<bus::ObserverInbound> arrived_;
  SteerResult ended_;
};

}  // namespace

SteerResult steer(const CommonFlags& flags, const SteerRequest& request) {
  const SignalWatch signals({SIGINT, SIGTERM});
  const SwarmChoice choice = choose_swarm(flags, signals);
  if (choice.swarm.empty()) return {choice.exit_code, choice.reason, nullptr};
  CommonFlags chosen = flags;
  chosen.swarm = choice.swarm;
  return Steerer(chosen, request, signals).run();
}

}  // namespace skein
