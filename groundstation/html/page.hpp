// One self-contained HTML page: no script, no style sheet, font or picture from elsewhere.
//
// Everything that is not markup of ours goes through escaped(). Pictures are SVG inside the page; their ids get a
// prefix of their own, since a page may not have an id twice. The style reads from 360 px on and prints on A4. Source:
// the HTML standard. Departs from source: also well-formed XML, so that any parser can check it. Complexity: linear in
// the text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace skein::html {

using Json = nlohmann::ordered_json;

/// Text as it may stand in an element or in an attribute in double quotes; bytes that are no UTF-8, and control
/// characters, become U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

/// An SVG file as part of a page: without head and size, ids with `prefix`, `label` for those who do not see it.
[[nodiscard]] std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view label);

/// A word of a shell's command line.
[[nodiscard]] std::string shell_word(std::string_view text);

/// How a change of the scenario is said: "--set key=value", or "--agents 3".
[[nodiscard]] std::string override_words(const std::string& key, const std::string& value);

/// A value for people: numbers with up to seven digits, null as a dash, lists with commas.
[[nodiscard]] std::string text_of(const Json& value);

class Page {
 public:
  explicit Page(std::string_view title);

  Page& heading(std::string_view text);
  Page& paragraph(std::string_view text);
  /// A box that stands out. @param good its colour; the text says it as well
  Page& verdict(std::string_view text, bool good);
  /// What is to be known before the figures are read; nothing of none.
  Page& notes(const std::vector<std::string>& lines);
  /// Names and values side by side.
  Page& facts(const std::vector<std::pair<std::string, std::string>>& rows);
  Page& table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows);
  /// A heading and a table with the keys of the objects as columns; nothing of an empty list or of no list.
  Page& objects(std::string_view heading, const Json& list, std::size_t most_rows);
  Page& preformatted(std::string_view text);
  /// Closed until it is opened, and left out in print.
  Page& folded(std::string_view summary, std::string_view text);
  Page& figure(std::string_view inline_svg, std::string_view caption);

  [[nodiscard]] std::string text() const;

 private:
  std::string body_;
  std::string title_;
};

}  // namespace skein::html
