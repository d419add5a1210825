#include "groundstation/replay/score.hpp"

#include <fmt/core.h>

#include <charconv>
#include <optional>
#include <set>
#include <stdexcept>

#include "groundstation/record/sample_head.hpp"
#include "groundstation/schema/topics.hpp"
#include "groundstation/verify/rerun.hpp"

namespace skein::replay {
namespace {

using bus::TopicId;

struct Stopped {};  ///< whoever plays wants no more

AgentId agent_of(const mcap::Channel& channel) {
  const auto found = channel.metadata.find("agent");
  AgentId agent = kWorldId;
  if (found == channel.metadata.end()) return agent;
  (void)std::from_chars(found->second.data(), found->second.data() + found->second.size(), agent);
  return agent;
}

/// The default if it is not known: no scenario, one of another version, one whose mesh is elsewhere.
double round_s_of(const mcap::Reader& file) {
  try {
    return scenario_of(file).lockstep.round_s;
  } catch (const mcap::Damaged&) {
    throw;
  } catch (const std::runtime_error&) {
    return LockstepOptions().round_s;
  }
}

}  // namespace

Score::Score(const mcap::Reader& file) : file_(file), round_s_(round_s_of(file)) {
  take_channels();
  take_run();
}

void Score::take_channels() {
  std::set<bus::ReplayWriter> writers;
  for (const auto& [id, channel] : file_.contents().channels) {
    const bus::TopicSpec* spec = schema::topic_named(channel.topic);
    const auto schema = file_.contents().schemas.find(channel.schema_id);
    if (spec == nullptr || schema == file_.contents().schemas.end()) continue;
    if (schema->second.name != spec->type) {
      throw std::runtime_error(
          fmt::format("its samples are {}; this version plays {}", schema->second.name, spec->type));
    }
    const auto writer = channel.metadata.find("writer");
    const bool from_world = writer != channel.metadata.end() && writer->second == "world";
    const AgentId agent = spec->per_agent ? agent_of(channel) : kWorldId;
    if (spec->per_agent && (agent < 1 || agent > kMaxAgents)) continue;
    voices_[id] = {spec, {spec->id, from_world, agent}};
    writers.insert(voices_[id].writer);
  }
  writers.insert({TopicId::Mission, true, kWorldId});
  writers.insert({TopicId::Tick, true, kWorldId});
  writers_.assign(writers.begin(), writers.end());
}

void Score::take_run() {
  std::optional<std::uint64_t> run;
  std::map<std::uint64_t, mcap::Bytes> missions;
  std::map<std::uint64_t, std::uint64_t> ends;
  std::map<std::uint64_t, std::uint64_t> samples;
  file_.for_each([&](const mcap::Message& message) {
    const auto voice = voices_.find(message.channel_id);
    const auto head = voice == voices_.end() ? std::nullopt : head_of(voice->second.topic->id, message.data);
    if (!head) {
      ++left_out_;
      return;
    }
    const TopicId topic = voice->second.topic->id;
    if (topic == TopicId::Mission) missions.try_emplace(head->run, message.data.begin(), message.data.end());
    if (topic == TopicId::Tick && head->round > 0 && !run) run = head->run;
    ends[head->run] = std::max(ends[head->run], message.log_time);
    ++samples[head->run];
  });
  if (!run) throw std::runtime_error("it holds no round of a run");
  const auto mission = missions.find(*run);
  if (mission == missions.end()) throw std::runtime_error("it lacks the mission of its run");
  run_ = *run;
  mission_ = mission->second;
  end_ = ends[run_];
  for (const auto& [other, count] : samples) left_out_ += other == run_ || other == 0 ? 0 : count;
}

bool Score::is_of_run(const Voice& voice, std::span<const std::uint8_t> payload) const {
  const auto head = head_of(voice.topic->id, payload);
  return head && (head->run == run_ || head->run == 0);
}

void Score::play(std::uint64_t from, const std::function<bool(const Note&)>& play) const {
  try {
    file_.for_each({}, from, UINT64_MAX, [&](const mcap::Message& message) {
      const auto voice = voices_.find(message.channel_id);
      if (voice == voices_.end() || voice->second.topic->id == TopicId::Mission) return;
      if (!is_of_run(voice->second, message.data)) return;
      if (!play({voice->second.writer, message.log_time, message.data})) throw Stopped();
    });
  } catch (const Stopped&) {
    return;
  }
}

}  // namespace skein::replay
