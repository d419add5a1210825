// A process that was started without an id asks the world for one: it introduces itself as agent 0 under its nonce,
// every 0.25 s, until a tick says which id the world holds for that nonce (simworld/lockstep/admission.hpp). It then
// takes part as any agent with that id and nonce does. While every id is held it waits. Time comes from the caller, in
// seconds of any steady clock.
#pragma once

#include <optional>
#include <vector>

#include "idl/bus/port.hpp"
#include "idl/convert/convert.hpp"

namespace skein {

class IdRequest {
 public:
  /// @param nonce under which the process will take part; its port may announce another
  IdRequest(std::uint64_t nonce, bus::AgentPort& port, double now_s);

  /// Takes what arrived and does what is due.
  void poll(double now_s);
  /// Seconds until the next poll has something to do, if nothing arrives before.
  [[nodiscard]] double idle_s(double now_s) const;
  /// Says goodbye: the world holds no id for the nonce any more.
  void leave(double now_s);

  /// The id, once the world has said it.
  [[nodiscard]] std::optional<AgentId> id() const { return id_; }
  /// Whether the world ended its run without saying one.
  [[nodiscard]] bool over() const { return over_; }
  /// When a tick of any phase was last heard; the time of construction before the first.
  [[nodiscard]] double heard_world_s() const { return heard_world_s_; }
  [[nodiscard]] bool heard_world() const { return heard_world_; }

 private:
  void on_tick(const wire::Tick& sample, double now_s);
  void send(AgentMode mode, double now_s);

  std::uint64_t nonce_;
  bus::AgentPort& port_;
  std::optional<AgentId> id_;
  bool over_ = false;
  bool heard_world_ = false;
  double heard_world_s_;
  double last_sent_s_ = -1e9;
  std::uint32_t round_ = 0;  ///< of the newest tick
  std::vector<bus::AgentInbound> inbox_;
};

}  // namespace skein
