#include "agent/process/agent_process.hpp"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <csignal>
#include <memory>
#include <variant>

#include "agent/runtime/agent_session.hpp"
#include "agent/runtime/id_request.hpp"
#include "idl/process/dds_config.hpp"
#include "idl/process/id_list.hpp"
#include "idl/process/network_watch.hpp"
#include "idl/process/poll.hpp"
#include "idl/process/signals.hpp"
#include "idl/process/turn.hpp"
#include "planner/core/lockstep/names.hpp"

namespace skein {
namespace {

constexpr int kStartUp = 3;
constexpr int kLost = 4;
constexpr double kWorldTimeout_s = 30.0;
constexpr double kSilence_s = 2.5;  ///< a world that waits repeats its tick every second
constexpr double kLook_s = 0.25;    ///< at most, between two looks at what may be due: others serve meanwhile

/// The sessions of one process, over the ports that they share.
class Sessions {
 public:
  Sessions(const std::vector<AgentId>& ids, std::uint64_t nonce, bus::DdsAgentGroup& group, double now_s) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      members_.push_back(std::make_unique<Member>(ids[i], AgentSession(ids[i], nonce + i, group.port(i), now_s)));
    }
  }

  /// One still waits or takes part, and none was turned away: then the others leave too.
  [[nodiscard]] bool go_on() const {
    return std::ranges::any_of(members_, [](const auto& member) { return active(*member); }) &&
           !any(AgentSession::State::TurnedAway);
  }
  [[nodiscard]] bool any(AgentSession::State state) const {
    return std::ranges::any_of(members_, [&](const auto& member) { return member->session.state() == state; });
  }

  void poll() {
    for (const auto& member : members_) {
      if (active(*member)) member->session.poll(steady_now_s());
      log_course(*member);
    }
  }
  [[nodiscard]] double idle_s(double now_s) const {
    double idle_s = 1.0;
    for (const auto& member : members_) {
      if (active(*member)) idle_s = std::min(idle_s, member->session.idle_s(now_s));
    }
    return idle_s;
  }
  void leave(double now_s) {
    for (const auto& member : members_) {
      if (active(*member)) member->session.leave(now_s);
    }
  }
  [[nodiscard]] double heard_world_s() const {
    double heard_s = -1e9;
    for (const auto& member : members_) heard_s = std::max(heard_s, member->session.heard_world_s());
    return heard_s;
  }
  [[nodiscard]] bool heard_world() const {
    return std::ranges::any_of(members_, [](const auto& member) { return member->session.heard_world(); });
  }
  [[nodiscard]] std::uint64_t refused_samples() const {
    std::uint64_t sum = 0;
    for (const auto& member : members_) sum += member->session.refused_samples().total();
    return sum;
  }

  /// A line for each that ended otherwise than the others; `how` is added to those of a run that is over.
  void log_ends(std::string_view how) const {
    for (const auto& member : members_) {
      const AgentSession& session = member->session;
      if (session.state() == AgentSession::State::Finished) {
        spdlog::info("{}the run is over{}: {} at round {}, step {}", prefix(*member), how, name_of(session.mode()),
                     session.round(), session.step());
      } else if (!session.reason().empty()) {
        spdlog::error("{}{}", prefix(*member), session.reason());
      }
    }
  }
  /// Says once that the world has fallen silent, and once that it ticks again.
  void log_silence(double now_s) {
    const bool silent = heard_world() && now_s - heard_world_s() > kSilence_s;
    if (silent == std::exchange(silent_, silent)) return;
    if (silent) {
      spdlog::warn("no tick from the world for {} s, holding", kSilence_s);
    } else {
      spdlog::info("the world ticks again");
    }
  }
  void log_signal(int signal, bool heard) const {
    for (const auto& member : members_) {
      spdlog::info("{}ended by signal {}{} at round {}, step {}", prefix(*member), signal, heard ? "" : ", unheard,",
                   member->session.round(), member->session.step());
    }
  }

 private:
  struct Member {
    AgentId id;
    AgentSession session;
    AgentMode mode = AgentMode::Waiting;
    Member(AgentId own_id, AgentSession own) : id(own_id), session(std::move(own)) {}
  };

  [[nodiscard]] static bool active(const Member& member) {
    const AgentSession::State state = member.session.state();
    return state == AgentSession::State::Introducing || state == AgentSession::State::Live;
  }
  [[nodiscard]] std::string prefix(const Member& member) const {
    return members_.size() == 1 ? "" : fmt::format("agent {}: ", member.id);
  }
  /// Logs what changed since the last call.
  void log_course(Member& member) const {
    const AgentSession& session = member.session;
    if (session.mode() == member.mode) return;
    member.mode = session.mode();
    spdlog::info("{}{} at round {}, step {}", prefix(member), name_of(member.mode), session.round(), session.step());
  }

  std::vector<std::unique_ptr<Member>> members_;
  bool silent_ = false;
};

