#include "groundstation/schema/topics.hpp"

#include <algorithm>

#include "groundstation/schema/texts.hpp"

namespace skein::schema {

std::string_view idl_of(bus::TopicId topic) {
  const std::string_view name = bus::topic(topic).name;
  return idl_text(name.substr(name.find('/') + 1));
}

const Struct& type_of(bus::TopicId topic) {
  static const auto all = [] {
    std::array<Struct, bus::kTopics.size()> types;
    for (const bus::TopicSpec& spec : bus::kTopics) {
      types[static_cast<std::size_t>(spec.id)] = parse_idl(idl_of(spec.id), spec.type);
    }
    return types;
  }();
  return all[static_cast<std::size_t>(topic)];
}

const bus::TopicSpec* topic_named(std::string_view name) {
  const auto found = std::ranges::find(bus::kTopics, name, &bus::TopicSpec::name);
  return found == bus::kTopics.end() ? nullptr : &*found;
}

}  // namespace skein::schema
