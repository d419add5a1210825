#include "groundstation/schema/idl.hpp"

#include <fmt/core.h>

#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <stdexcept>
#include <utility>

namespace skein::schema {
namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

class Tokens {
 public:
  explicit Tokens(std::string_view text) : text_(text) { advance(); }

  [[nodiscard]] std::string_view peek() const { return token_; }
  std::string_view next() {
    const std::string_view token = token_;
    if (token.empty()) fail("the text ends too early");
    advance();
    return token;
  }
  bool skip(std::string_view token) {
    const bool there = token_ == token;
    if (there) advance();
    return there;
  }
  void expect(std::string_view token) {
    if (!skip(token)) fail(fmt::format("'{}' stands where '{}' is expected", token_, token));
  }
  std::uint32_t number() {
    const std::string_view token = next();
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (error != std::errc{} || end != token.data() + token.size()) fail(fmt::format("'{}' is no number", token));
    return value;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(fmt::format("IDL line {}: {}", line_, what));
  }

 private:
  void skip_past(std::string_view end) {
    while (at_ < text_.size() && text_.substr(at_, end.size()) != end) step();
    if (end != "\n") at_ = std::min(at_ + end.size(), text_.size());
  }
  void step() {
    if (text_[at_] == '\n') ++line_;
    ++at_;
  }
  void advance() {
    while (at_ < text_.size()) {
      const std::string_view rest = text_.substr(at_);
      if (rest.starts_with("//") || rest.starts_with('#')) {
        skip_past("\n");
      } else if (rest.starts_with("/*")) {
        skip_past("*/");
      } else if (std::isspace(static_cast<unsigned char>(rest.front())) != 0) {
        step();
      } else {
        break;
      }
    }
    std::size_t size = at_ < text_.size() ? 1 : 0;
    if (text_.substr(at_).starts_with("::")) size = 2;
    if (size == 1 && is_word(text_[at_])) {
      while (at_ + size < text_.size() && is_word(text_[at_ + size])) ++size;
    }
    token_ = text_.substr(at_, size);
    at_ += size;
  }

  std::string_view text_;
  std::string_view token_;
  std::size_t at_ = 0;
  int line_ = 1;
};

class Parser {
 public:
  explicit Parser(std::string_view text) : tokens_(text) { definitions(""); }

  [[nodiscard]] Struct find(std::string_view name) const {
    const auto found = structs_.find(std::string(name));
    if (found == structs_.end()) throw std::invalid_argument(fmt::format("the IDL has no struct {}", name));
    return *found->second;
  }

 private:
  void definitions(const std::string& scope) {
    while (!tokens_.peek().empty() && tokens_.peek() != "}") {
      annotations();
      if (tokens_.skip("module")) {
        const std::string name(tokens_.next());
        tokens_.expect("{");
        definitions(scope + name + "::");
        tokens_.expect("}");
      } else {
        tokens_.expect("struct");
        structure(scope);
      }
      tokens_.expect(";");
    }
  }

  void annotations() {
    while (tokens_.skip("@")) {
      tokens_.next();
      if (!tokens_.skip("(")) continue;
      while (!tokens_.skip(")")) tokens_.next();
    }
  }

  void structure(const std::string& scope) {
    Struct made;
    made.name = scope + std::string(tokens_.next());
    tokens_.expect("{");
    while (!tokens_.skip("}")) {
      annotations();
      Field field = type(scope);
      field.name = tokens_.next();
      if (tokens_.skip("[")) {
        if (field.shape != Shape::One) tokens_.fail("an array of sequences is not read");
        field.shape = Shape::Array;
        field.length = tokens_.number();
        tokens_.expect("]");
      }
      tokens_.expect(";");
      made.fields.push_back(std::move(field));
    }
    const std::string name = made.name;
    if (!structs_.emplace(name, std::make_shared<const Struct>(std::move(made))).second) {
      tokens_.fail(fmt::format("struct {} stands twice", name));
    }
  }

  Field type(const std::string& scope) {
    if (!tokens_.skip("sequence")) return item(scope);
    tokens_.expect("<");
    Field field = item(scope);
    field.shape = Shape::Sequence;
    if (tokens_.skip(",")) field.length = tokens_.number();
    tokens_.expect(">");
    return field;
  }

  Field item(const std::string& scope) {
    static const std::map<std::string_view, Basic> basics{{"boolean", Basic::Boolean}, {"octet", Basic::Octet},
                                                          {"char", Basic::Char},       {"short", Basic::Short},
                                                          {"float", Basic::Float},     {"double", Basic::Double}};
    Field field;
    if (tokens_.skip("string")) {
      field.basic = Basic::String;
      if (tokens_.skip("<")) {
        tokens_.number();
        tokens_.expect(">");
      }
      return field;
    }
    const bool is_unsigned = tokens_.skip("unsigned");
    if (tokens_.skip("long")) {
      const bool is_longer = tokens_.skip("long");
      field.basic =
          is_longer ? (is_unsigned ? Basic::ULongLong : Basic::LongLong) : (is_unsigned ? Basic::ULong : Basic::Long);
      return field;
    }
    if (is_unsigned) {
      tokens_.expect("short");
      field.basic = Basic::UShort;
      return field;
    }
    if (const auto basic = basics.find(tokens_.peek()); basic != basics.end()) {
      field.basic = basic->second;
      tokens_.next();
      return field;
    }
    field.basic = Basic::Struct;
    field.type = named(scope);
    return field;
  }

  std::shared_ptr<const Struct> named(std::string scope) {
    std::string name(tokens_.next());
    while (tokens_.skip("::")) name += "::" + std::string(tokens_.next());
    while (true) {
      if (const auto found = structs_.find(scope + name); found != structs_.end()) return found->second;
      if (scope.empty()) tokens_.fail(fmt::format("type '{}' is not known", name));
      scope.resize(scope.size() - 2);
      const auto outer = scope.rfind("::");
      scope.resize(outer == std::string::npos ? 0 : outer + 2);
    }
  }

  Tokens tokens_;
  std::map<std::string, std::shared_ptr<const Struct>> structs_;
};

}  // namespace

Struct parse_idl(std::string_view text, std::string_view name) {
  return Parser(text).find(name);
}

}  // namespace skein::schema
