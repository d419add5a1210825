#include "simworld/scenario/overrides.hpp"

#include <fmt/core.h>

#include "simworld/scenario/scenario.hpp"

namespace skein::scenario {
namespace {

YamlNode& item_named(YamlNode& list, const std::string& name, const std::string& path, const Place& place) {
  std::string names;
  for (std::size_t i = 0; i < list.children.size(); ++i) {
    const std::string item = item_name(list, i);
    if (item == name) return list.children[i];
    if (i < 8) names += (i == 0 ? "" : ", ") + item;
  }
  if (list.children.size() > 8) names += ", ...";
  throw ReadFault(place, fmt::format("{} has no item {}; allowed: {}", path, quote_text(name),
                                     names.empty() ? "none, the list is empty" : names));
}

YamlNode& entry_named(YamlNode& map, const std::string& name, const std::string& path, const Place& place) {
  if (map.kind == NodeKind::Null) map.kind = NodeKind::Map;
  if (map.kind != NodeKind::Map) {
    throw ReadFault(place, fmt::format("{} is a single value and has no part {}; allowed: --set {}=VALUE", path,
                                       quote_text(name), path));
  }
  if (YamlNode* entry = map.find(name)) return *entry;
  YamlNode& entry = map.children.emplace_back();
  entry.key = name;
  entry.key_place = place;
  entry.place = place;
  return entry;
}

}  // namespace

std::string item_name(const YamlNode& list, std::size_t index) {
  const YamlNode* id = list.children[index].find("id");
  return id != nullptr && id->kind == NodeKind::Scalar ? id->text : std::to_string(index + 1);
}

std::string key_of(const YamlNode& root, const std::string& key) {
  if (key != kAgentsFlag && key != kControllerFlag) return key;
  if (key == kControllerFlag) return "controller.name";
  const YamlNode* kind = root.kind == NodeKind::Map ? root.find("kind") : nullptr;
  const YamlNode* vehicles = root.kind == NodeKind::Map ? root.find("vehicles") : nullptr;
  if (kind == nullptr || kind->text != "transit") return "vehicles.ring.agents";
  return vehicles != nullptr && vehicles->find("swap") != nullptr ? "vehicles.swap.agents" : "vehicles.agents";
}

void apply_override(YamlNode& root, const std::string& key, const std::string& value) {
  const Place place{1, 1, key.empty() ? "''" : key};
  YamlNode* node = &root;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    const std::string part = key.substr(begin, end - begin);
    if (part.empty()) {
      throw ReadFault(place, "the key has an empty part; allowed: words joined by dots, such as planner.particles");
    }
    const std::string path = begin == 0 ? "the scenario" : key.substr(0, begin - 1);
    node =
        node->kind == NodeKind::List ? &item_named(*node, part, path, place) : &entry_named(*node, part, path, place);
    begin = end + 1;
  }
  YamlNode set = parse_yaml(value, key);
  set.key = node->key;
  set.key_place = node->key_place;
  set.place = place;
  *node = std::move(set);
}

}  // namespace skein::scenario
