// Changes to a scenario from the command line: --set KEY=VALUE, applied to the tree before anything is read from it.
//
// A key is a dotted path. A part names a map's key; in a list it names the item with that `id`, or, in a list without
// ids, the item's place, from 1. The value is YAML. What is not there yet is added, so that the reader reports an
// unknown key as it would in the file, but names the override. Source, Departs from source: none. Complexity: O(parts).
#pragma once

#include <string>

#include "simworld/scenario/yaml_tree.hpp"

namespace skein::scenario {

/// The key that an override's stands for in this scenario: itself, unless it is that of a flag.
/// @throws ReadFault for one that the kind does not have
[[nodiscard]] std::string key_of(const YamlNode& root, const std::string& key);

/// Sets one key of the scenario. @throws ReadFault, placed at the override
void apply_override(YamlNode& root, const std::string& key, const std::string& value);

/// How a list's item is called in paths and messages: by its id, or by its place, from 1.
[[nodiscard]] std::string item_name(const YamlNode& list, std::size_t index);

}  // namespace skein::scenario
