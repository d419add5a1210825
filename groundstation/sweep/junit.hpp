// Runs as a JUnit XML file, which continuous integration shows: a test case a run, a failure with its reason.
//
// Source: the schema that Jenkins' xunit plugin reads (testsuites / testsuite / testcase / failure). Departs from
// source: no times, so that the same runs give the same file. Complexity: linear.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace skein {

struct JunitCase {
  std::string name;
  std::string failure;  ///< why it failed; empty: it did not
  std::string type;     ///< of the failure: "exit code 1"
};

struct JunitSuite {
  std::string name;
  std::vector<JunitCase> cases;
};

[[nodiscard]] std::string junit_xml(const std::string& name, const std::vector<JunitSuite>& suites);

/// Of run_sweep's rows: a suite a row, a case a run.
[[nodiscard]] std::vector<JunitSuite> junit_suites(const nlohmann::ordered_json& rows);

}  // namespace skein
