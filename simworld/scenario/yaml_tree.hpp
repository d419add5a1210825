// A YAML text as a plain tree whose every node remembers its place, so that a fault can name line and column.
//
// Built from yaml-cpp's events, one node an event, so nothing is expanded: anchors, aliases, tags, repeated keys and a
// second document are faults, and depth and number of nodes are bounded. Scalars stay text; simworld/scenario/reader
// decides what they mean (YAML 1.1 would read 010 as 8 and yes as true).
// Source: none. Departs from source: none. Complexity: O(text), O(keys^2) in one map.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace skein::scenario {

/// Where something stands: in the file (both count from 1), or in the value of an override if `set_key` is not empty.
struct Place {
  int line = 1;
  int column = 1;
  std::string set_key = {};

  bool operator==(const Place&) const = default;
};

/// The first fault found. Thrown and caught inside this folder only; load_scenario returns it as a value.
class ReadFault : public std::runtime_error {
 public:
  ReadFault(Place place, const std::string& message) : std::runtime_error(message), place_(std::move(place)) {}
  [[nodiscard]] const Place& place() const { return place_; }

 private:
  Place place_;
};

enum class NodeKind { Null, Scalar, List, Map };

struct YamlNode {
  NodeKind kind = NodeKind::Null;
  Place place;
  std::string key;                 ///< its key, if it stands in a map
  Place key_place;                 ///< and where that key stands
  std::string text;                ///< of a scalar
  bool in_quotes = false;          ///< a scalar in quotes is text, whatever it looks like
  std::vector<YamlNode> children;  ///< items of a list, or entries of a map in the order of the file

  /// The entry of a map with this key, or nullptr.
  [[nodiscard]] const YamlNode* find(std::string_view wanted) const;
  [[nodiscard]] YamlNode* find(std::string_view wanted);
};

/// Parses one document. `set_key` is that of the override whose value is parsed, empty for a file.
/// An empty text gives a Null node. @throws ReadFault
[[nodiscard]] YamlNode parse_yaml(const std::string& text, const std::string& set_key = {});

/// Text with control characters as \xNN, so that a message stays on one line.
[[nodiscard]] std::string on_one_line(std::string_view text);

/// User text for a message: in single quotes, on one line, cut after 60 characters.
[[nodiscard]] std::string quote_text(std::string_view text);

}  // namespace skein::scenario
