#include "groundstation/sweep/junit.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "groundstation/sweep/table.hpp"
#include "planner/core/text/utf8.hpp"

namespace skein {
namespace {

/// U+FFFE and U+FFFF, which XML leaves out.
bool is_no_character(std::string_view utf8) {
  return utf8 == "\xEF\xBF\xBE" || utf8 == "\xEF\xBF\xBF";
}

/// For an attribute. Characters that XML cannot hold, and bytes that are no UTF-8, become '?'.
std::string escaped(const std::string& text) {
  std::string out;
  for (std::size_t at = 0, size = 0; at < text.size(); at += std::max<std::size_t>(size, 1)) {
    const char c = text[at];
    size = utf8_size(std::string_view(text).substr(at));
    if (size == 0 || is_no_character(std::string_view(text).substr(at, size))) {
      out += '?';
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += c == '\n' || c == '\t' ? ' ' : '?';
    } else {
      out.append(text, at, size);
    }
  }
  return out;
}

struct Counts {
  std::size_t failures = 0;
  std::size_t errors = 0;
};

Counts counts_of(const JunitSuite& suite) {
  Counts counts;
  for (const JunitCase& one : suite.cases) {
    if (!one.failure.empty()) ++(one.error ? counts.errors : counts.failures);
  }
  return counts;
}

std::string xml_of(const JunitSuite& suite) {
  const Counts counts = counts_of(suite);
  std::string xml = fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
                                escaped(suite.name), suite.cases.size(), counts.failures, counts.errors);
  for (const JunitCase& one : suite.cases) {
    const std::string head =
        fmt::format("    <testcase classname=\"{}\" name=\"{}\"", escaped(suite.name), escaped(one.name));
    if (one.failure.empty()) {
      xml += head + "/>\n";
      continue;
    }
    xml += fmt::format("{}>\n      <{} message=\"{}\" type=\"{}\"/>\n    </testcase>\n", head,
                       one.error ? "error" : "failure", escaped(one.failure), escaped(one.type));
  }
  return xml + "  </testsuite>\n";
}

}  // namespace

std::string junit_xml(const std::string& name, const std::vector<JunitSuite>& suites) {
  std::size_t tests = 0;
  Counts all;
  std::string inside;
  for (const JunitSuite& suite : suites) {
    tests += suite.cases.size();
    const Counts counts = counts_of(suite);
    all.failures += counts.failures;
    all.errors += counts.errors;
    inside += xml_of(suite);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" tests=\"{}\" failures=\"{}\" "
      "errors=\"{}\">\n{}</testsuites>\n",
      escaped(name), tests, all.failures, all.errors, inside);
}

JunitCase junit_of_missing(std::size_t made, std::size_t of) {
  return {"runs that were not made", fmt::format("{} of {} runs were not made", of - made, of), "interrupted", true};
}

std::vector<JunitSuite> junit_suites(const nlohmann::ordered_json& rows, std::size_t runs) {
  std::vector<JunitSuite> suites;
  for (const auto& row : rows) {
    JunitSuite suite{title_of(row), {}};
    for (const auto& run : row.at("per_run")) {
      JunitCase one{"seed " + run.at("seed").dump(), "", ""};
      if (run.at("exit_code") != 0) {
        one.failure = run.at("reason").get<std::string>();
        one.type = "exit code " + run.at("exit_code").dump();
        if (one.failure.empty()) one.failure = one.type;
      }
      suite.cases.push_back(std::move(one));
    }
    if (suite.cases.size() < runs) suite.cases.push_back(junit_of_missing(suite.cases.size(), runs));
    suites.push_back(std::move(suite));
  }
  return suites;
}

}  // namespace skein
