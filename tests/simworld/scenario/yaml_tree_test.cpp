// The tree keeps kinds, texts and places, and nothing is expanded or converted.
#include "simworld/scenario/yaml_tree.hpp"

#include <gtest/gtest.h>

namespace skein::scenario {
namespace {

TEST(YamlTree, KeepsKindsTextsAndPlaces) {
  const YamlNode root = parse_yaml("a: 010\nb:\n  - x\n  - {c: \"yes\"}\nd: ~\n");
  ASSERT_EQ(root.kind, NodeKind::Map);
  ASSERT_EQ(root.children.size(), 3U);
  EXPECT_EQ(root.find("a")->text, "010");
  EXPECT_EQ(root.find("a")->place, (Place{1, 4, ""}));
  EXPECT_EQ(root.find("b")->key_place, (Place{2, 1, ""}));
  const YamlNode& list = *root.find("b");
  ASSERT_EQ(list.kind, NodeKind::List);
  const YamlNode& c = *list.children[1].find("c");
  EXPECT_TRUE(c.in_quotes);
  EXPECT_FALSE(list.children[0].in_quotes);
  EXPECT_EQ(c.place, (Place{4, 9, ""}));
  EXPECT_EQ(root.find("d")->kind, NodeKind::Null);
  EXPECT_EQ(root.find("none"), nullptr);
  EXPECT_EQ(list.find("c"), nullptr);
}

TEST(YamlTree, AnEmptyTextIsNull) {
  EXPECT_EQ(parse_yaml("").kind, NodeKind::Null);
  EXPECT_EQ(parse_yaml("# only a comment\n").kind, NodeKind::Null);
}

TEST(YamlTree, AMissingValueIsPlacedAtItsKey) {
  const YamlNode root = parse_yaml("a:\n\n\nb: 1\n");
  EXPECT_EQ(root.find("a")->place, (Place{1, 1, ""}));
}

TEST(YamlTree, APlaceInAnOverrideNamesItsKey) {
  EXPECT_EQ(parse_yaml("[1, 2]", "x.y").children[1].place, (Place{1, 5, "x.y"}));
}

TEST(YamlTree, RefusesWhatIsNotPlain) {
  for (const char* text :
       {"a: &x 1", "a: *x", "a: !!str 1", "a: 1\na: 2", "? [a]\n: 1", "~: 1", "a: 1\n---\nb: 2", "a: [1", "a: {b: 1",
        "a: 'x", "a: \"\\q\"", "\tb: 1", "a: 1\n b: 2", "%YAML 9.9\n---\na: 1"}) {
    EXPECT_THROW((void)parse_yaml(text), ReadFault) << text;
  }
}

TEST(QuoteText, StaysOnOneLineAndShort) {
  EXPECT_EQ(quote_text("a\nb\x7f"), "'a\\x0ab\\x7f'");
  EXPECT_EQ(quote_text(std::string(100, 'x')), "'" + std::string(60, 'x') + "...'");
}

}  // namespace
}  // namespace skein::scenario
