#include "simworld/scenario/yaml_tree.hpp"

#include <fmt/core.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>

namespace skein::scenario {
namespace {

constexpr std::size_t kMaxDepth = 16;
constexpr std::size_t kMaxNodes = 20000;

/// yaml-cpp keeps the mark by value in its events; counts from 0, and says -1 for 'nowhere'.
Place place_of(const YAML::Mark& mark, const std::string& set_key) {
  return Place{std::max(mark.line, 0) + 1, std::max(mark.column, 0) + 1, set_key};
}

class TreeBuilder final : public YAML::EventHandler {
 public:
  explicit TreeBuilder(std::string set_key) : set_key_(std::move(set_key)) {}

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    if (expects_key()) throw ReadFault(place_of(mark, set_key_), "a key is empty; allowed: a word before the colon");
    add(mark, NodeKind::Null);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse_anchor(mark, 1); }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    if (expects_key()) return add_key(mark, value);
    YamlNode& node = add(mark, NodeKind::Scalar);
    node.text = value;
    node.in_quotes = tag == "!";
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, NodeKind::List);
  }
  void OnSequenceEnd() override { levels_.pop_back(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, NodeKind::Map);
  }
  void OnMapEnd() override { levels_.pop_back(); }

  YamlNode take_root() { return std::move(root_); }

 private:
  /// An open list or map. Its node stays where it is, because its parent gets no child before it is closed.
  struct Level {
    YamlNode* node;
    bool has_key;
  };

  [[nodiscard]] bool expects_key() const {
    return !levels_.empty() && levels_.back().node->kind == NodeKind::Map && !levels_.back().has_key;
  }

  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor != 0) {
      throw ReadFault(place_of(mark, set_key_), "anchors (&x) and aliases (*x) are not allowed; write the value out");
    }
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    throw ReadFault(place_of(mark, set_key_), fmt::format("the tag {} is not allowed; leave it out", quote_text(tag)));
  }

  void add_key(const YAML::Mark& mark, const std::string& key) {
    Level& level = levels_.back();
    if (const YamlNode* first = level.node->find(key)) {
      throw ReadFault(place_of(mark, set_key_), fmt::format("key {} is given twice, first in line {}; allowed: once",
                                                            quote_text(key), first->key_place.line));
    }
    YamlNode& entry = level.node->children.emplace_back();
    entry.key = key;
    entry.key_place = place_of(mark, set_key_);
    level.has_key = true;
  }

  YamlNode& add(const YAML::Mark& mark, NodeKind kind) {
    if (++count_ > kMaxNodes) {
      throw ReadFault(place_of(mark, set_key_), fmt::format("too many values; allowed: {} in a scenario", kMaxNodes));
    }
    YamlNode* node = &root_;
    if (!levels_.empty()) {
      Level& level = levels_.back();
      node = level.node->kind == NodeKind::List ? &level.node->children.emplace_back() : &level.node->children.back();
      level.has_key = false;
    }
    node->kind = kind;
    // yaml-cpp marks a missing value at the token that follows; its key is what the user must look at.
    node->place = kind == NodeKind::Null && !node->key.empty() ? node->key_place : place_of(mark, set_key_);
    return *node;
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, NodeKind kind) {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    if (expects_key()) {
      throw ReadFault(place_of(mark, set_key_),
                      "a key is a list or a map (is a bracket open?); allowed: a word before the colon");
    }
    if (levels_.size() >= kMaxDepth) {
      throw ReadFault(place_of(mark, set_key_), fmt::format("nested too deep; allowed: {} levels", kMaxDepth));
    }
    levels_.push_back({&add(mark, kind), false});
  }

  std::string set_key_;
  YamlNode root_;
  std::vector<Level> levels_;
  std::size_t count_ = 0;
};

}  // namespace

const YamlNode* YamlNode::find(std::string_view wanted) const {
  if (kind != NodeKind::Map) return nullptr;
  const auto found = std::ranges::find(children, wanted, &YamlNode::key);
  return found == children.end() ? nullptr : &*found;
}

YamlNode* YamlNode::find(std::string_view wanted) {
  return const_cast<YamlNode*>(std::as_const(*this).find(wanted));
}

YamlNode parse_yaml(const std::string& text, const std::string& set_key) {
  std::istringstream stream(text);
  TreeBuilder builder(set_key);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) return {};
    TreeBuilder second(set_key);
    if (parser.HandleNextDocument(second)) {
      throw ReadFault(Place{1, 1, set_key}, "more than one YAML document; allowed: one scenario a file");
    }
  } catch (const YAML::Exception& error) {
    throw ReadFault(place_of(error.mark, set_key),
                    fmt::format("not valid YAML: {}; allowed: the form of docs/scenario.md", on_one_line(error.msg)));
  }
  return builder.take_root();
}

std::string on_one_line(std::string_view text) {
  std::string shown;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      shown += fmt::format("\\x{:02x}", byte);
    } else {
      shown += c;
    }
  }
  return shown;
}

std::string quote_text(std::string_view text) {
  constexpr std::size_t kMaxShown = 60;
  return fmt::format("'{}{}'", on_one_line(text.substr(0, kMaxShown)), text.size() > kMaxShown ? "..." : "");
}

}  // namespace skein::scenario
