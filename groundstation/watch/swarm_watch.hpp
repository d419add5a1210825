// A running swarm as an observer follows it: takes what an observer port brings, gives what is known now.
//
// A pure function of the samples and of the times at which the caller took them. Any sample may be missing, repeated or
// late; the observer may come in the middle of a run. A tick of another run starts anew; samples of other runs than the
// last tick's are left out.
// Source: none needed. Departs from source: none. Complexity: O(agents) a beacon, O(points + cells) a view.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "groundstation/watch/agent_watch.hpp"
#include "groundstation/watch/swarm_map.hpp"
#include "groundstation/watch/view.hpp"
#include "idl/bus/dds_observer_port.hpp"

namespace skein::watch {

using Endpoints = std::array<bus::TopicEndpoints, bus::kTopics.size()>;

class SwarmWatch {
 public:
  /// Takes a sample at `now_s` of any steady clock; one that is no valid sample is counted and left out.
  void take(const bus::ObserverInbound& sample, double now_s);
  [[nodiscard]] bool heard_tick() const { return tick_.has_value(); }
  [[nodiscard]] std::optional<Outcome> outcome() const { return tick_ ? tick_->outcome : std::nullopt; }
  /// Whether every live agent was heard; false before the first tick and the mission.
  [[nodiscard]] bool complete() const;
  /// @param endpoints who writes and reads the topics
  [[nodiscard]] SwarmView view(double now_s, const Endpoints& endpoints);

 private:
  template <typename Plain, typename Wire>
  [[nodiscard]] std::optional<Plain> read(const Wire& sample, const Arrival& arrival, bus::TopicId topic);
  void on_sample(const wire::Mission& sample, double now_s);
  void on_sample(const wire::Tick& sample, double now_s);
  void on_sample(const wire::Beacon& sample, double now_s);
  void on_sample(const wire::Representative& sample, double now_s);
  void on_sample(const wire::ObstacleMap& sample, double now_s);
  [[nodiscard]] bool is_of_run(std::uint64_t run) const { return !tick_ || run == 0 || run == tick_->run; }
  AgentWatch& agent(AgentId id) { return agents_.try_emplace(id, id).first->second; }
  void start_anew();
  void judge_separations(const Beacon& beacon);
  void note_nearness(const Beacon& beacon, AgentId other, double distance_m);
  void log(std::vector<Event> events);
  [[nodiscard]] const Mission* mission() const { return mission_ ? &*mission_ : nullptr; }
  [[nodiscard]] bool is_live(AgentId id) const;
  [[nodiscard]] bool is_landed(const Beacon& beacon) const;
  void add_agents(SwarmView& view, double now_s);
  void add_separations(SwarmView& view) const;
  void add_topics(SwarmView& view, double now_s, const Endpoints& endpoints) const;

  std::optional<Mission> mission_;
  std::optional<Tick> tick_;  ///< the newest
  std::optional<double> tick_s_;
  StepClock clock_;
  std::map<AgentId, AgentWatch> agents_;
  std::optional<SwarmMap> map_;
  std::deque<Event> events_;
  std::set<std::pair<AgentId, AgentId>> near_;      ///< pairs within their safety radii
  std::set<std::pair<AgentId, AgentId>> touching_;  ///< pairs within their radii
  std::array<RateMeter, bus::kTopics.size()> topics_;
  std::uint64_t refused_ = 0;
};

}  // namespace skein::watch
