// The document: the same bytes for the same seeds, with any number of threads; what was interrupted says so.
#include "groundstation/reproduce/document.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace skein::reproduce {
namespace {

std::vector<Campaign> first_campaign() {
  return {campaigns_of(Paper::Rendezvous).at(0)};
}

Document made(unsigned jobs) {
  CampaignOptions options;
  options.seeds = 2;
  options.jobs = jobs;
  return document_of("skein reproduce rendezvous --seeds 2", {Paper::Rendezvous},
                     run_campaigns(first_campaign(), options));
}

TEST(Document, IsTheSameFileEachTime) {
  const std::string file = text_of(made(1), Layout::File);
  EXPECT_EQ(file, text_of(made(2), Layout::File));
  EXPECT_NE(file.find("`skein reproduce rendezvous --seeds 2`"), std::string::npos);
  EXPECT_NE(file.find("### Table 4"), std::string::npos);
  EXPECT_EQ(file.find("Interrupted"), std::string::npos);
}

TEST(Document, LinesOfTextAreNotLongerThanAllowed) {
  std::istringstream lines(text_of(made(2), Layout::File));
  for (std::string line; std::getline(lines, line);) {
    const bool prose = !line.starts_with("|") && !line.starts_with("skein sweep");
    if (prose) {
      EXPECT_LE(line.size(), 120U) << line;
    }
  }
}

TEST(Document, HasASectionForWhatWasRunAlone) {
  CampaignOptions options;
  options.seeds = 1;
  const Results results = run_campaigns(first_campaign(), options);
  const Document document = document_of("c", {Paper::Rendezvous, Paper::Transit}, results);
  ASSERT_EQ(document.sections.size(), 1U);
  EXPECT_EQ(document.sections[0].commands.size(), 1U);
  EXPECT_EQ(json_of(document).at("campaigns").at(0).at("name"), "rendezvous-2d");
}

TEST(Document, SaysThatItWasInterrupted) {
  CampaignOptions options;
  options.seeds = 2;
  options.stop = [] { return true; };
  const Document document = document_of("c", {Paper::Rendezvous}, run_campaigns(first_campaign(), options));
  EXPECT_NE(text_of(document, Layout::Terminal).find("Interrupted"), std::string::npos);
  EXPECT_EQ(json_of(document).at("complete"), false);
}

}  // namespace
}  // namespace skein::reproduce
