// Typed, strict reads from one map of a scenario: every fault names the key's path, the value and what is allowed.
//
// Numbers are decimal and finite, without leading zeros (octal in YAML 1.1); a number in quotes is text. Unknown keys
// are found first, so that a misspelt key is reported as such and not as a missing one.
// Source, Departs from source: none. Complexity: O(keys^2) for a map.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "simworld/scenario/yaml_tree.hpp"

namespace skein::scenario {

/// A closed range of a number, with its unit ("" for none).
struct Limits {
  double min;
  double max;
  std::string_view unit = "";
};

/// The key of `allowed` that is the fewest edits away, if that is at most a third of its length (at least 1), or "".
[[nodiscard]] std::string_view nearest_key(std::string_view key, std::span<const std::string_view> allowed);

/// The place to name for a finding about a whole list item: that of a value in it that was overridden, or its own.
[[nodiscard]] Place place_of_item(const YamlNode& item);

class MapReader {
 public:
  /// @param node the map, or nullptr if it was left out (then every key is absent)
  /// @param path dotted path of the map; empty for the whole scenario
  /// @param missing_at where to say that a key is missing
  /// @throws ReadFault if the node is no map or holds a key that is not allowed
  MapReader(const YamlNode* node, std::string path, std::span<const std::string_view> allowed, Place missing_at);

  /// A number within limits; `fallback` if the key is absent, and a fault if there is none.
  [[nodiscard]] double number(std::string_view key, const Limits& limits, std::optional<double> fallback = {}) const;
  /// A whole number from min to max.
  [[nodiscard]] std::uint64_t whole(std::string_view key, std::uint64_t min, std::uint64_t max,
                                    std::optional<std::uint64_t> fallback = {}) const;
  /// One of the words.
  [[nodiscard]] std::string word(std::string_view key, std::span<const std::string_view> words,
                                 std::optional<std::string_view> fallback = {}) const;
  /// 1 to 64 letters, digits, dots, - and _.
  [[nodiscard]] std::string name(std::string_view key) const;
  /// 1 to 256 printable characters, such as a file's name.
  [[nodiscard]] std::string text(std::string_view key) const;
  /// The items of a list, at most `max`; none if the key is absent and not required.
  [[nodiscard]] std::span<const YamlNode> list(std::string_view key, std::size_t max, bool required) const;
  /// A reader of the map under a key; of an empty one if it is absent and not required.
  [[nodiscard]] MapReader map(std::string_view key, std::span<const std::string_view> allowed, bool required) const;
  /// A reader of an item of the list under `key`.
  [[nodiscard]] MapReader item(std::string_view key, std::size_t index,
                               std::span<const std::string_view> allowed) const;

  [[nodiscard]] const YamlNode* find(std::string_view key) const;
  /// The place of a key's value; where the map is if the key is absent.
  [[nodiscard]] Place place_of(std::string_view key) const;
  [[nodiscard]] std::string path_of(std::string_view key) const;
  /// @throws ReadFault 'PATH is VALUE; allowed: ...' at the value, or '... is missing' at the map
  [[noreturn]] void refuse(std::string_view key, std::string_view allowed) const;

 private:
  [[nodiscard]] const YamlNode* scalar(std::string_view key, bool required, std::string_view allowed) const;

  const YamlNode* node_;
  std::string path_;
  Place missing_at_;
};

}  // namespace skein::scenario
