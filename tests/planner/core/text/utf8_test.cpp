// Which bytes are UTF-8, and texts from outside made fit for one line of a message.
#include "planner/core/text/utf8.hpp"

#include <gtest/gtest.h>

namespace skein {
namespace {

TEST(Utf8, TellsWhatIsAndWhatIsNot) {
  for (const char* text : {"", "plain", "\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x90\xA6 bird", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_TRUE(is_utf8(text)) << text;
  }
  for (const char* text :
       {"\xFF", "a\xFE", "\xC3", "\xC0\x80", "\xE2\x82", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\x80"}) {
    EXPECT_FALSE(is_utf8(text)) << text;
  }
}

TEST(Utf8, OneLineHasNoByteThatBreaksALine) {
  EXPECT_EQ(one_line("caf\xC3\xA9"), "caf\xC3\xA9");
  EXPECT_EQ(one_line("a\nb\x1b[31m\xFF"), "a?b?[31m?");
}

TEST(Utf8, OneLineIsShortAndCutsNoCharacter) {
  const std::string text = std::string(300, 'a') + std::string(300, 'b');
  EXPECT_EQ(one_line(text, 25), "aaaaaaaaaa ... bbbbbbbbbb");
  std::string accents;
  for (int i = 0; i < 100; ++i) accents += "\xC3\xA9";
  for (std::size_t most = 16; most < 40; ++most) {
    const std::string line = one_line(accents, most);
    EXPECT_LE(line.size(), most);
    EXPECT_TRUE(is_utf8(line));
  }
}

}  // namespace
}  // namespace skein
