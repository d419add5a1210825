// What every verb of `skein` promises on its command line, one row a case: a new verb needs a row here.
//
// In arguments $GOOD is a valid scenario, $BROKEN one with a fault, $FILE a recording, $DAMAGED one with a changed
// byte, $OTHER one of another seed, $NONE a file that is not there, $TEXT a file that is neither, $OUT a folder to
// write to, $DOMAIN a DDS domain in which nobody is, $LIVE the swarm that runs in a row that needs one.
#pragma once

#include <string>
#include <vector>

namespace skein::e2e {

/// How a verb prints with --json.
enum class Prints : std::uint8_t {
  Document,  ///< one JSON document
  Lines,     ///< a JSON document a line
  Screen,    ///< a full terminal: it has no --json
};

enum class Needs : std::uint8_t {
  Nothing,
  Swarm,  ///< one in flight
  Start,  ///< one that waits for its start
};

struct VerbRow {
  std::string verb;
  Prints prints = Prints::Document;
  std::vector<std::string> arguments;  ///< with which it succeeds soon; --json is added
  Needs needs = Needs::Nothing;
};

/// What standard error holds.
enum class Says : std::uint8_t {
  OneLine,
  More,  ///< progress as well
};

struct FailureRow {
  std::vector<std::string> arguments;
  int exit_code = 2;
  std::string text;  ///< standard error holds it; empty: not looked at
  Says says = Says::OneLine;
};

[[nodiscard]] const std::vector<VerbRow>& verb_rows();
[[nodiscard]] const std::vector<FailureRow>& failure_rows();

}  // namespace skein::e2e
