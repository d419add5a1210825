#include "groundstation/watch/figures.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "groundstation/watch/events.hpp"
#include "planner/core/lockstep/names.hpp"

namespace skein::watch {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

Json agent_json(const AgentView& agent) {
  Json json{{"id", agent.id}, {"heard", agent.heard}, {"live", agent.live}};
  if (!agent.heard) return json;
  json.update({{"incarnation", agent.incarnation},
               {"mode", name_of(agent.mode)},
               {"constraint", name_of(agent.constraint)},
               {"safety_mode", name_of(agent.safety_mode)},
               {"safety_reason", name_of(agent.safety_reason)},
               {"step", agent.step},
               {"round", agent.round}});
  json["position_m"] = nullptr;
  if (agent.position_m) json["position_m"] = {agent.position_m->x(), agent.position_m->y(), agent.position_m->z()};
  json.update({{"speed_mps", agent.speed_mps},
               {"to_go_m", or_null(agent.to_go_m)},
               {"to_go_by", agent.to_go_by == ToGoBy::Plan ? "plan" : "straight"},
               {"separation_m", or_null(agent.separation_m)},
               {"min_separation_m", or_null(agent.min_separation_m)},
               {"planned_length_m", agent.planned_length_m},
               {"cost", or_null(agent.cost)},
               {"generation", agent.generation},
               {"map_tiles", agent.map_tiles},
               {"bytes_per_s", agent.rate.bytes_per_s},
               {"samples_per_s", agent.rate.samples_per_s},
               {"age_s", or_null(agent.age_s)},
               {"late_steps", agent.late_steps}});
  return json;
}

Json event_json(const Event& event) {
  return {{"time_s", event.time_s},      {"step", event.step}, {"round", event.round},  {"agent", event.agent},
          {"kind", name_of(event.kind)}, {"what", event.what}, {"reason", event.reason}};
}

Json topic_json(const TopicView& topic) {
  Json json{{"name", bus::topic(topic.id).name}, {"type", bus::topic(topic.id).type}};
  const auto read = [&](auto value) { return topic.read ? Json(value) : Json(nullptr); };
  json.update({{"samples_per_s", read(topic.rate.samples_per_s)},
               {"bytes_per_s", read(topic.rate.bytes_per_s)},
               {"samples", read(topic.samples)},
               {"bytes", read(topic.bytes)},
               {"writers", topic.writers},
               {"readers", topic.readers}});
  return json;
}

std::string agent_line(const AgentView& agent) {
  if (!agent.heard) return fmt::format("{:>4}  not heard yet\n", agent.id);
  const char* about = agent.to_go_by == ToGoBy::Plan ? "" : "~";
  const std::string safety = agent.safety_mode == SafetyMode::Autonomous
                                 ? ""
                                 : fmt::format("  {}: {}", name_of(agent.safety_mode), name_of(agent.safety_reason));
  return fmt::format("{:>4}{} {:<11} {:>7} {:>7.2f} {:>10} {:>9} {:>9} {:>11} {:>5} {:>6} {:>8.0f} {:>6} {:>5}{}\n",
                     agent.id, agent.live ? " " : "!", name_of(agent.mode), agent.step, agent.speed_mps,
                     fmt::format("{}{}", about, number(agent.to_go_m, 1)), number(agent.separation_m, 1),
                     number(agent.min_separation_m, 1), number(agent.cost, 4), agent.generation, agent.map_tiles,
                     agent.rate.bytes_per_s, number(agent.age_s, 2), agent.late_steps, safety);
}

}  // namespace

std::string event_text(const Event& event) {
  const std::string who = event.agent == kWorldId ? "world" : fmt::format("agent {}", event.agent);
  const bool says_all = event.kind == EventKind::Phase || event.kind == EventKind::Mode ||
                        event.kind == EventKind::Safety || event.kind == EventKind::Roster;
  return fmt::format("{:.1f} s  {} {}{}{}{}{}", event.time_s, who, says_all ? "" : name_of(event.kind),
                     says_all ? "" : " ", event.what, event.reason.empty() ? "" : ": ", event.reason);
}

