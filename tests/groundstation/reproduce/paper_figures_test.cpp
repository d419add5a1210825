// The papers' figures: each has a source and a unit, and says as text what it says as a number.
#include "groundstation/reproduce/paper_figures.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace skein::reproduce {
namespace {

TEST(PaperFigures, EachHasItsPlaceUnitAndText) {
  const std::set<std::string_view> units{"-", "km", "m", "s", "1/km", "kbit"};
  ASSERT_GT(paper_figures().size(), 50U);
  for (const PaperFigure& figure : paper_figures()) {
    const bool placed = figure.source.starts_with("Table ") || figure.source.starts_with("Fig. ") ||
                        figure.source.starts_with("section ");
    EXPECT_TRUE(placed) << figure.key << ": " << figure.source;
    EXPECT_TRUE(units.contains(figure.unit)) << figure.key << ": " << figure.unit;
    EXPECT_FALSE(figure.text.empty()) << figure.key;
  }
}

TEST(PaperFigures, OfTheFirstPaperNameThePage) {
  for (const PaperFigure& figure : paper_figures()) {
    if (figure.paper != Paper::Rendezvous) continue;
    EXPECT_NE(figure.source.find(", p. 1"), std::string_view::npos) << figure.key << ": " << figure.source;
  }
}

TEST(PaperFigures, KeysAreUnique) {
  std::set<std::string_view> keys;
  for (const PaperFigure& figure : paper_figures()) EXPECT_TRUE(keys.insert(figure.key).second) << figure.key;
}

TEST(PaperFigures, TextAndNumbersAgree) {
  for (const PaperFigure& figure : paper_figures()) {
    if (!figure.value) continue;
    const std::string text(figure.text);
    const std::size_t first = text.find_first_of("0123456789");
    ASSERT_NE(first, std::string::npos) << figure.key;
    EXPECT_DOUBLE_EQ(std::stod(text.substr(first)), *figure.value) << figure.key;
    const std::size_t bracket = text.find('(');
    ASSERT_EQ(bracket != std::string::npos, figure.sd.has_value()) << figure.key;
    if (figure.sd) {
      EXPECT_DOUBLE_EQ(std::stod(text.substr(bracket + 1)), *figure.sd) << figure.key;
    }
  }
}

TEST(PaperFigures, AreFoundByTheirKeys) {
  const PaperFigure* figure = find_paper_figure("table4.dcpso.l2");
  ASSERT_NE(figure, nullptr);
  EXPECT_EQ(figure->value, 35.0310);
  EXPECT_EQ(figure->sd, 0.0673);
  EXPECT_EQ(find_paper_figure("table4.dcpso.l4"), nullptr);
}

}  // namespace
}  // namespace skein::reproduce
