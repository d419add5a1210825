// Figures as text: what can be drawn is, what cannot says why, and no name leaves its quotes.
#include "groundstation/figure/figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "groundstation/figure/gnuplot.hpp"
#include "groundstation/figure/gnuplot_text.hpp"
#include "groundstation/record/tap.hpp"
#include "tests/groundstation/record/recorded.hpp"

namespace skein::figure {
namespace {

using ::testing::HasSubstr;

RunInput small_run(const std::string& scenario_name) {
  const Scenario scenario = tests::small_scenario(scenario_name, 7);
  RunCollector collector;
  InProcessOptions options;
  options.tap = [&](AgentId, const wire::Sample& sample) { collector.add(topic_of(sample), payload_of(sample)); };
  RunInput input;
  input.report = run_in_process(scenario, options).report;
  input.data = collector.data();
  for (const Zone& zone : scenario.mission.zones) input.outlines.push_back(outline_of(zone));
  return input;
}

std::string reason_of(const Sketched& sketched) {
  const auto* none = std::get_if<NoSketch>(&sketched);
  return none == nullptr ? "" : none->reason;
}

TEST(Figures, NamesAreThoseOfTheirKinds) {
  for (const std::string_view name : kFigureNames) EXPECT_EQ(name_of(figure_from(name).value()), name);
  EXPECT_FALSE(figure_from("pie"));
}

TEST(Figures, OfAPlanarRendezvousAllButThoseInSpaceAreDrawn) {
  const Input input = small_run("small");
  for (const FigureKind kind : {FigureKind::Paths, FigureKind::Curvature, FigureKind::Separation, FigureKind::Cost}) {
    const Sketched sketched = sketch(kind, input);
    ASSERT_EQ(reason_of(sketched), "") << name_of(kind);
    const std::string svg = draw(script_of(std::get<Sketch>(sketched), Format::Svg));
    EXPECT_THAT(svg, HasSubstr("</svg>")) << name_of(kind);
    EXPECT_FALSE(std::get<Sketch>(sketched).caption.empty());
  }
  EXPECT_THAT(reason_of(sketch(FigureKind::Paths3d, input)), HasSubstr("plane"));
  EXPECT_THAT(reason_of(sketch(FigureKind::Torsion, input)), HasSubstr("plane"));
  EXPECT_THAT(reason_of(sketch(FigureKind::Box, input)), HasSubstr("sweeps"));
}

TEST(Figures, OfATransitThereAreNoPlans) {
  const Input input = small_run("small-transit");
  EXPECT_EQ(reason_of(sketch(FigureKind::Paths, input)), "");
  EXPECT_THAT(reason_of(sketch(FigureKind::Curvature, input)), HasSubstr("plan"));
  EXPECT_THAT(reason_of(sketch(FigureKind::Cost, input)), HasSubstr("generations"));
}

TEST(Figures, AxesNameTheirUnits) {
  const Input input = small_run("small");
  EXPECT_THAT(std::get<Sketch>(sketch(FigureKind::Paths, input)).commands, HasSubstr("set xlabel 'x (km)'"));
  EXPECT_THAT(std::get<Sketch>(sketch(FigureKind::Separation, input)).commands, HasSubstr("'time (s)'"));
}

TEST(Figures, OfNothingNothingIsDrawn) {
  EXPECT_THAT(reason_of(sketch(FigureKind::Paths, RunInput{})), HasSubstr("no samples"));
}

Json run_with(double value) {
  return {{"seed", 1}, {"figures", {{"steps", value}}}};
}

SweepInput sweep_of(const std::string& name) {
  SweepInput input;
  for (const double at : {1.0, 5.0}) {
    Json row;
    row["set"] = {{"planner.name", name}};
    row["runs"] = 3;
    row["failures"] = Json::array();
    row["per_run"] = {run_with(at), run_with(at + 1.0), run_with(at + 4.0)};
    input.document["rows"].push_back(row);
  }
  return input;
}

TEST(Figures, BoxesOfASweepAreDrawn) {
  const Sketched sketched = sketch(FigureKind::Box, sweep_of("dcpso"));
  ASSERT_EQ(reason_of(sketched), "");
  EXPECT_THAT(draw(script_of(std::get<Sketch>(sketched), Format::Svg)), HasSubstr("planner.name"));
  EXPECT_EQ(reason_of(sketch(FigureKind::Box, sweep_of("dcpso"), "steps")), "");
  EXPECT_THAT(reason_of(sketch(FigureKind::Box, sweep_of("dcpso"), "nonsense")), HasSubstr("'nonsense'"));
}

TEST(Figures, ANameStaysInItsQuotes) {
  EXPECT_EQ(quote("it's\n`id`"), "'it\xE2\x80\x99s `id`'");
  const Sketched sketched = sketch(FigureKind::Box, sweep_of("'; system('echo gone >&2') #\\"));
  ASSERT_EQ(reason_of(sketched), "");
  const std::string svg = draw(script_of(std::get<Sketch>(sketched), Format::Svg));
  EXPECT_THAT(svg, HasSubstr("echo gone"));
}

TEST(Figures, FortyCurvesAreAllDifferent) {
  std::set<std::string> looks;
  for (std::size_t i = 0; i < 40; ++i) looks.insert(colour(i) + dash(i));
  EXPECT_EQ(looks.size(), 40U);
}

TEST(Figures, ManyPointsAreThinned) {
  RunInput input = small_run("small");
  VehicleTrace& first = input.data.vehicles.front();
  const TracePoint point = first.flown.front();
  first.flown.clear();
  for (std::uint32_t step = 1; step <= 100'000; ++step) first.flown.push_back({step, point.position_m, true});
  EXPECT_LT(std::get<Sketch>(sketch(FigureKind::Paths, input)).commands.size(), 1'000'000U);
}

}  // namespace
}  // namespace skein::figure
