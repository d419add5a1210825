// The fields that the embedded IDL names are those that the generated types wrote.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "groundstation/schema/decode.hpp"
#include "groundstation/schema/topics.hpp"
#include "idl/convert/cdr.hpp"
#include "tests/idl/convert/examples.hpp"

namespace skein::schema {
namespace {

using bus::TopicId;

template <typename Value>
Json decoded(TopicId topic, const Value& value) {
  return decode(type_of(topic), to_cdr(to_wire(value, examples::kStamp))).value();
}

TEST(Schema, EachTopicHasItsIdlWithNothingLeftToInclude) {
  for (const bus::TopicSpec& spec : bus::kTopics) {
    EXPECT_EQ(type_of(spec.id).name, spec.type);
    EXPECT_EQ(idl_of(spec.id).find("#include"), std::string_view::npos);
    EXPECT_EQ(type_of(spec.id).fields.front().name, "head");
    EXPECT_EQ(topic_named(spec.name), &bus::topic(spec.id));
  }
  EXPECT_EQ(topic_named("skein/else"), nullptr);
}

TEST(Schema, DecodesWhatTheGeneratedTypesWrote) {
  const Json beacon = decoded(TopicId::Beacon, examples::beacon());
  const wire::Beacon wired = to_wire(examples::beacon(), examples::kStamp);
  EXPECT_EQ(beacon["head"]["run"], std::to_string(wired.head().run()));
  EXPECT_EQ(beacon["head"]["stamp_ns"], "1234567890123");
  EXPECT_EQ(beacon["agent"], wired.agent());
  EXPECT_EQ(beacon["nonce"], std::to_string(wired.nonce()));
  EXPECT_EQ(beacon["needs"].size(), wired.needs().size());
  EXPECT_EQ(beacon["own"]["position_m"]["y"], wired.own().position_m().y());
  EXPECT_EQ(beacon["predicted_separation_m"], wired.predicted_separation_m());
  EXPECT_EQ(beacon["state_hash"], std::to_string(wired.state_hash()));

  const Json mission = decoded(TopicId::Mission, examples::mission());
  const wire::Mission mission_wired = to_wire(examples::mission(), examples::kStamp);
  EXPECT_EQ(mission["name"], "two geese");
  EXPECT_EQ(mission["vehicles"][1]["max_acceleration_mps2"], 6.5);
  EXPECT_EQ(mission["zones"].size(), 2U);
  EXPECT_EQ(mission["planner"]["name"], mission_wired.planner().name().to_string());
  EXPECT_EQ(mission["planner"]["rounds_per_step"], 12);
  EXPECT_EQ(mission["controller_name"], "orca");
  EXPECT_EQ(mission["announced"][1]["clear_s"], 0.5);
}

TEST(Schema, RefusesWhatIsNoSampleOfTheType) {
  const Bytes good = to_cdr(to_wire(examples::beacon(), examples::kStamp));
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_EQ(decode(type_of(TopicId::Beacon), std::span(good).first(size)), std::nullopt) << size;
  }
  EXPECT_EQ(decode(type_of(TopicId::Beacon), Bytes(200, 0xFF)), std::nullopt);
}

TEST(Schema, SaysAtWhichFieldBytesStopBeingASample) {
  const Struct type =
      parse_idl("struct B { boolean d; }; struct A { octet a; sequence<B, 2> b; unsigned long c; string<4> e; };", "A");
  const Bytes good{0, 1, 0, 0, 7, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 9, 0, 0, 0, 3, 0, 0, 0, 'h', 'i', 0};
  const auto fault = [&](std::size_t at, std::uint8_t octet, std::size_t size) {
    Bytes bad(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
    if (at < size) bad[at] = octet;
    EXPECT_EQ(decode(type, bad), std::nullopt);
    return first_null(decode(type, good).value(), decode_partly(type, bad)).value();
  };
  EXPECT_EQ(fault(13, 2, good.size()).field, "b[1].d");
  EXPECT_EQ(fault(13, 2, good.size()).a, false);
  EXPECT_EQ(fault(8, 3, good.size()).field, "b");
  EXPECT_EQ(fault(0, 0, 18).field, "c");
  EXPECT_EQ(fault(0, 0, 18).a, 9);
  EXPECT_EQ(fault(26, 1, good.size()).field, "e");
  EXPECT_EQ(first_null(decode(type, good).value(), decode_partly(type, good)), std::nullopt);
  EXPECT_TRUE(decode_partly(type, Bytes{9, 9}).is_null());
}

TEST(Schema, ReadsBigEndianBytes) {
  const Struct type = parse_idl("struct A { octet a; unsigned long b; string<4> c; short d[2]; };", "A");
  const Bytes big{0, 0, 0, 0, 7, 0, 0, 0, 0, 0, 1, 2, 0, 0, 0, 3, 'h', 'i', 0, 0, 0xFF, 0xFE, 0, 5};
  EXPECT_EQ(decode(type, big), (Json{{"a", 7}, {"b", 258}, {"c", "hi"}, {"d", {-2, 5}}}));
}

TEST(Schema, NamesTheFirstFieldThatDiffers) {
  const Json a{{"x", 1}, {"list", {{{"y", 0.0}}, {{"y", 2.0}}}}};
  EXPECT_EQ(first_difference(a, a), std::nullopt);
  Json b = a;
  b["list"][1]["y"] = 2.5;
  const auto inside = first_difference(a, b).value();
  EXPECT_EQ(inside.field, "list[1].y");
  EXPECT_EQ(inside.b, 2.5);
  b["list"][0]["y"] = -0.0;
  EXPECT_EQ(first_difference(a, b).value().field, "list[0].y");
  Json shorter = a;
  shorter["list"].erase(1);
  EXPECT_EQ(first_difference(a, shorter).value().field, "list[1]");
  EXPECT_EQ(first_difference(a, shorter).value().b, nullptr);
}

TEST(Schema, SaysWhereAnIdlIsWrong) {
  const auto message = [](const char* text) -> std::string {
    try {
      (void)parse_idl(text, "A");
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  EXPECT_EQ(message("struct A { long a; };"), "");
  EXPECT_EQ(message("struct B { long a; };"), "the IDL has no struct A");
  EXPECT_EQ(message("struct A {\n Else b; };"), "IDL line 2: type 'Else' is not known");
  EXPECT_EQ(message("struct A { sequence<long, x> a; };"), "IDL line 1: 'x' is no number");
  EXPECT_EQ(message("struct A { long a; "), "IDL line 1: the text ends too early");
  EXPECT_EQ(message("union A { };"), "IDL line 1: 'union' stands where 'struct' is expected");
}

}  // namespace
}  // namespace skein::schema
