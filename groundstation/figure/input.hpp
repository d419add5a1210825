// What there is to draw: a recording, the folder of a run, or the JSON of a sweep.
//
//   FILE.mcap   the samples of the file; obstacles that agents are not told of from its scenario
//   FOLDER      report.json (or the file itself) with scenario.yaml beside it: the run once more in this process, with
//               the losses of its report, if the scenario's hash is the report's
//   FILE.json   what skein sweep --json printed
// A file that was cut or damaged is read up to there. What is missing or was done again stands in `notes`.
// Source: none. Departs from source: none. Complexity: linear in the file; of a folder that of the run.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "groundstation/figure/outline.hpp"
#include "groundstation/figure/run_data.hpp"

namespace skein::figure {

using Json = nlohmann::ordered_json;

struct RunInput {
  std::string name;  ///< of file or folder, as given
  RunData data;
  std::vector<Outline> outlines;
  Json report;                ///< null: there is none
  std::string scenario_text;  ///< empty: it is not known
  std::string scenario_path;  ///< as the run's command named it; empty: not known
  std::vector<Override> overrides;
  std::map<std::string, std::string> facts;  ///< of a recording: recorder, version, wire_version, lost
  std::vector<std::string> notes;            ///< one line each
};

struct SweepInput {
  std::string name;
  Json document;                   ///< scenario, complete, table, rows
  std::string scenario_text;       ///< empty: it is not there any more
  std::string command;             ///< empty: not known
  std::vector<std::string> notes;  ///< one line each
};

using Input = std::variant<RunInput, SweepInput>;

/// @throws std::runtime_error with one line if it holds nothing that can be drawn
[[nodiscard]] Input read_input(const std::string& path);

/// Of a sweep's document. @param name of its file, or of its scenario
[[nodiscard]] SweepInput input_of_sweep(const std::string& name, Json document);

/// The text of a file. @throws std::runtime_error with one line
[[nodiscard]] std::string text_of_file(const std::string& path);

}  // namespace skein::figure
