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
  bool error = false;   ///< nothing failed: it could not be found out
};

struct JunitSuite {
  std::string name;
  std::vector<JunitCase> cases;
};

[[nodiscard]] std::string junit_xml(const std::string& name, const std::vector<JunitSuite>& suites);

/// What stands for runs that were not made, so that a job that was interrupted does not look as if all were well.
[[nodiscard]] JunitCase junit_of_missing(std::size_t made, std::size_t of);

/// Of run_sweep's rows: a suite a row, a case a run; an error in each row that has fewer than `runs`.
[[nodiscard]] std::vector<JunitSuite> junit_suites(const nlohmann::ordered_json& rows, std::size_t runs);

}  // namespace skein
