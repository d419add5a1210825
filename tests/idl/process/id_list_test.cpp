#include "idl/process/id_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein {
namespace {

using ::testing::ElementsAre;
using ::testing::Optional;

TEST(IdList, ReadsIdsAndRangesInAnyOrder) {
  EXPECT_THAT(id_list_from("3"), Optional(ElementsAre(3)));
  EXPECT_THAT(id_list_from("1-4"), Optional(ElementsAre(1, 2, 3, 4)));
  EXPECT_THAT(id_list_from("9,5-7,1"), Optional(ElementsAre(1, 5, 6, 7, 9)));
  EXPECT_THAT(id_list_from("256,2-2"), Optional(ElementsAre(2, 256)));
}

TEST(IdList, RefusesWhatIsNoListOrNamesAnIdTwice) {
  for (const char* text : {"", "0", "257", "-1", "1-", "-", "3-2", "1,", ",1", "1,,2", "1-3,2", "4,4", "1-300", " 1",
                           "1 ", "one", "1-2-3", "+1", "99999999999"}) {
    EXPECT_EQ(id_list_from(text), std::nullopt) << "'" << text << "'";
  }
}

TEST(IdList, WritesRunsOfThreeAndMoreAsRanges) {
  const auto text = [](std::vector<AgentId> ids) { return text_of(ids); };
  EXPECT_EQ(text({}), "");
  EXPECT_EQ(text({7}), "7");
  EXPECT_EQ(text({1, 2}), "1,2");
  EXPECT_EQ(text({1, 2, 3}), "1-3");
  EXPECT_EQ(text({1, 3, 5, 6, 7, 9, 10}), "1,3,5-7,9,10");
}

TEST(IdList, GoesThroughText) {
  for (unsigned set = 1; set < 512; ++set) {
    std::vector<AgentId> ids;
    for (AgentId id = 1; id <= 9; ++id) {
      if (((set >> (id - 1)) & 1U) != 0) ids.push_back(id);
    }
    EXPECT_THAT(id_list_from(text_of(ids)), Optional(ids));
  }
}

}  // namespace
}  // namespace skein
