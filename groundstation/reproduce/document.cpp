#include "groundstation/reproduce/document.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "groundstation/reproduce/rendezvous_tables.hpp"
#include "groundstation/reproduce/transit_tables.hpp"
#include "simworld/report/report.hpp"

namespace skein::reproduce {
namespace {

constexpr std::size_t kWidth = 120;

/// Lines of at most kWidth characters, where words allow it; the second and later ones begin with `indent`.
std::string wrapped(const std::string& text, const std::string& indent) {
  std::string lines;
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (column > 0 && column + 1 + word.size() > kWidth) {
      lines += "\n" + indent;
      column = indent.size();
    } else if (column > 0) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += word.size();
    at = end + 1;
  }
  return lines + "\n";
}

std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += wrapped("* " + item, "  ");
  return text;
}

/// One a line.
constexpr std::string_view kRendezvousDifferences =
    "The rendezvous point is (30, 15) km. Tables 1 and 5 print (35, 15), with which the straight lines are longer "
    "than the paths of Tables 3 and 6; with (30, 15) the shortest unobstructed paths are the paper's L1 and L2.\n"
    "The paper's obstacles are in its figures only; ours lie close to its figures of length "
    "([layouts](families/rendezvous.md#layouts)). 7 m are kept from them.\n"
    "`dcpso-paper` is the method as printed, by the reading given below; `dcpso-solo` the same without "
    "cooperation; `dcpso` our default: exactly one length in the end, and every constraint proved; `ccga` a "
    "conventional cooperative co-evolutionary genetic algorithm.\n"
    "M = 20, T = 50, w1 = 0.5, Np = Nph = 50, kappa_max = 2 per km, as in section 4.1. The search range and Vmax "
    "are not printed.\n"
    "Each plan is flown, at 50 m/s in steps of 0.5 s, which the paper does not do.\n";

/// One a line.
constexpr std::string_view kTransitDifferences =
    "The paper's power station is a picture; ours has a wall with gaps of 12, 8, 5 and 3 m, of which 4, 3 and 2 "
    "are open to cells of 2, 4 and 6 m, as its areas c and d are.\n"
    "One in ten samples is lost on top of the paper's radio (90 m, 250 kbit/s, a send every 2 s); speed, sensor "
    "range and sizes are the paper's.\n"
    "`peach` and `peach3d-paper` are Algorithms 1 and 2 with 3, by readings of what the paper leaves open "
    "([table](families/transit.md#what-the-paper-leaves-open)); `peach3d` is our default, which finds every goal "
    "that can be reached.\n"
    "The paper flies each swarm once: 72 flights in 12 runs. Ours are as many for each seed.\n";

std::vector<std::string> lines_in(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}

Section section_of(Paper paper, const Results& results) {
  Section section;
  section.paper = paper;
  if (paper == Paper::Rendezvous) {
    section.title = "Formation rendezvous";
    section.differences = lines_in(kRendezvousDifferences);
    section.tables = rendezvous_tables(results);
  } else {
    section.title = "Flight through unknown space";
    section.differences = lines_in(kTransitDifferences);
    section.tables = transit_tables(results);
  }
  for (const CampaignResult& result : results.campaigns) {
    if (result.campaign.paper == paper) section.commands.push_back(command_of(result.campaign, result.runs));
  }
  return section;
}

}  // namespace

Document document_of(const std::string& command, const std::vector<Paper>& papers, const Results& results) {
  Document document{command, results.complete, {}, nlohmann::ordered_json::array()};
  for (const Paper paper : papers) {
    Section section = section_of(paper, results);
    if (!section.commands.empty()) document.sections.push_back(std::move(section));
  }
  for (const CampaignResult& result : results.campaigns) {
    document.campaigns.push_back({{"name", result.campaign.name},
                                  {"scenario", result.campaign.scenario},
                                  {"runs", result.runs},
                                  {"table", result.table}});
  }
  return document;
}

std::string text_of(const Document& document, Layout layout) {
  std::string text = "# Reproduction\n\n";
  if (!document.complete) text += "**Interrupted: not all runs are in these tables.**\n\n";
  text += wrapped(
      fmt::format(
          "What the papers print beside what this software gives, made by `{}`, version {}: all runs are in one "
          "process, with seeds from 0 on, and made again give the same but for wall times. '-' is what a paper "
          "does not print, or a planner does not have; a name in `code` is our planner of that name.",
          document.command, version()),
      "");
  for (const Section& section : document.sections) {
    text += fmt::format("\n## {}\n\n{}\nWhat differs in all tables:\n\n{}", section.title,
                        wrapped(std::string(citation_of(section.paper)) + ".", ""), listed(section.differences));
    for (const Table& table : section.tables) {
      text += fmt::format("\n### {}\n\n{}\n{}", table.title, listed(table.notes), text_of(table, layout));
    }
    text += "\nThe same figures by `skein sweep`:\n\n```sh\n";
    for (const std::string& command : section.commands) text += command + "\n";
    text += "```\n";
  }
  return text;
}

nlohmann::ordered_json json_of(const Document& document) {
  nlohmann::ordered_json json{{"command", document.command}, {"version", version()}, {"complete", document.complete}};
  json["sections"] = nlohmann::ordered_json::array();
  for (const Section& section : document.sections) {
    nlohmann::ordered_json tables = nlohmann::ordered_json::array();
    for (const Table& table : section.tables) tables.push_back(json_of(table));
    json["sections"].push_back({{"title", section.title},
                                {"paper", citation_of(section.paper)},
                                {"differences", section.differences},
                                {"tables", tables},
                                {"commands", section.commands}});
  }
  json["campaigns"] = document.campaigns;
  return json;
}

}  // namespace skein::reproduce
