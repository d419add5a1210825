// Wire structs as bytes in files are the bytes that DDS carries, and nothing else is read back.
#include "idl/convert/cdr.hpp"

#include <gtest/gtest.h>

#include "idl/convert/convert.hpp"
#include "tests/idl/convert/examples.hpp"

namespace skein {
namespace {

template <typename Wire>
void expect_there_and_back(const Wire& sample) {
  const Bytes bytes = to_cdr(sample);
  const std::optional<Wire> back = from_cdr<Wire>(bytes);
  ASSERT_TRUE(back.has_value());
  EXPECT_TRUE(*back == sample);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_FALSE(from_cdr<Wire>(std::span(bytes).first(size)).has_value()) << size;
  }
}

TEST(Cdr, AnswersGoToBytesAndBackAndWhatIsTornIsNothing) {
  expect_there_and_back(to_wire(examples::beacon(), examples::kStamp));
  expect_there_and_back(to_wire(examples::representative(), examples::kStamp));
  expect_there_and_back(to_wire(examples::revision(), examples::kStamp));
  expect_there_and_back(to_wire(examples::obstacle_map(), examples::kStamp));
}

}  // namespace
}  // namespace skein
