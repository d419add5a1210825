#include <algorithm>

#include "groundstation/watch/swarm_watch.hpp"
#include "planner/core/radio/radio.hpp"

namespace skein::watch {
namespace {

/// Nobody is out of reach of a radio without limit, so that its links say nothing.
constexpr double kIdealRange_m = 1e6;

void add_links(SwarmView& view) {
  if (!view.mission || !view.mission->transit) return;
  const RadioOptions& radio = view.mission->transit->radio;
  if (radio.range_m >= kIdealRange_m) return;
  for (std::size_t i = 0; i < view.agents.size(); ++i) {
    for (std::size_t j = i + 1; j < view.agents.size(); ++j) {
      const AgentView& a = view.agents[i];
      const AgentView& b = view.agents[j];
      if (!a.live || !b.live || !a.position_m || !b.position_m) continue;
      if (in_range(radio, *a.position_m, *b.position_m)) view.links.push_back({a.id, b.id});
    }
  }
}

}  // namespace

SwarmView SwarmWatch::view(double now_s, const Endpoints& endpoints) {
  SwarmView view;
  view.mission = mission_;
  view.heard_tick = tick_.has_value();
  if (tick_) {
    view.run = tick_->run;
    view.phase = tick_->phase;
    view.step = tick_->step;
    view.round = tick_->round;
    view.time_s = tick_->time_s;
    view.world_hash = tick_->world_hash;
    view.live = tick_->roster.size();
    view.outcome = tick_->outcome;
    view.tick_age_s = now_s - *tick_s_;
  }
  view.times_real_time = clock_.times_real_time();
  view.refused_samples = refused_;
  view.events.assign(events_.begin(), events_.end());
  if (map_) view.cells = map_->cells();
  add_agents(view, now_s);
  add_separations(view);
  add_links(view);
  add_topics(view, now_s, endpoints);
  return view;
}

/// Those of the mission, and any other that was heard.
void SwarmWatch::add_agents(SwarmView& view, double now_s) {
  if (mission_) {
    for (const VehicleSpec& vehicle : mission_->vehicles) agent(vehicle.id);
  }
  for (auto& [id, watched] : agents_) {
    view.agents.push_back(watched.view(mission(), now_s));
    view.agents.back().live = is_live(id);
    if (map_) view.agents.back().map_tiles = map_->tiles_of(id);
  }
}

void SwarmWatch::add_separations(SwarmView& view) const {
  const auto flies = [&](const AgentView& agent) {
    const std::optional<Beacon>& beacon = agents_.at(agent.id).beacon();
    return agent.live && beacon && agents_.at(agent.id).flying_at() && !is_landed(*beacon);
  };
  for (AgentView& agent : view.agents) {
    if (flies(agent)) agent.separation_m = agents_.at(agent.id).separation_m();
  }
}

void SwarmWatch::add_topics(SwarmView& view, double now_s, const Endpoints& endpoints) const {
  for (const bus::TopicSpec& spec : bus::kTopics) {
    const auto place = static_cast<std::size_t>(spec.id);
    const RateMeter& meter = topics_[place];
    view.topics[place] = {spec.id,       spec.id != bus::TopicId::Sense, meter.at(now_s),         meter.samples(),
                          meter.bytes(), endpoints[place].writers,       endpoints[place].readers};
  }
}

}  // namespace skein::watch
