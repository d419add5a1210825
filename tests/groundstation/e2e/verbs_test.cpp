// The command line as a whole, through the binary itself: every verb that `skein --help` lists has help with an
// example, JSON where it prints, and one line and the right exit code for each failure (verb_table.cpp).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <sstream>

#include "groundstation/mcap/file.hpp"
#include "groundstation/mcap/reader.hpp"
#include "tests/groundstation/e2e/skein.hpp"
#include "tests/groundstation/e2e/verb_table.hpp"

namespace skein::e2e {
namespace {

using ::testing::HasSubstr;

const std::string kDomain = "102";
const std::string kLive = "verbs-live";
const std::string kSmall = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";
const std::string kBroken = std::string(SKEIN_SOURCE_DIR) + "/tests/data/broken/unknown_key.yaml";

Ended skein(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{binary("skein")};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_program(command, 120.0);
}

/// First words of the lines under "Subcommands:".
std::vector<std::string> verbs_listed() {
  std::istringstream help(skein({"--help"}).out);
  std::vector<std::string> verbs;
  bool listed = false;
  for (std::string line; std::getline(help, line);) {
    if (listed && line.starts_with("  ") && line.size() > 2 && line[2] != ' ') {
      verbs.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    listed = listed || line.starts_with("Subcommands:");
  }
  return verbs;
}

class Verbs : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    files = std::make_unique<ScratchFolder>();
    const std::string file = files->path() + "/a.mcap";
    (void)skein_run(kSmall, 102, files->path() + "/a", {"--in-process", "--record", file});
    std::string bytes;
    {
      const mcap::MappedFile mapped(file);
      bytes.assign(mapped.bytes().begin(), mapped.bytes().end());
      const mcap::ChunkIndex chunk = mcap::Reader(mapped.bytes()).contents().chunks.front();
      bytes[chunk.chunk_offset + chunk.chunk_length / 2] ^= 0x20;
    }
    std::ofstream(files->path() + "/damaged.mcap", std::ios::binary) << bytes;
    std::ofstream(files->path() + "/text") << "neither a recording nor a scenario\n";
  }
  static void TearDownTestSuite() { files.reset(); }

  static std::string filled(std::string text) {
    const std::vector<std::pair<std::string, std::string>> values{{"$GOOD", kSmall},
                                                                  {"$BROKEN", kBroken},
                                                                  {"$FILE", files->path() + "/a.mcap"},
                                                                  {"$DOMAIN", kDomain},
                                                                  {"$LIVE", kLive},
                                                                  {"$DAMAGED", files->path() + "/damaged.mcap"},
                                                                  {"$OUT", files->path()},
                                                                  {"$TEXT", files->path() + "/text"},
                                                                  {"$NONE", files->path() + "/none"}};
    for (const auto& [name, value] : values) {
      for (auto at = text.find(name); at != std::string::npos; at = text.find(name, at + value.size())) {
        text.replace(at, name.size(), value);
      }
    }
    return text;
  }
  static std::vector<std::string> filled(std::vector<std::string> texts) {
    for (std::string& text : texts) text = filled(text);
    return texts;
  }
  /// Until it is destroyed.
  static std::unique_ptr<Program> swarm_for(Needs needs) {
    if (needs == Needs::Nothing) return nullptr;
    std::vector<std::string> command{
        binary("skein"), "run",   kSmall,    "--json", "--out",      files->path() + "/live",
        "--domain",      kDomain, "--swarm", kLive,    "--realtime", "20"};
    if (needs == Needs::Start) command.emplace_back("--wait-start");
    auto run = std::make_unique<Program>(command);
    if (needs == Needs::Swarm) {
      EXPECT_TRUE(run->read_until("flight: step 1,", 60.0));
    }
    return run;
  }

  static inline std::unique_ptr<ScratchFolder> files;
};

TEST_F(Verbs, EachOneThatIsListedHasARow) {
  std::vector<std::string> rows;
  for (const VerbRow& row : verb_rows()) rows.push_back(row.verb);
  EXPECT_THAT(rows, ::testing::UnorderedElementsAreArray(verbs_listed()));
  EXPECT_GE(rows.size(), 27U);
}

TEST_F(Verbs, EachHasHelpWithAnExampleOfItself) {
  for (const std::string& verb : verbs_listed()) {
    SCOPED_TRACE(verb);
    const Ended help = skein({verb, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_THAT(help.out, HasSubstr("\nExample: skein " + verb));
  }
}

TEST_F(Verbs, EachPrintsJsonThatParses) {
  for (const VerbRow& row : verb_rows()) {
    SCOPED_TRACE(row.verb);
    if (row.prints == Prints::Screen) {
      EXPECT_THAT(skein({row.verb, "--help"}).out, ::testing::Not(HasSubstr("--json")));
      continue;
    }
    const auto swarm = swarm_for(row.needs);
    std::vector<std::string> arguments{row.verb, "--json"};
    const auto more = filled(row.arguments);
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = skein(arguments);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    std::istringstream out(row.prints == Prints::Lines ? ended.out : "");
    std::vector<std::string> documents;
    for (std::string line; std::getline(out, line);) documents.push_back(line);
    if (row.prints == Prints::Document) documents.push_back(ended.out);
    EXPECT_FALSE(documents.empty());
    for (const std::string& document : documents) {
      EXPECT_FALSE(nlohmann::json::parse(document, nullptr, false).is_discarded()) << document;
    }
  }
}

TEST_F(Verbs, AFlagThatThereIsNotGivesOneLineAndExitCode2) {
  for (const std::string& verb : verbs_listed()) {
    SCOPED_TRACE(verb);
    const Ended ended = skein({verb, "--no-such-flag"});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
  }
}

TEST_F(Verbs, EachFailureHasItsExitCodeAndOneLine) {
  for (const FailureRow& row : failure_rows()) {
    const Ended ended = skein(filled(row.arguments));
    SCOPED_TRACE(testing::PrintToString(row.arguments) + "\n" + ended.err);
    EXPECT_EQ(ended.exit_code, row.exit_code);
    EXPECT_THAT(ended.err, HasSubstr(filled(row.text)));
    EXPECT_LT(ended.err.size(), 1000U);
    if (row.says == Says::OneLine) {
      EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1);
    }
  }
}

TEST_F(Verbs, RunsThatDifferGive1) {
  const std::string other = files->path() + "/other.mcap";
  ASSERT_EQ(
      skein_run(kSmall, 102, files->path() + "/b", {"--in-process", "--seed", "8", "--record", other}).ended.exit_code,
      0);
  const Ended ended = skein({"verify", files->path() + "/a.mcap", other, "--json"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_EQ(nlohmann::json::parse(ended.out)["difference"]["field"], "seed");
  EXPECT_EQ(ended.err, "");
}

}  // namespace
}  // namespace skein::e2e
