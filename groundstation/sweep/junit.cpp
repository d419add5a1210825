#include "groundstation/sweep/junit.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "groundstation/sweep/table.hpp"

namespace skein {
namespace {

/// For an attribute. Characters that XML cannot hold become '?'.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
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
      out += c;
    }
  }
  return out;
}

std::size_t failures_of(const JunitSuite& suite) {
  return static_cast<std::size_t>(
      std::ranges::count_if(suite.cases, [](const JunitCase& one) { return !one.failure.empty(); }));
}

std::string xml_of(const JunitSuite& suite) {
  std::string xml = fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n",
                                escaped(suite.name), suite.cases.size(), failures_of(suite));
  for (const JunitCase& one : suite.cases) {
    const std::string head =
        fmt::format("    <testcase classname=\"{}\" name=\"{}\"", escaped(suite.name), escaped(one.name));
    if (one.failure.empty()) {
      xml += head + "/>\n";
      continue;
    }
    xml += fmt::format("{}>\n      <failure message=\"{}\" type=\"{}\"/>\n    </testcase>\n", head,
                       escaped(one.failure), escaped(one.type));
  }
  return xml + "  </testsuite>\n";
}

}  // namespace

std::string junit_xml(const std::string& name, const std::vector<JunitSuite>& suites) {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::string inside;
  for (const JunitSuite& suite : suites) {
    tests += suite.cases.size();
    failures += failures_of(suite);
    inside += xml_of(suite);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" tests=\"{}\" failures=\"{}\">\n{}"
      "</testsuites>\n",
      escaped(name), tests, failures, inside);
}

std::vector<JunitSuite> junit_suites(const nlohmann::ordered_json& rows) {
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
    suites.push_back(std::move(suite));
  }
  return suites;
}

}  // namespace skein