int goodbye(Sessions& sessions, bus::DdsAgentGroup& group) {
  sessions.leave(steady_now_s());
  const bool heard = group.flush(std::chrono::milliseconds(500));
  if (sessions.refused_samples() + group.lost() > 0) {
    spdlog::warn("{} samples refused, {} lost", sessions.refused_samples(), group.lost());
  }
  sessions.log_ends(heard ? "" : " (last beacon unheard)");
  if (sessions.any(AgentSession::State::TurnedAway)) return kStartUp;
  return sessions.any(AgentSession::State::Dropped) ? kLost : 0;
}

/// Whether the process has waited for a world for too long, and says so.
bool lacks_world(const AgentArguments& arguments, bool heard, double heard_s) {
  const double default_s = heard ? kWorldTimeout_s : arguments.common.startup_timeout_s;
  const double limit_s = arguments.world_timeout_s.value_or(default_s);
  if (steady_now_s() - heard_s <= limit_s) return false;
  spdlog::error("no tick of a world for {} s", limit_s);
  return true;
}

/// A participant of another network would be deaf in this one; who takes part and hears the world is not.
template <typename Listener>
void follow_network(NetworkWatch& network, bus::DdsAgentGroup& group, const Listener& listener, bool takes_part) {
  const double now_s = steady_now_s();
  const bool in_need = !takes_part || now_s - listener.heard_world_s() > kInNeed_s;
  if (const auto what = network.follow(
          in_need, [&] { group.renew(); }, now_s))
    spdlog::warn("{}", *what);
}

/// The id that the world gives to `nonce`, over a participant that is gone when this returns: who has an id is matched
/// otherwise. @return the exit code of a process that gets none
std::variant<AgentId, int> ask_for_id(const AgentArguments& arguments, std::uint64_t nonce,
                                      const SignalWatch& signals) {
  const std::vector<AgentId> nobody{kWorldId};
  NetworkWatch network;
  bus::DdsAgentGroup group(dds_config(arguments.common, kWorldId, random_id()), nobody);
  IdRequest request(nonce, group.port(0), steady_now_s());
  spdlog::info("an agent without id asks swarm {} in domain {} for one", swarm_of(arguments.common),
               arguments.common.domain);
  for (double idle_s = 0.0;;) {
    wait_readable({group.wake_fd(), signals.fd(), network.fd()}, idle_s);
    if (const auto signal = signals.take()) {
      request.leave(steady_now_s());
      spdlog::info("ended by signal {}{}, without an id", *signal,
                   group.flush(std::chrono::milliseconds(500)) ? "" : ", unheard");
      return 128 + *signal;
    }
    follow_network(network, group, request, request.heard_world());
    if (const auto conflict = group.conflict()) {
      spdlog::error("{}", *conflict);
      return kStartUp;
    }
    request.poll(steady_now_s());
    if (request.id()) return *request.id();
    if (request.over()) {
      spdlog::error("the world ended before it had an id for this agent");
      return kStartUp;
    }
    if (lacks_world(arguments, request.heard_world(), request.heard_world_s())) return kStartUp;
    idle_s = request.idle_s(steady_now_s());
  }
}

int serve(AgentArguments arguments) {
  const SignalWatch signals({SIGINT, SIGTERM});
  const std::uint64_t nonce = random_id();
  if (arguments.ids.empty()) {
    const auto given = ask_for_id(arguments, nonce, signals);
    if (const auto* exit_code = std::get_if<int>(&given)) return *exit_code;
    arguments.ids = {std::get<AgentId>(given)};
  }
  Turn turn;
  NetworkWatch network;
  bus::DdsAgentGroup group(dds_config(arguments.common, arguments.ids.front(), nonce), arguments.ids,
                           [&turn] { return turn.take(); });
  Sessions sessions(arguments.ids, nonce, group, steady_now_s());
  spdlog::info("agent {} introduces itself to swarm {} in domain {}", text_of(arguments.ids),
               swarm_of(arguments.common), arguments.common.domain);
  const auto serve_sessions = [&] {
    group.receive();
    sessions.poll();
    sessions.log_silence(steady_now_s());
    return sessions.go_on();
  };
  const Turn::Service service(turn, serve_sessions);
  for (double idle_s = 0.0;;) {
    wait_readable({group.wake_fd(), signals.fd(), network.fd()}, std::min(idle_s, kLook_s));
    const auto lock = turn.own();
    if (const auto signal = signals.take()) {
      sessions.leave(steady_now_s());
      sessions.log_signal(*signal, group.flush(std::chrono::milliseconds(500)));
      return 128 + *signal;
    }
    follow_network(network, group, sessions, !sessions.any(AgentSession::State::Introducing));
    if (const auto conflict = group.conflict()) {
      spdlog::error("{}", *conflict);
      return kStartUp;
    }
    if (!serve_sessions()) return goodbye(sessions, group);
    if (lacks_world(arguments, sessions.heard_world(), sessions.heard_world_s())) return kStartUp;
    idle_s = sessions.idle_s(steady_now_s());
  }
}

}  // namespace

int run_agent(const AgentArguments& arguments) {
  start_log(arguments.ids.empty() ? "skein-agent" : fmt::format("skein-agent-{}", text_of(arguments.ids)),
            arguments.common);
  try {
    return serve(arguments);
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return kStartUp;
  }
}

}  // namespace skein
