// The agent's end of the lockstep protocol, over any carrier: introduces itself, answers each tick once all that the
// tick counts is here, and repeats its answer when asked. Receive, convert, decide (agent/behaviours), convert, send.
//
// Until a tick's roster admits it, it sends a beacon with incarnation 0 every 0.25 s, and whenever its matched peers
// change. A tick counts samples of the round before (0 or 1 an agent); they are taken in order of id, never of arrival.
// What is still lacking after a second is named in an open beacon, again every second. A repeated tick is answered from
// the stored outputs. An agent that finds itself dropped discards all but the mission and introduces itself again; who
// comes back, so or as a new process, does so under an incarnation over 1. Time comes from the caller, in seconds of
// any steady clock.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agent/behaviours/behaviour.hpp"
#include "agent/runtime/peer_samples.hpp"
#include "idl/bus/port.hpp"
#include "idl/convert/convert.hpp"

namespace skein {

class AgentSession {
 public:
  enum class State : std::uint8_t {
    Introducing,  ///< not admitted yet
    Live,         ///< takes part
    Finished,     ///< the world ended the run, and the agent had taken part
    TurnedAway,   ///< refused, or the world ended before the run started
    Dropped,      ///< the world went on without it, and ended
  };

  /// @param nonce the process's own, as its port announces it
  AgentSession(AgentId id, std::uint64_t nonce, bus::AgentPort& port, double now_s);

  /// Takes what arrived and does what is due.
  void poll(double now_s);
  /// Seconds until the next poll has something to do, if nothing arrives before.
  [[nodiscard]] double idle_s(double now_s) const;
  /// Says goodbye: the world drops the agent at once.
  void leave(double now_s);

  [[nodiscard]] State state() const { return state_; }
  /// One line for TurnedAway and Dropped.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// When a tick of any phase was last heard; the time of construction before the first. Time in which this process was
  /// itself stopped counts against nobody.
  [[nodiscard]] double heard_world_s() const { return heard_world_s_; }
  /// Whether a tick was ever heard.
  [[nodiscard]] bool heard_world() const { return ever_heard_; }
  [[nodiscard]] std::uint32_t round() const { return done_round_; }
  [[nodiscard]] std::uint32_t step() const { return tick_ ? tick_->step : 0; }
  [[nodiscard]] AgentMode mode() const { return last_.mode; }
  [[nodiscard]] const FaultCounts& refused_samples() const { return faults_; }

 private:
  void act(double now_s);
  void take(double now_s);
  void on_sample(const wire::Mission& sample, double now_s);
  void on_sample(const wire::Tick& sample, double now_s);
  void on_sample(const wire::Sense& sample, double now_s);
  void on_sample(const wire::Representative& sample, double now_s);
  void on_sample(const wire::ObstacleMap& sample, double now_s);
  /// A sample that a peer shares with all agents, kept if it may count. @param usable as PeerSamples takes it
  template <typename Sample, typename Wire, typename Usable>
  void hear(const Wire& sample, PeerSamples<Sample>& heard, const Usable& usable);
  /// The round that the newest tick opens; peers and world are ahead of it by one at most.
  [[nodiscard]] std::uint32_t open_round() const { return tick_ ? tick_->round : 0; }
  /// Whether the roster, as far as it is known, lets the sample count.
  template <typename Sample>
  [[nodiscard]] bool may_count(const Sample& sample) const;
  void introduce(double now_s);
  void follow_roster();
  void become_live(std::uint32_t incarnation);
  void start_over();
  void forget_peers();
  [[nodiscard]] std::vector<Need> lacking() const;
  void answer(double now_s);
  void obey();
  template <typename Sample>
  void sign(Sample& sample) const;
  void publish_answer(double now_s);
  [[nodiscard]] Beacon beacon() const;
  template <typename Value>
  void send(const Value& value, double now_s);

  AgentId id_;
  std::uint64_t nonce_;
  bus::AgentPort& port_;
  State state_ = State::Introducing;
  std::string reason_;
  std::uint64_t run_ = 0;
  std::uint32_t incarnation_ = 0;
  Mission mission_;
  std::vector<AgentId> ids_;
  std::optional<CellGrid> grid_;  ///< of a transit
  std::unique_ptr<Behaviour> behaviour_;
  std::optional<Tick> tick_;  ///< the newest
  std::optional<Sense> sense_;
  PeerSamples<Representative> heard_;  ///< one that the behaviour cannot use is heard, but counts as left out
  PeerSamples<ObstacleMapSample> heard_maps_;
  std::uint32_t done_round_ = 0;
  std::vector<std::uint64_t> matched_;  ///< as last introduced
  RoundOutput last_;
  std::optional<Representative> sent_;
  std::optional<ObstacleMapSample> sent_map_;
  std::uint64_t state_hash_ = 0;
  std::vector<std::uint64_t> acknowledged_;  ///< orders of the round that was answered last
  bool dropped_ = false;                     ///< it was live before
  std::optional<RefusalReason> refused_;
  double heard_world_s_;
  bool ever_heard_ = false;
  std::optional<double> last_poll_s_;
  double last_sent_s_ = -1e9;
  double tick_heard_s_ = 0.0;
  bool repeat_ = false;
  std::vector<bus::AgentInbound> inbox_;
  FaultCounts faults_;
};

}  // namespace skein
