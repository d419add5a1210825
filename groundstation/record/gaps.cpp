#include "groundstation/record/gaps.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "groundstation/record/sample_head.hpp"

namespace skein {

void Gaps::note(const bus::RawSample& sample, bool is_world, AgentId agent) {
  const auto [place, is_new] = writers_.try_emplace(sample.writer);
  Writer& writer = place->second;
  if (is_new) writer = {sample.topic, is_world, agent, sample.sequence, sample.sequence, 0, {}};
  writer.first = std::min(writer.first, sample.sequence);
  writer.last = std::max(writer.last, sample.sequence);
  ++writer.kept;
}

void Gaps::conclude(const HeardEnds& ends) {
  concluded_ = true;
  for (auto& [key, writer] : writers_) writer.tail = ends.of(key);
}

bool Gaps::end_heard() const {
  const bool any = std::ranges::any_of(writers_, [](const auto& item) { return item.second.tail.heard.has_value(); });
  return any && std::ranges::all_of(writers_, [](const auto& item) { return item.second.tail.heard.value_or(true); });
}

std::uint64_t Gaps::lost() const {
  std::uint64_t sum = 0;
  for (const auto& [key, writer] : writers_) sum += writer.lost();
  return sum;
}

mcap::Texts Gaps::texts() const {
  mcap::Texts texts{{"lost", std::to_string(lost())}};
  if (concluded_) texts["end_heard"] = end_heard() ? "true" : "false";
  for (const auto& [key, writer] : writers_) {
    std::string name = name_of(writer);
    for (int copy = 2; texts.contains(name); ++copy) name = fmt::format("{} #{}", name_of(writer), copy);
    texts[name] = fmt::format("kept {} lost {} from {} to {}", writer.kept, writer.lost(), writer.first, writer.last);
    if (concluded_ && writer.tail.heard == false) texts[name] += ", end not heard";
  }
  return texts;
}

std::string name_of(const Gaps::Writer& writer) {
  const auto topic = bus::topic(writer.topic).name;
  const std::string who = writer_of(writer.topic, writer.is_world, writer.agent);
  if (writer.topic == bus::TopicId::Sense) return fmt::format("{} of {} for agent {}", topic, who, writer.agent);
  return fmt::format("{} of {}", topic, who);
}

}  // namespace skein
