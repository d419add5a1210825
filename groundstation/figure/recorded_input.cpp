#include "groundstation/figure/recorded_input.hpp"

#include <fmt/core.h>

#include "groundstation/mcap/file.hpp"
#include "groundstation/mcap/reader.hpp"
#include "groundstation/record/recording.hpp"
#include "groundstation/schema/topics.hpp"
#include "groundstation/verify/rerun.hpp"

namespace skein::figure {
namespace {

/// Does something that a damaged file may not allow; what it does not allow is noted.
void attempt(RunInput& input, const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    input.notes.push_back(error.what());
  }
}

/// "1 sample was", "7 samples were".
std::string samples_that(const std::string& count, const char* of_one, const char* of_many) {
  return count == "1" ? fmt::format("1 sample {}", of_one) : fmt::format("{} samples {}", count, of_many);
}

/// The mission first: it says which run it is.
RunCollector collect(const mcap::Reader& reader, RunInput& input) {
  RunCollector collector;
  std::map<std::uint16_t, const bus::TopicSpec*> topics;
  for (const auto& [id, channel] : reader.contents().channels) topics[id] = schema::topic_named(channel.topic);
  std::string damage;
  for (const bool missions : {true, false}) {
    try {
      reader.for_each([&](const mcap::Message& message) {
        const bus::TopicSpec* spec = topics[message.channel_id];
        if (spec != nullptr && (spec->id == bus::TopicId::Mission) == missions) collector.add(spec->id, message.data);
      });
    } catch (const mcap::Damaged& error) {
      damage = error.what();
    }
  }
  if (!damage.empty()) input.notes.push_back(fmt::format("the file is damaged: {}; what follows is not drawn", damage));
  return collector;
}

std::string fact(const mcap::Texts& texts, const std::string& name) {
  const auto found = texts.find(name);
  return found == texts.end() ? "" : found->second;
}

void take_facts(const mcap::Reader& reader, RunInput& input) {
  if (const auto about = reader.metadata("skein")) {
    for (const char* name : {"recorder", "swarm", "version", "wire_version"})
      input.facts[name] = fact(about->texts, name);
  }
  if (const auto kept = reader.metadata("skein.kept")) {
    for (const char* name : {"samples", "lost", "refused"}) input.facts[name] = fact(kept->texts, name);
    const std::string lost = fact(kept->texts, "lost");
    if (!lost.empty() && lost != "0")
      input.notes.push_back(samples_that(lost, "was", "were") + " lost while recording");
    if (fact(kept->texts, "end_heard") == "false") {
      input.notes.push_back("the end was not heard while recording: more may be lost than was counted");
    }
  }
  if (const auto report = reader.attachment(kReportName)) {
    input.report = Json::parse(report->data, nullptr, false);
    if (!input.report.is_object()) input.report = nullptr;
  }
}

void take_scenario(const mcap::Reader& reader, RunInput& input) {
  if (const auto attached = reader.attachment(kScenarioName)) {
    input.scenario_text.assign(attached->data.begin(), attached->data.end());
  }
  if (!reader.metadata("skein.scenario")) {
    if (!input.data.mission.transit) return;
    throw std::runtime_error(
        "the file does not hold its scenario: obstacles that agents are not told of are not drawn");
  }
  const Scenario scenario = scenario_of(reader);
  input.scenario_path = scenario.path;
  input.overrides = scenario.overrides;
  for (const Obstacle& hidden : scenario.world.hidden) input.outlines.push_back(outline_of(hidden));
}

}  // namespace

RunInput input_of_recording(const std::string& path) {
  RunInput input;
  input.name = path;
  try {
    const mcap::MappedFile file(path);
    const mcap::Reader reader(file.bytes());
    if (!reader.missing().empty()) input.notes.push_back(fmt::format("the file is not whole: {}", reader.missing()));
    const RunCollector collector = collect(reader, input);
    if (!collector.has_mission()) throw std::runtime_error("it holds no mission, hence nothing to draw");
    if (const std::string bad = std::to_string(collector.unreadable()); bad != "0") {
      input.notes.push_back(samples_that(bad, "cannot be read and is", "cannot be read and are") + " left out");
    }
    input.data = collector.data();
    for (const Zone& zone : input.data.mission.zones) input.outlines.push_back(outline_of(zone));
    for (const Announcement& item : input.data.mission.announced) input.outlines.push_back(outline_of(item));
    attempt(input, [&] { take_facts(reader, input); });
    attempt(input, [&] { take_scenario(reader, input); });
  } catch (const std::exception& error) {
    const std::string what = error.what();
    throw std::runtime_error(what.starts_with(path + ":") ? what : fmt::format("{}: {}", path, what));
  }
  return input;
}

}  // namespace skein::figure
