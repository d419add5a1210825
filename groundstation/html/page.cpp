#include "groundstation/html/page.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "groundstation/html/style.hpp"
#include "planner/core/text/utf8.hpp"

namespace skein::html {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

std::string cell(std::string_view text, std::string_view element) {
  return fmt::format("<{0}>{1}</{0}>", element, escaped(text));
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = utf8_size(text.substr(at));
    const char c = text[at];
    if (size == 0 || (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7F) {
      safe += kReplacement;
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else if (c == '&') {
      safe += "&amp;";
    } else if (c == '"') {
      safe += "&quot;";
    } else if (c == '\'') {
      safe += "&#39;";
    } else {
      safe += text.substr(at, size);
    }
    at += std::max<std::size_t>(size, 1);
  }
  return safe;
}

std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view label) {
  const std::size_t start = svg.find("<svg");
  const std::size_t content = svg.find('>', start);
  const std::size_t box = svg.find("viewBox=\"", start);
  if (start == std::string_view::npos || content == std::string_view::npos || box > content) return "";
  const std::string view(svg.substr(box, svg.find('"', box + 9) + 1 - box));
  std::string text(svg.substr(content + 1));
  for (const char quote : {'"', '\''}) {
    replace_all(text, fmt::format(" id={}", quote), fmt::format(" id={}{}", quote, prefix));
    replace_all(text, fmt::format("href={}#", quote), fmt::format("href={}#{}", quote, prefix));
  }
  replace_all(text, "url(#", fmt::format("url(#{}", prefix));
  replace_all(text, "font-family=\"DejaVu Sans\"", "font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\"");
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" role=\"img\" "
      "aria-label=\"{}\" {}>{}",
      escaped(label), view, text);
}

std::string shell_word(std::string_view text) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-_./=,:+@%").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string override_words(const std::string& key, const std::string& value) {
  if (key.starts_with("--")) return fmt::format("{} {}", key, shell_word(value));
  return fmt::format("--set {}", shell_word(key + "=" + value));
}

std::string text_of(const Json& value) {
  if (value.is_null()) return "–";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return fmt::format("{:.7g}", value.get<double>());
  if (!value.is_array()) return value.dump();
  std::string list;
  for (const Json& item : value) list += (list.empty() ? "" : ", ") + text_of(item);
  return list.empty() ? "–" : list;
}

Page::Page(std::string_view title) : body_(fmt::format("<h1>{}</h1>\n", escaped(title))), title_(title) {}

Page& Page::heading(std::string_view text) {
  body_ += fmt::format("<h2>{}</h2>\n", escaped(text));
  return *this;
}

Page& Page::paragraph(std::string_view text) {
  body_ += fmt::format("<p>{}</p>\n", escaped(text));
  return *this;
}

Page& Page::verdict(std::string_view text, bool good) {
  body_ += fmt::format("<p class=\"{}\">{}</p>\n", good ? "good" : "bad", escaped(text));
  return *this;
}

Page& Page::notes(const std::vector<std::string>& lines) {
  if (lines.empty()) return *this;
  body_ += "<ul class=\"notes\">";
  for (const std::string& line : lines) body_ += cell(line, "li");
  body_ += "</ul>\n";
  return *this;
}

Page& Page::facts(const std::vector<std::pair<std::string, std::string>>& rows) {
  body_ += "<div class=\"scroll\"><table class=\"facts\"><tbody>\n";
  for (const auto& [name, value] : rows) body_ += "<tr>" + cell(name, "th") + cell(value, "td") + "</tr>\n";
  body_ += "</tbody></table></div>\n";
  return *this;
}

Page& Page::table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows) {
  body_ += "<div class=\"scroll\"><table><thead><tr>";
  for (const std::string& column : columns) body_ += cell(column, "th");
  body_ += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    body_ += "<tr>";
    for (const std::string& value : row) body_ += cell(value, "td");
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
  return *this;
}

Page& Page::objects(std::string_view heading_text, const Json& list, std::size_t most_rows) {
  if (!list.is_array() || list.empty() || !list.front().is_object()) return *this;
  heading(heading_text);
  std::vector<std::string> columns;
  for (const auto& [key, value] : list.front().items()) columns.push_back(key);
  std::vector<std::vector<std::string>> rows;
  for (const Json& item : list) {
    if (rows.size() == most_rows) break;
    std::vector<std::string> row;
    row.reserve(columns.size());
    for (const std::string& column : columns) row.push_back(text_of(item.value(column, Json())));
    rows.push_back(std::move(row));
  }
  table(columns, rows);
  if (list.size() > most_rows) paragraph(fmt::format("{} more are in the report.", list.size() - most_rows));
  return *this;
}

Page& Page::preformatted(std::string_view text) {
  body_ += fmt::format("<pre>{}</pre>\n", escaped(text));
  return *this;
}

Page& Page::folded(std::string_view summary, std::string_view text) {
  body_ += fmt::format("<details><summary>{}</summary><pre>{}</pre></details>\n", escaped(summary), escaped(text));
  return *this;
}

Page& Page::figure(std::string_view svg, std::string_view caption) {
  body_ += fmt::format("<figure><div class=\"scroll\">{}</div><figcaption>{}</figcaption></figure>\n", svg,
                       escaped(caption));
  return *this;
}

std::string Page::text() const {
  return fmt::format(
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\"><head>"
      "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\"/>\n<title>{}</title>\n<style>{}</style>\n</head><body>\n{}</body></html>\n",
      escaped(title_), kStyle, body_);
}

}  // namespace skein::html
