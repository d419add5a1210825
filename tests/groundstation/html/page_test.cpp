// A page holds what it is given, as text and never as markup.
#include "groundstation/html/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "groundstation/html/pages.hpp"

namespace skein::html {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Page, EscapesEverything) {
  EXPECT_EQ(escaped("<b a=\"1\" c='2'>&"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;");
  EXPECT_EQ(escaped("a\nb\tä"), "a\nb\tä");
  EXPECT_EQ(escaped(std::string("\x01\xff\xc3", 3)), "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");
  EXPECT_EQ(escaped("\xed\xa0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");  // half of a pair
  EXPECT_EQ(escaped("\xc0\xaf"), "\xEF\xBF\xBD\xEF\xBF\xBD");                  // too long for what it says
}

TEST(Page, NothingGivenBecomesMarkup) {
  const std::string evil = "<script>alert(1)</script>";
  Page page(evil);
  page.heading(evil).paragraph(evil).verdict(evil, true).notes({evil}).facts({{evil, evil}}).table({evil}, {{evil}});
  page.objects(evil, Json{{{evil, evil}}}, 5).preformatted(evil).folded(evil, evil).figure("", evil);
  EXPECT_THAT(page.text(), Not(HasSubstr("<script")));
  EXPECT_THAT(page.text(), HasSubstr("&lt;script&gt;"));
}

TEST(Page, PicturesHaveIdsOfTheirOwn) {
  const std::string svg =
      "<?xml version=\"1.0\"?>\n<svg \n width=\"3\" viewBox=\"0 0 3 2\"\n>\n<g id=\"a\"><circle id='p'/>"
      "<use xlink:href='#p'/><g style=\"fill: url(#a)\"/></g></svg>";
  const std::string part = inline_svg(svg, "paths-", "a <label>");
  EXPECT_THAT(part, HasSubstr("viewBox=\"0 0 3 2\">"));
  EXPECT_THAT(part, HasSubstr("aria-label=\"a &lt;label&gt;\""));
  EXPECT_THAT(part, HasSubstr("<g id=\"paths-a\"><circle id='paths-p'/><use xlink:href='#paths-p'/>"));
  EXPECT_THAT(part, HasSubstr("url(#paths-a)"));
  EXPECT_THAT(part, Not(HasSubstr("<?xml")));
  EXPECT_EQ(inline_svg("no picture", "x", ""), "");
}

TEST(Page, ShellWordsAreQuotedWhereTheyMustBe) {
  EXPECT_EQ(shell_word("deploy/a-b_1.yaml"), "deploy/a-b_1.yaml");
  EXPECT_EQ(shell_word("a b"), "'a b'");
  EXPECT_EQ(shell_word("it's; rm"), "'it'\\''s; rm'");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(override_words("a.b", "[1, 2]"), "--set 'a.b=[1, 2]'");
  EXPECT_EQ(override_words("--agents", "3"), "--agents 3");
}

TEST(Page, ValuesAreWrittenForPeople) {
  EXPECT_EQ(text_of(Json(1.0 / 3.0)), "0.3333333");
  EXPECT_EQ(text_of(Json(nullptr)), "–");
  EXPECT_EQ(text_of(Json::array({1, "b", true})), "1, b, yes");
}

TEST(Page, TablesOfObjectsEndWhereTheyAreTold) {
  Json list = Json::array();
  for (int i = 0; i < 5; ++i) list.push_back({{"step", i}});
  Page page("p");
  page.objects("Steps", list, 3);
  EXPECT_THAT(page.text(), HasSubstr("2 more are in the report."));
  EXPECT_THAT(page.text(), Not(HasSubstr("<td>3</td>")));
}

figure::RunInput run_input() {
  figure::RunInput input;
  input.name = "run.mcap";
  input.scenario_path = "my scenario.yaml";
  input.scenario_text = "name: <x>";
  input.overrides = {{"--agents", "3"}};
  input.report = {{"success", true},
                  {"exit_code", 0},
                  {"reason", "all <arrived>"},
                  {"state_hash", "00ff00ff00ff00ff"},
                  {"seed", 18446744073709551615U},
                  {"carrier", "in-process"},
                  {"vehicles", Json::array()},
                  {"commands", {{{"step", 4}, {"kind", "hold"}}}}};
  return input;
}

TEST(RunPage, HoldsSeedHashScenarioAndCommands) {
  const std::string page = page_of(run_input(), {{}, {"torsion: none"}, "9.9", "skein report run.mcap"});
  for (const char* part : {"18446744073709551615", "00ff00ff00ff00ff", "name: &lt;x&gt;", "all &lt;arrived&gt;",
                           "skein run &#39;my scenario.yaml&#39; --seed 18446744073709551615 --agents 3 --in-process",
                           "skein report run.mcap", "Not drawn: torsion: none.", "hold", "skein 9.9"}) {
    EXPECT_THAT(page, HasSubstr(part));
  }
}

TEST(RunPage, LossesAndCommandsAreRepeatedByTheCommandThatRunsItAgain) {
  figure::RunInput input = run_input();
  input.name = "runs/one";
  for (const char* events : {"roster_changes", "commands", "injections"}) {
    for (const char* name : {"roster_changes", "commands", "injections"}) input.report[name] = nlohmann::json::array();
    EXPECT_THAT(rerun_command(input), Not(HasSubstr("--roster")));
    input.report[events] = {{{"step", 1}}};
    EXPECT_THAT(rerun_command(input), HasSubstr("--in-process --roster runs/one/report.json"));
  }
  input.facts["recorder"] = "barrier";
  EXPECT_EQ(rerun_command(input), "skein verify runs/one --rerun");
}

TEST(RunPage, WithoutAReportItSaysSo) {
  figure::RunInput input;
  input.name = "cut.mcap";
  input.notes = {"the file is not whole"};
  const std::string page = page_of(input, {{}, {}, "9.9", "skein report cut.mcap"});
  EXPECT_THAT(page, HasSubstr("no report"));
  EXPECT_THAT(page, HasSubstr("the file is not whole"));
  EXPECT_THAT(page, HasSubstr("The scenario is not known."));
}

}  // namespace
}  // namespace skein::html
