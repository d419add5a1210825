// Files that are no scenario at all: missing, a directory, too long, hostile.
#include <gmock/gmock.h>

#include <filesystem>
#include <random>
#include <sstream>

#include "tests/simworld/scenario/scenarios.hpp"

namespace skein::test {
namespace {

using namespace std::string_literals;

constexpr const char* kRemedy = "; allowed: a readable scenario file of at most 1 MB";

class Files : public testing::Test {
 protected:
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    path_ = testing::TempDir() + "skein_scenario_" + name + ".yaml";
  }
  void TearDown() override { std::filesystem::remove(path_); }

  std::string fault_of(const std::string& text) {
    std::ofstream(path_, std::ios::binary) << text;
    return fault_line(load_scenario(path_, {}, std::nullopt));
  }

  std::string path_;
};

TEST_F(Files, MissingIsSaid) {
  EXPECT_EQ(fault_line(load_scenario(path_, {}, std::nullopt)),
            path_ + ":1:1: cannot be read (No such file or directory)" + kRemedy);
}

TEST_F(Files, ADirectoryIsSaid) {
  EXPECT_EQ(fault_line(load_scenario(testing::TempDir(), {}, std::nullopt)),
            testing::TempDir() + ":1:1: this is a directory" + kRemedy);
}

TEST_F(Files, OneMegabyteIsReadAndOneByteMoreIsNot) {
  const std::string small = text_of(kDataDir + "small.yaml");
  const std::string filler = small + "#" + std::string(1'000'000 - small.size() - 1, '-');
  EXPECT_EQ(fault_of(filler), "no fault");
  EXPECT_EQ(fault_of(filler + "-"), path_ + ":1:1: longer than 1 MB" + kRemedy);
}

TEST_F(Files, AManifoldAliasIsRefusedUnexpanded) {
  std::ostringstream bomb;
  bomb << "a0: &a0 [x, x]\n";
  for (int i = 1; i < 100; ++i) bomb << "a" << i << ": &a" << i << " [*a" << i - 1 << ", *a" << i - 1 << "]\n";
  EXPECT_EQ(fault_of(bomb.str()), path_ + ":1:5: anchors (&x) and aliases (*x) are not allowed; write the value out");
}

TEST_F(Files, EndlessNestingIsRefused) {
  EXPECT_EQ(fault_of("name: " + std::string(500'000, '[')),
            path_ + ":1:8: a key is a list or a map (is a bracket open?); allowed: a word before the colon");
  std::string deep;
  for (std::size_t i = 0; i < 400; ++i) deep += std::string(i, ' ') + "a:\n";
  EXPECT_EQ(fault_of(deep), path_ + ":17:17: nested too deep; allowed: 16 levels");
}

TEST_F(Files, TooManyValuesAreRefused) {
  std::ostringstream many;
  for (int i = 0; i < 60'000; ++i) many << "k" << i << ": 1\n";
  EXPECT_EQ(fault_of(many.str()), path_ + ":20000:9: too many values; allowed: 20000 in a scenario");
}

TEST_F(Files, BytesThatAreNoTextStayOnOneLine) {
  const std::string line = fault_of("na\0me: \x01\x1b[31m\n\xff\xfe: \"\\\x07\""s);
  EXPECT_EQ(line.rfind(path_ + ":", 0), 0U) << line;
  for (const char c : line) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << line;
}

TEST(MutatedScenarios, AreReadOrRefusedInOneLine) {
  const std::string small = text_of(kDataDir + "small.yaml");
  const std::string alphabet = "0123456789-.:,[]{}&*!|>'\"#%@` \n\tab\x00\xff"s;
  std::mt19937 random(2);  // the same mutations in every run
  const auto pick = [&](std::size_t n) { return random() % n; };
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = small;
    for (std::size_t edits = 1 + pick(4); edits > 0; --edits) {
      const std::size_t place = pick(text.size());
      text.replace(place, pick(3), std::string(pick(2), alphabet[pick(alphabet.size())]));
    }
    const std::string line = fault_line(parse_scenario(text, "f", {}, std::nullopt));
    if (line == "no fault") continue;
    ++refused;
    EXPECT_THAT(line, testing::MatchesRegex("f:[0-9]+:[0-9]+: [^\n]+")) << text;
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace skein::test
