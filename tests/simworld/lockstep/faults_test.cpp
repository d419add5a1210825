// Faults on purpose, as they are written.
#include "simworld/lockstep/faults.hpp"

#include <gtest/gtest.h>

namespace skein {
namespace {

constexpr const char* kAllowed = "; allowed: kill|stop|cont|restart:ID@plan:ROUND or @fly:STEP, or kill:world@...";

TEST(Faults, ReadWhatTheyWrite) {
  for (const Fault& fault :
       {Fault{FaultKind::Kill, 2, Phase::Planning, 25}, Fault{FaultKind::Stop, 1, Phase::Flying, 1},
        Fault{FaultKind::Cont, 9, Phase::Planning, 1}, Fault{FaultKind::Restart, 3, Phase::Flying, 7},
        Fault{FaultKind::Kill, kWorldId, Phase::Planning, 25},
        Fault{FaultKind::Kill, 256, Phase::Flying, 4294967295U}}) {
    const ParsedFault parsed = parse_fault(text_of(fault));
    ASSERT_TRUE(parsed.fault.has_value()) << parsed.error;
    EXPECT_EQ(*parsed.fault, fault);
    EXPECT_TRUE(parsed.error.empty());
  }
  EXPECT_EQ(text_of({FaultKind::Kill, 3, Phase::Planning, 25}), "kill:3@plan:25");
  EXPECT_EQ(text_of({FaultKind::Stop, 2, Phase::Flying, 120}), "stop:2@fly:120");
  EXPECT_EQ(text_of({FaultKind::Cont, 2, Phase::Flying, 121}), "cont:2@fly:121");
  EXPECT_EQ(text_of({FaultKind::Restart, 2, Phase::Planning, 1}), "restart:2@plan:1");
  EXPECT_EQ(text_of({FaultKind::Kill, kWorldId, Phase::Flying, 120}), "kill:world@fly:120");
}

TEST(Faults, EachMistakeIsNamedInOneLine) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"", "not of the form KIND:ID@PHASE:NUMBER"},
      {"kill", "not of the form KIND:ID@PHASE:NUMBER"},
      {"kill:2", "not of the form KIND:ID@PHASE:NUMBER"},
      {"kill:2@plan", "not of the form KIND:ID@PHASE:NUMBER"},
      {"melt:2@plan:3", "unknown kind 'melt'"},
      {"kill:2@land:3", "unknown phase 'land'"},
      {"kill:0@plan:3", "'0' is no agent id"},
      {"kill:257@plan:3", "'257' is no agent id"},
      {"kill:-1@plan:3", "'-1' is no agent id"},
      {"kill:x@plan:3", "'x' is no agent id"},
      {"stop:world@plan:3", "'world' is no agent id"},
      {"kill:@plan:3", "'' is no agent id"},
      {"kill:2@plan:0", "'0' is no round or step"},
      {"kill:2@fly:3x", "'3x' is no round or step"},
      {"kill:2@fly:4294967296", "'4294967296' is no round or step"},
      {"kill:2@fly:", "'' is no round or step"},
  };
  for (const auto& [text, what] : mistakes) {
    const ParsedFault parsed = parse_fault(text);
    EXPECT_FALSE(parsed.fault.has_value()) << text;
    EXPECT_EQ(parsed.error, std::string("--fault ") + text + ": " + what + kAllowed);
  }
}

}  // namespace
}  // namespace skein
