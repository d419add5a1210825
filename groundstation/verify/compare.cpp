#include "groundstation/verify/compare.hpp"

#include <fmt/core.h>

#include <set>

#include "groundstation/schema/decode.hpp"
#include "groundstation/schema/topics.hpp"

namespace skein {
namespace {

using Samples = std::map<SampleName, Bytes>;

/// The sample of that name, or else of the same round, topic and agent.
Samples::const_iterator counterpart(const Samples& samples, const SampleName& name) {
  if (const auto same = samples.find(name); same != samples.end()) return same;
  const auto near = samples.lower_bound({name.round, name.topic, name.agent, 0});
  const bool is_near = near != samples.end() && near->first.round == name.round && near->first.topic == name.topic &&
                       near->first.agent == name.agent;
  return is_near ? near : samples.end();
}

RunDifference difference_in(const SampleName& name, const Bytes& a, const Bytes& b) {
  const auto& type = schema::type_of(name.topic);
  const auto fields_a = schema::decode(type, a);
  const auto fields_b = schema::decode(type, b);
  if (fields_a && fields_b) {
    if (auto found = schema::first_difference(*fields_a, *fields_b)) {
      return {name, std::move(found->field), std::move(found->a), std::move(found->b)};
    }
  }
  return {name, "a value that is no number", nullptr, nullptr};
}

/// Of a sample that one run lacks: the field at which what it has instead stops being one.
std::optional<RunDifference> fault_in(const SampleName& name, const Bytes& whole, const RecordedRun& other, bool is_b) {
  const auto broken = other.broken().find(name);
  if (broken == other.broken().end()) return std::nullopt;
  const auto& type = schema::type_of(name.topic);
  auto fault = schema::first_null(schema::decode_partly(type, whole), schema::decode_partly(type, broken->second));
  if (!fault || fault->field.empty()) return std::nullopt;
  if (!is_b) std::swap(fault->a, fault->b);
  return RunDifference{name, fault->field, fault->a, fault->b};
}

nlohmann::ordered_json presence(bool there) {
  return there ? nlohmann::ordered_json("there") : nlohmann::ordered_json(nullptr);
}

std::string who(const SampleName& name) {
  return name.agent == kWorldId ? "the world" : fmt::format("agent {}", name.agent);
}

}  // namespace

Comparison compare(const RecordedRun& a, const RecordedRun& b, std::uint32_t before) {
  std::set<SampleName> names;
  for (const RecordedRun* run : {&a, &b}) {
    for (const auto& [name, bytes] : run->samples()) {
      if (name.round < before && run->counts(name)) names.insert(name);
    }
  }
  Comparison comparison;
  for (const SampleName& name : names) {
    const auto in_a = counterpart(a.samples(), name);
    const auto in_b = counterpart(b.samples(), name);
    const bool has_a = in_a != a.samples().end();
    const bool has_b = in_b != b.samples().end();
    if (!has_a || !has_b) {
      comparison.difference = RunDifference{name, "", presence(has_a), presence(has_b)};
      const auto fault = fault_in(name, has_a ? in_a->second : in_b->second, has_a ? b : a, has_a);
      if (fault) comparison.difference = fault;
      return comparison;
    }
    if (in_a->second != in_b->second) {
      comparison.difference = difference_in(name, in_a->second, in_b->second);
      return comparison;
    }
    ++comparison.samples;
    comparison.rounds = name.round;
  }
  return comparison;
}

std::string text_of(const Comparison& comparison) {
  if (!comparison.difference) {
    return fmt::format("equal: {} samples of {} rounds", comparison.samples, comparison.rounds);
  }
  const RunDifference& found = *comparison.difference;
  const std::string place =
      fmt::format("round {}, {}, {}", found.where.round, who(found.where), bus::topic(found.where.topic).name);
  if (found.field.empty()) {
    return fmt::format("different: {}: the sample is only in {}", place, found.a.is_null() ? "B" : "A");
  }
  const auto text = [](const nlohmann::ordered_json& value) { return value.is_null() ? "no value" : value.dump(); };
  return fmt::format("different: {}, field {}: A {}, B {}", place, found.field, text(found.a), text(found.b));
}

nlohmann::ordered_json json_of(const Comparison& comparison) {
  nlohmann::ordered_json json{{"equal", !comparison.difference},
                              {"samples", comparison.samples},
                              {"rounds", comparison.rounds},
                              {"difference", nullptr}};
  if (!comparison.difference) return json;
  const RunDifference& found = *comparison.difference;
  json["difference"] = {{"round", found.where.round},
                        {"topic", bus::topic(found.where.topic).name},
                        {"agent", found.where.agent},
                        {"incarnation", found.where.incarnation},
                        {"field", found.field},
                        {"a", found.a},
                        {"b", found.b}};
  return json;
}

}  // namespace skein
