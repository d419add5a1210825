// What the papers print, figure by figure, each with the place where it stands.
//
// Only what can be read in the papers' texts is here, as printed; what they show in a picture alone is not. A key is
// `table.method.figure`: "table4.dcpso.l1" is the mean of L1 in Table 4's column "DCPSO with Cooperation".
// Source: papers/001, Tables 3, 4 and 6, sections 4.1 and 4.2; papers/004, Fig. 5 and sections IV-B to IV-E.
// Departs from source: none; how misprints are read is with the tables (rendezvous_tables, transit_tables).
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace skein::reproduce {

enum class Paper { Rendezvous, Transit };

struct PaperFigure {
  std::string_view key;
  std::string_view text;        ///< as printed: "35.0611", "72 of 72", "more than 25 %"
  std::optional<double> value;  ///< the number; none of a statement in words
  std::optional<double> sd;     ///< the standard deviation that is printed for it
  std::string_view unit;        ///< "km", "m", "s"; "-" of numbers without
  Paper paper = Paper::Rendezvous;
  std::string_view source;  ///< "Table 4, p. 12"
};

[[nodiscard]] std::span<const PaperFigure> paper_figures();

/// The figure of a key, or nullptr: the paper does not print it.
[[nodiscard]] const PaperFigure* find_paper_figure(std::string_view key);

/// Authors, title and number, on one line.
[[nodiscard]] std::string_view citation_of(Paper paper);

}  // namespace skein::reproduce
