// What a person sees of a run: discovery, planning by generation, the flight, and a table of the result.
//
// On a terminal one line is rewritten in place; elsewhere plain lines are printed when something changes. Progress goes
// to standard error, the result (table or JSON) to standard output.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace skein {

class RunDisplay {
 public:
  /// @param json the result is printed as JSON
  explicit RunDisplay(bool json);

  /// Shows a state as progress_of() describes it.
  void show(const nlohmann::json& progress);
  /// A line of its own.
  void note(const std::string& line);
  /// The last line of progress is complete.
  void end();
  void result(const nlohmann::ordered_json& report, const std::string& folder) const;
  /// What an observer knows of a run that ended.
  void outcome(const nlohmann::ordered_json& result) const;

 private:
  void verdict(const nlohmann::ordered_json& report) const;
  void put(const std::string& line, bool lasting);

  bool json_;
  bool terminal_;
  bool colour_;
  std::string stage_;  ///< phase of the last state shown
  std::string last_line_;
  std::string mark_;  ///< what the last plain line was about
  bool unfinished_ = false;
};

}  // namespace skein
