#include "groundstation/record/recording.hpp"

#include <fmt/core.h>

#include "groundstation/schema/topics.hpp"
#include "idl/convert/cdr.hpp"
#include "simworld/report/report.hpp"

namespace skein {
namespace {

mcap::Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

mcap::Texts facts_of(const RecordingOrigin& origin) {
  const Scenario& scenario = *origin.scenario;
  nlohmann::json overrides = nlohmann::json::array();
  for (const Override& item : scenario.overrides) overrides.push_back({{"key", item.key}, {"value", item.value}});
  return {{"path", scenario.path},
          {"scenario_hash", fmt::format("{:016x}", scenario.scenario_hash)},
          {"seed", std::to_string(scenario.mission.seed)},
          {"overrides", overrides.dump()},
          {"fail_fast", origin.fail_fast ? "true" : "false"}};
}

}  // namespace

Recording::Recording(mcap::Writer::Sink sink, const RecordingOrigin& origin)
    : writer_(std::move(sink), {fmt::format("skein {}", version())}) {
  writer_.add_metadata({"skein",
                        {{"recorder", origin.recorder},
                         {"swarm", origin.swarm},
                         {"version", std::string(version())},
                         {"wire_version", std::to_string(wire::kWireVersion)}}});
  if (origin.scenario == nullptr) return;
  writer_.attach({0, 0, kScenarioName, "application/yaml", bytes_of(origin.scenario->text), 0});
  writer_.add_metadata({"skein.scenario", facts_of(origin)});
}

void Recording::add(const TakenSample& sample) {
  const std::optional<SampleHead> head = head_of(sample.topic, sample.payload);
  if (!head) {
    ++refused_;
    return;
  }
  note_run(sample, *head);
  note_time(sample, *head);
  Known& known = channel(sample, head->agent);
  ++known.counted;
  const bool of_round = bus::topic(sample.topic).writers != bus::kObserverRole;
  mcap::Message message;
  message.channel_id = known.id;
  message.sequence = sample.sequence == 0 ? known.counted : static_cast<std::uint32_t>(sample.sequence);
  message.log_time = time_of(of_round ? head->round : newest());
  message.publish_time = static_cast<std::uint64_t>(head->stamp_ns);
  message.data = sample.payload;
  writer_.write(message);
}

/// What the mission says of the run, once for each run.
void Recording::note_run(const TakenSample& sample, const SampleHead& head) {
  if (sample.topic != bus::TopicId::Mission || run_ == head.run) return;
  const auto mission = from_cdr<wire::Mission>(sample.payload);
  if (!mission) return;
  run_ = head.run;
  times_.clear();
  writer_.add_metadata({"skein.run",
                        {{"run", fmt::format("{:016x}", head.run)},
                         {"seed", std::to_string(mission->seed())},
                         {"scenario", mission->name().to_string()}}});
}

void Recording::note_time(const TakenSample& sample, const SampleHead& head) {
  if (sample.topic != bus::TopicId::Tick || times_.contains(head.round)) return;
  const auto tick = from_cdr<wire::Tick>(sample.payload);
  const bool sound = tick && tick->time_s() >= 0.0 && tick->time_s() < 1e9;
  if (sound) times_[head.round] = static_cast<std::uint64_t>(tick->time_s() * 1e9) + head.round;
}

/// Of a round whose tick is not there: as if time stood still since the one before.
std::uint64_t Recording::time_of(std::uint32_t round) const {
  auto known = times_.upper_bound(round);
  if (known == times_.begin()) return round;
  --known;
  return known->second + (round - known->first);
}

Recording::Known& Recording::channel(const TakenSample& sample, AgentId agent) {
  const auto [place, is_new] = channels_.try_emplace({sample.topic, sample.from_world, agent});
  if (!is_new) return place->second;
  const bus::TopicSpec& spec = bus::topic(sample.topic);
  if (!schemas_.contains(spec.id)) {
    schemas_[spec.id] = writer_.add_schema(std::string(spec.type), "omgidl", bytes_of(schema::idl_of(spec.id)));
  }
  mcap::Texts texts{{"writer", writer_of(sample.topic, sample.from_world, agent)}};
  if (spec.keyed) texts["agent"] = std::to_string(agent);
  place->second.id = writer_.add_channel(schemas_[spec.id], std::string(spec.name), "cdr", texts);
  return place->second;
}

void Recording::finish(const mcap::Texts& kept, const nlohmann::ordered_json& report) {
  if (!report.is_null()) {
    writer_.attach({0, 0, kReportName, "application/json", bytes_of(report.dump(2)), 0});
  }
  mcap::Texts texts = kept;
  texts["samples"] = std::to_string(samples());
  texts["refused"] = std::to_string(refused_);
  writer_.add_metadata({"skein.kept", texts});
  writer_.finish();
}

}  // namespace skein
