// The bytes on the wire stand: a change of these files is a change of the wire version.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "idl/convert/cdr.hpp"
#include "tests/idl/convert/examples.hpp"

namespace skein {
namespace {

std::string hex(const Bytes& bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    text += kDigits[bytes[i] >> 4];
    text += kDigits[bytes[i] & 15];
    if (i % 32 == 31) text += '\n';
  }
  if (!text.ends_with('\n')) text += '\n';
  return text;
}

std::string golden(const std::string& name) {
  std::ifstream file(std::string(SKEIN_SOURCE_DIR) + "/tests/idl/convert/golden/" + name + ".hex");
  return {std::istreambuf_iterator<char>(file), {}};
}

template <typename Plain>
std::string bytes_of(const Plain& value) {
  return hex(to_cdr(to_wire(value, examples::kStamp)));
}

TEST(Golden, Mission) {
  EXPECT_EQ(bytes_of(examples::mission()), golden("mission"));
}
TEST(Golden, MissionOfATransit) {
  EXPECT_EQ(bytes_of(examples::crossing()), golden("crossing"));
}
TEST(Golden, ObstacleMap) {
  EXPECT_EQ(bytes_of(examples::obstacle_map()), golden("obstacle_map"));
}
TEST(Golden, Tick) {
  EXPECT_EQ(bytes_of(examples::tick()), golden("tick"));
}
TEST(Golden, Sense) {
  EXPECT_EQ(bytes_of(examples::sense()), golden("sense"));
}
TEST(Golden, Representative) {
  EXPECT_EQ(bytes_of(examples::representative()), golden("representative"));
}
TEST(Golden, Revision) {
  EXPECT_EQ(bytes_of(examples::revision()), golden("revision"));
}
TEST(Golden, Beacon) {
  EXPECT_EQ(bytes_of(examples::beacon()), golden("beacon"));
}

TEST(Golden, Command) {
  EXPECT_EQ(bytes_of(examples::command()), golden("command"));
}
TEST(Golden, Inject) {
  EXPECT_EQ(bytes_of(examples::inject()), golden("inject"));
}

TEST(Golden, SenseByHand) {
  // Encapsulation CDR_LE; run 77; stamp 1234567890123 = 0x11f71fb04cb; sender 0, incarnation 2; agent 3, round 6;
  // then 1.5 = 0x3ff8000000000000 on an 8-byte boundary.
  EXPECT_TRUE(bytes_of(examples::sense())
                  .starts_with("00010000"
                               "4d00000000000000"
                               "cb04fb711f010000"
                               "00000000"
                               "02000000"));
  EXPECT_EQ(to_cdr(to_wire(examples::sense(), examples::kStamp)).size(),
            4u + 24 + 8 + 8 * 8 + (4 + 4 + 6 * 8 + 1) + 3 + 7 * 4 + 2 +
                // two tracks; the zones; obeyed
                2 + 4 + (4 + 4 + 7 * 8 + 2) + (2 + 4 + 7 * 8 + 2) + (2 + 4 + 2) + 1);
}

}  // namespace
}  // namespace skein
