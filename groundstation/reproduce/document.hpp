// The reproduction as a document: a section a paper, with its tables, what differs in set-up, and the sweeps behind it.
//
// docs/reproduction.md is what `text_of` gives for a file: the same bytes for the same seeds and version.
// Complexity: O(runs).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "groundstation/reproduce/campaign.hpp"
#include "groundstation/reproduce/table.hpp"

namespace skein::reproduce {

struct Section {
  Paper paper = Paper::Rendezvous;
  std::string title;
  std::vector<std::string> differences;  ///< of all its tables
  std::vector<Table> tables;
  std::vector<std::string> commands;  ///< of the sweeps that give the same figures
};

struct Document {
  std::string command;   ///< that makes it
  bool complete = true;  ///< false: interrupted
  std::vector<Section> sections;
  nlohmann::ordered_json campaigns;  ///< name, scenario, runs, the sweep's table
};

[[nodiscard]] Document document_of(const std::string& command, const std::vector<Paper>& papers,
                                   const Results& results);

/// Markdown; of a terminal with wall times, of a file without (table.hpp).
[[nodiscard]] std::string text_of(const Document& document, Layout layout);

[[nodiscard]] nlohmann::ordered_json json_of(const Document& document);

}  // namespace skein::reproduce