Json status_json(const SwarmView& view, const std::string& swarm) {
  const auto heard = [&](auto value) { return view.heard_tick ? Json(value) : Json(nullptr); };
  Json json{{"swarm", swarm},
            {"scenario", view.mission ? Json(view.mission->name) : Json(nullptr)},
            {"seed", view.mission ? Json(view.mission->seed) : Json(nullptr)},
            {"run", heard(fmt::format("{:016x}", view.run))},
            {"phase", heard(name_of(view.phase))},
            {"step", heard(view.step)},
            {"round", heard(view.round)},
            {"time_s", heard(view.time_s)},
            {"state_hash", heard(fmt::format("{:016x}", view.world_hash))},
            {"live", view.live},
            {"times_real_time", or_null(view.times_real_time)},
            {"tick_age_s", or_null(view.tick_age_s)},
            {"refused_samples", view.refused_samples}};
  json["outcome"] = nullptr;
  if (view.outcome) json["outcome"] = {{"exit_code", view.outcome->exit_code}, {"reason", view.outcome->reason}};
  json["agents"] = Json::array();
  for (const AgentView& agent : view.agents) json["agents"].push_back(agent_json(agent));
  json["known_cells"] = view.cells.states.empty() ? Json(nullptr) : Json(view.cells.known);
  json["links"] = view.links;
  json["events"] = Json::array();
  for (const Event& event : view.events) json["events"].push_back(event_json(event));
  json["topics"] = topics_json(view, swarm)["topics"];
  return json;
}

std::string status_text(const SwarmView& view, const std::string& swarm, std::size_t events) {
  std::string text = fmt::format("swarm {}, {} {}: {}, step {}, {:.1f} s, {} live, {} times real time\n", swarm,
                                 view.mission ? view.mission->name : "no mission yet",
                                 view.mission ? fmt::format("(seed {})", view.mission->seed) : "", name_of(view.phase),
                                 view.step, view.time_s, view.live, number(view.times_real_time, 1));
  text +=
      fmt::format("{:>4}  {:<11} {:>7} {:>7} {:>10} {:>9} {:>9} {:>11} {:>5} {:>6} {:>8} {:>6} {:>5}\n", "id", "mode",
                  "step", "m/s", "to go (m)", "sep (m)", "least (m)", "cost", "gen", "tiles", "bytes/s", "age", "late");
  for (const AgentView& agent : view.agents) text += agent_line(agent);
  const std::size_t from = view.events.size() > events ? view.events.size() - events : 0;
  for (std::size_t i = from; i < view.events.size(); ++i) text += event_text(view.events[i]) + "\n";
  return text;
}

Json topics_json(const SwarmView& view, const std::string& swarm) {
  Json json{{"swarm", swarm}, {"topics", Json::array()}};
  for (const TopicView& topic : view.topics) json["topics"].push_back(topic_json(topic));
  return json;
}

std::string topics_text(const SwarmView& view) {
  std::string text = fmt::format("{:<21} {:<27} {:>10} {:>11} {:>8} {:>8}\n", "topic", "type", "samples/s", "bytes/s",
                                 "writers", "readers");
  for (const TopicView& topic : view.topics) {
    const bus::TopicSpec& spec = bus::topic(topic.id);
    const auto rate = [&](double value) { return topic.read ? fmt::format("{:.1f}", value) : std::string("-"); };
    text += fmt::format("{:<21} {:<27} {:>10} {:>11} {:>8} {:>8}\n", spec.name, spec.type,
                        rate(topic.rate.samples_per_s), rate(topic.rate.bytes_per_s), topic.writers, topic.readers);
  }
  return text;
}

}  // namespace skein::watch
