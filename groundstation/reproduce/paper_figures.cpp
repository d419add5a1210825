#include "groundstation/reproduce/paper_figures.hpp"

#include <algorithm>
#include <array>

namespace skein::reproduce {
namespace {

constexpr std::string_view kTable3 = "Table 3, p. 12";
constexpr std::string_view kTable4 = "Table 4, p. 12";
constexpr std::string_view kTable6 = "Table 6, p. 13";
constexpr std::string_view kFig5 = "Fig. 5";

constexpr PaperFigure km(std::string_view key, std::string_view text, double value, std::string_view source) {
  return {key, text, value, std::nullopt, "km", Paper::Rendezvous, source};
}
constexpr PaperFigure spread(std::string_view key, std::string_view text, double value, double sd) {
  return {key, text, value, sd, "km", Paper::Rendezvous, kTable4};
}
constexpr PaperFigure count(std::string_view key, std::string_view text, double value) {
  return {key, text, value, std::nullopt, "-", Paper::Rendezvous, kTable4};
}
constexpr PaperFigure time(std::string_view key, std::string_view text, double value) {
  return {key, text, value, std::nullopt, "s", Paper::Rendezvous, kTable4};
}
constexpr PaperFigure transit(std::string_view key, std::string_view text, std::optional<double> value,
                              std::string_view unit, std::string_view source) {
  return {key, text, value, std::nullopt, unit, Paper::Transit, source};
}
constexpr PaperFigure words(std::string_view key, std::string_view text, std::string_view unit,
                            std::string_view source) {
  return {key, text, std::nullopt, std::nullopt, unit, Paper::Rendezvous, source};
}

constexpr auto kFigures = std::to_array<PaperFigure>({
    km("table3.solo.l1", "35.0610", 35.0610, kTable3),
    km("table3.solo.l2", "31.3760", 31.3760, kTable3),
    km("table3.solo.l3", "34.3439", 34.3439, kTable3),
    km("table3.solo.d12", "0.7863", 0.7863, kTable3),
    km("table3.solo.d13", "1.0817", 1.0817, kTable3),
    km("table3.solo.d23", "1.2000", 1.2000, kTable3),
    km("table3.dcpso.l1", "35.0611", 35.0611, kTable3),
    km("table3.dcpso.l2", "35.0590", 35.0590, kTable3),
    km("table3.dcpso.l3", "35.0618", 35.0618, kTable3),
    km("table3.dcpso.d12", "0.9868", 0.9868, kTable3),
    km("table3.dcpso.d13", "1.0817", 1.0817, kTable3),
    km("table3.dcpso.d23", "0.4879", 0.4879, kTable3),
    km("table3.dcpso.difference", "0.0028", 0.0028, "section 4.1, p. 11"),
    km("table3.ccga.l1", "35.6054", 35.6054, kTable3),
    km("table3.ccga.l2", "35.5208", 35.5208, kTable3),
    km("table3.ccga.l3", "35.6208", 35.6208, kTable3),
    km("table3.ccga.d12", "0.9564", 0.9564, kTable3),
    km("table3.ccga.d13", "1.0817", 1.0817, kTable3),
    km("table3.ccga.d23", "0.3261", 0.3261, kTable3),
    km("table3.ccga.difference", "about 0.1", 0.1, "section 4.1, p. 11"),

    count("table4.dcpso.runs", "30", 30),
    count("table4.dcpso.successes", "27", 27),
    count("table4.dcpso.rate", "0.9", 0.9),
    spread("table4.dcpso.l1", "35.0611 (0.0001)", 35.0611, 0.0001),
    spread("table4.dcpso.l2", "35.0310 (0.0673)", 35.0310, 0.0673),
    spread("table4.dcpso.l3", "35.0597 (0.0054)", 35.0597, 0.0054),
    km("table4.dcpso.difference", "about 0.0301", 0.0301, "section 4.1, p. 11"),
    time("table4.dcpso.time", "2.35", 2.35),
    count("table4.ccga.runs", "30", 30),
    count("table4.ccga.successes", "13", 13),
    count("table4.ccga.rate", "0.433", 0.433),
    spread("table4.ccga.l1", "35.2982 (0.1530)", 35.2982, 0.1530),
    spread("table4.ccga.l2", "35.1467 (0.1413)", 35.1467, 0.1413),
    spread("table4.ccga.l3", "35.2329 (0.1828)", 35.2329, 0.1828),
    km("table4.ccga.difference", "0.1515", 0.1515, "section 4.1, p. 11"),
    time("table4.ccga.time", "3.11", 3.11),

    km("table6.dcpso.l1", "35.0470", 35.0470, kTable6),
    km("table6.dcpso.l2", "35.0432", 35.0432, kTable6),
    km("table6.dcpso.l3", "35.0513", 35.0513, kTable6),
    km("table6.dcpso.d12", "0.9527", 0.9527, kTable6),
    km("table6.dcpso.d13", "1.0817", 1.0817, kTable6),
    km("table6.dcpso.d23", "1.2000", 1.2000, kTable6),
    km("table6.dcpso.difference", "0.0081", 0.0081, "section 4.2, p. 13"),

    words("curves2d.dcpso.curvature", "curve only; within 2", "1/km", "section 4.1, p. 11; Fig. 5"),
    words("curves2d.solo.curvature", "curve only; within 2", "1/km", "section 4.1, p. 11; Fig. 5"),
    words("curves2d.ccga.curvature", "curve only; within 2", "1/km", "section 4.1, p. 11; Fig. 5"),
    words("curves3d.dcpso.curvature", "curve only; within 2", "1/km", "section 4.2, p. 13; Fig. 7"),
    words("curves3d.dcpso.torsion", "curve only; within 2", "1/km", "section 4.2, p. 13; Fig. 7"),

    transit("fig5.peach.arrived", "72 of 72", 72, "-", kFig5),
    transit("fig5.peach3d.arrived", "69 of 72", 69, "-", kFig5),  // its caption: 3 out of 72 did not
    transit("fig5.peach3d.stuck", "2 of 12", 2, "-", "section IV-C"),
    transit("fig5.peach.median2", "plot only", std::nullopt, "m", kFig5),
    transit("fig5.peach.median4", "plot only", std::nullopt, "m", kFig5),
    transit("fig5.peach.median6", "plot only", std::nullopt, "m", kFig5),
    transit("fig5.peach3d.median2", "plot only", std::nullopt, "m", kFig5),
    transit("fig5.peach3d.median4", "plot only; significantly shorter", std::nullopt, "m", "section IV-C"),
    transit("fig5.peach3d.median6", "plot only", std::nullopt, "m", kFig5),
    transit("fig5.peach3d.under600", "more than 25 %", std::nullopt, "-", "section IV-C"),
    transit("fig5.peach3d.least6", "a bit smaller than 600", std::nullopt, "m", "section IV-C"),
    transit("fig5.peach3d.longest6", "in the largest swarms", std::nullopt, "-", "section IV-C"),

    transit("radio.matrix.limit", "500", 500, "kbit", "section IV-B2"),
    transit("fig8.peach3d.arrived", "picture only", std::nullopt, "-", "Fig. 8, section IV-D"),
    transit("fig9.peach3d.arrived", "picture only", std::nullopt, "-", "Fig. 9, section IV-E"),
});

}  // namespace

std::span<const PaperFigure> paper_figures() {
  return kFigures;
}

const PaperFigure* find_paper_figure(std::string_view key) {
  const auto found = std::ranges::find(kFigures, key, &PaperFigure::key);
  return found == kFigures.end() ? nullptr : &*found;
}

std::string_view citation_of(Paper paper) {
  return paper == Paper::Rendezvous ? "Z. Shao, F. Yan, Z. Zhou, X. Zhu, Path Planning for Multi-UAV Formation "
                                      "Rendezvous Based on Distributed "
                                      "Cooperative Particle Swarm Optimization, Appl. Sci. 2019, 9, 2621"
                                    : "E. Falomir, S. Chaumette, G. Guerrini, A 3D Mobility Model for Autonomous "
                                      "Swarms of Collaborative UAVs, "
                                      "2019, hal-02125133";
}

}  // namespace skein::reproduce
