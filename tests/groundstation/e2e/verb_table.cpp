#include "tests/groundstation/e2e/verb_table.hpp"

namespace skein::e2e {

namespace {

/// Of the verbs that run, check and examine something here.
std::vector<FailureRow> job_rows() {
  return {
      {{}, 2, ""},
      {{"fly"}, 2, "fly"},

      {{"doctor", "--agents", "0"}, 2, "--agents"},
      {{"doctor", "--domain", "233"}, 2, "--domain"},

      {{"profile"}, 2, "DEPLOYMENT"},
      {{"profile", "moon"}, 2, "moon"},
      {{"profile", "discovery-server", "--server", "a b"}, 2, "--server"},
      {{"profile", "host", "-o", "$NONE/file"}, 2, "cannot write $NONE/file"},

      {{"run"}, 2, "SCENARIO"},
      {{"run", "$NONE"}, 2, "$NONE"},
      {{"run", "$BROKEN"}, 2, "$BROKEN:"},
      {{"run", "$GOOD", "--set", "planner.particles=1"}, 2, "planner.particles"},
      {{"run", "$GOOD", "--fault", "melt:2@plan:3"}, 2, "melt"},
      {{"run", "$GOOD", "--roster", "$NONE"}, 2, "--in-process"},
      {{"run", "$GOOD", "--in-process", "--roster", "$NONE", "--out", "$OUT/run"}, 2, "$NONE"},
      {{"run", "$GOOD", "--out", "/proc/nowhere"}, 2, "/proc/nowhere"},
      {{"run", "--attach", "--domain", "$DOMAIN", "--startup-timeout", "0.3"}, 3, "no swarm in domain"},
      {{"run", "$GOOD", "--in-process", "--out", "$OUT/run", "--set", "world.max_steps=3"}, 1, "", Says::More},
      {{"run", "$GOOD", "--domain", "$DOMAIN", "--out", "$OUT/run", "--fault", "kill:1@plan:3"}, 4, "", Says::More},

      {{"validate"}, 2, "SCENARIO"},
      {{"validate", "$NONE"}, 2, "$NONE"},
      {{"validate", "$BROKEN"}, 2, "$BROKEN:"},
      {{"validate", "$GOOD", "--set", "planner.particles"}, 2, "--set"},

      {{"version", "now"}, 2, "now"},
  };
}

/// Of those that run many of them.
std::vector<FailureRow> campaign_rows() {
  return {
      {{"chaos"}, 2, "SCENARIO"},
      {{"chaos", "$NONE"}, 2, "$NONE"},
      {{"chaos", "$BROKEN"}, 2, "$BROKEN:"},
      {{"chaos", "$GOOD", "--runs", "0"}, 2, "--runs"},
      {{"chaos", "$GOOD", "--faults", "$NONE"}, 2, "$NONE"},
      {{"chaos", "$GOOD", "--faults", "$TEXT"}, 2, "$TEXT"},
      {{"chaos", "$GOOD", "--runs", "1", "--junit", "$NONE/file"}, 2, "--junit: cannot write $NONE/file"},
      {{"chaos", "$GOOD", "--runs", "1", "--junit", "$OUT/x", "--resume", "$OUT/x"}, 2, "--junit: cannot write $OUT/x"},
      {{"chaos", "$GOOD", "--runs", "1", "--resume", "$TEXT"}, 2, "--resume: $TEXT: it is no journal of skein chaos"},
      {{"chaos", "$GOOD", "--runs", "1", "--out", "/proc/nowhere", "--domain", "$DOMAIN"}, 2, "/proc/nowhere"},

      {{"reproduce"}, 2, "WHAT"},
      {{"reproduce", "survey"}, 2, "survey"},
      {{"reproduce", "all", "--seeds", "0"}, 2, "--seeds"},
      {{"reproduce", "all", "-o", "$NONE/x.md"}, 2, "$NONE/x.md"},
      {{"reproduce", "all", "--resume", "$TEXT"}, 2, "--resume: $TEXT: it cannot be made"},

      {{"sweep"}, 2, "SCENARIO"},
      {{"sweep", "$NONE"}, 2, "$NONE"},
      {{"sweep", "$BROKEN"}, 2, "$BROKEN:"},
      {{"sweep", "$GOOD", "--runs", "0"}, 2, "--runs"},
      {{"sweep", "$GOOD", "--seed", "18446744073709551615", "--runs", "3"}, 2, "--seed"},
      {{"sweep", "$GOOD", "--runs", "1", "--junit", "$NONE/file"}, 2, "--junit: cannot write $NONE/file"},
      {{"sweep", "$TEXT", "--runs", "1", "--junit", "$TEXT"}, 2, "--junit: cannot write $TEXT: the same command reads"},
      {{"sweep", "$TEXT", "--runs", "1", "--report", "$TEXT"}, 2, "--report: cannot write $TEXT: the same command"},
      {{"sweep", "$GOOD", "--runs", "1", "--junit", "$OUT/x", "--report", "$OUT/x"}, 2, "--junit: cannot write $OUT/x"},
      {{"sweep", "$GOOD", "--runs", "1", "--resume", "$NONE/file"}, 2, "--resume: $NONE/file: it cannot be written"},
      {{"sweep", "$GOOD", "--runs", "1", "--resume", "$TEXT"}, 2, "--resume: $TEXT: it is no journal of skein sweep"},
      {{"sweep", "$GOOD", "--runs", "1", "--curves", "/dev/null/curves"}, 2, "--curves"},
      {{"sweep", "$GOOD", "--runs", "1", "--report", "$NONE/x.html"}, 2, "--report"},
      {{"sweep", "$GOOD", "--runs", "1", "--set", "world.max_steps=3", "--require-success", "1"}, 1, "success rate"},
  };
}

/// Of those that observe a swarm.
std::vector<FailureRow> observer_rows() {
  return {
      {{"monitor", "--domain", "$DOMAIN"}, 2, "terminal"},

      {{"record", "--domain", "$DOMAIN"}, 2, "--output"},
      {{"record", "-o", "$OUT/none.mcap", "--domain", "$DOMAIN", "--startup-timeout", "0.3"}, 3, "no swarm in domain"},
      {{"record", "-o", "$OUT/none.mcap", "--swarm", "nobody", "--domain", "$DOMAIN", "--startup-timeout", "0.3"},
       3,
       "no world of swarm nobody"},
      {{"record", "-o", "$NONE/file", "--swarm", "nobody", "--domain", "$DOMAIN"}, 2, "$NONE/file"},
      {{"record", "$GOOD", "-o", "$GOOD", "--swarm", "nobody", "--domain", "$DOMAIN"},
       2,
       "the same command reads or writes it"},
      {{"record", "$BROKEN", "-o", "$OUT/none.mcap", "--swarm", "nobody"}, 2, "$BROKEN:"},

      {{"status", "--domain", "$DOMAIN", "--startup-timeout", "0.3"}, 3, "no swarm in domain"},
      {{"status", "--swarm", "nobody", "--domain", "$DOMAIN", "--startup-timeout", "0.3"},
       3,
       "no world of swarm nobody"},
      {{"status", "--interval", "1"}, 2, "--watch"},

      {{"topics", "--domain", "$DOMAIN", "--startup-timeout", "0.3"}, 3, "no swarm in domain"},
      {{"topics", "--swarm", "nobody", "--domain", "$DOMAIN", "--startup-timeout", "0.3"},
       3,
       "no world of swarm nobody"},
  };
}

/// Of those that steer a swarm.
std::vector<FailureRow> steering_rows() {
  std::vector<FailureRow> rows{
      {{"goto"}, 2, "POINT"},
      {{"goto", "1", "2"}, 2, "POINT"},
      {{"goto", "1", "2", "3"}, 2, "--agent"},
      {{"goto", "1", "2", "3", "--agent", "1", "--speed", "-1"}, 2, "--speed"},
      {{"hold", "--agent", "0"}, 2, "--agent"},
      {{"hold", "--deadline", "0"}, 2, "--deadline"},
      {{"inject"}, 2, "WHAT"},
      {{"inject", "obstacle", "cube"}, 2, "cube"},
      {{"inject", "obstacle", "sphere", "--at", "1", "2", "3", "--radius", "0"}, 2, "--radius"},
      {{"kill"}, 2, "--agent"},
      {{"pause"}, 2, "--agent"},
      {{"restart"}, 2, "--agent"},
  };
  for (std::vector<std::string> words : std::vector<std::vector<std::string>>{{"start"},
                                                                              {"hold"},
                                                                              {"resume"},
                                                                              {"abort"},
                                                                              {"land"},
                                                                              {"goto", "1", "2", "3", "--agent", "1"},
                                                                              {"kill", "--agent", "1"}}) {
    words.insert(words.end(), {"--swarm", "nobody", "--domain", "$DOMAIN", "--startup-timeout", "0.3"});
    rows.push_back({words, 3, "no world of swarm nobody"});
  }
  return rows;
}

/// Of those that read and write recordings.
std::vector<FailureRow> file_rows() {
  return {
      {{"dump"}, 2, "FILE"},
      {{"dump", "$NONE"}, 2, "skein dump: $NONE: it cannot be read"},
      {{"dump", "$FILE", "--topic", "nonsense"}, 2, "there are: skein/beacon, skein/mission"},
      {{"dump", "$TEXT"}, 2, "$TEXT: byte 0: this is no MCAP file"},
      {{"dump", "$DAMAGED"}, 2, "a chunk"},

      {{"plot"}, 2, "FILE"},
      {{"plot", "$NONE"}, 2, "$NONE"},
      {{"plot", "$TEXT"}, 2, "$TEXT"},
      {{"plot", "$FILE", "--figure", "sunset"}, 2, "sunset"},
      {{"plot", "$FILE", "--figure", "paths", "-o", "$NONE/paths.svg"}, 2, "$NONE/paths.svg"},
      {{"plot", "$FILE", "--figure", "paths", "-o", "$FILE"}, 2, "cannot write $FILE: the same command reads"},
      {{"plot", "$FILE", "--figure", "paths", "--format", "png", "-o", "$OUT/a.svg"}, 2, "--format png contradicts"},

      {{"report"}, 2, "FILE"},
      {{"report", "$NONE"}, 2, "$NONE"},
      {{"report", "$TEXT"}, 2, "$TEXT"},
      {{"report", "$FILE", "-o", "$NONE/x.html"}, 2, "$NONE/x.html"},
      {{"report", "$FILE", "-o", "$FILE"}, 2, "cannot write $FILE: the same command reads"},

      {{"replay"}, 2, "FILE"},
      {{"replay", "$NONE"}, 2, "$NONE"},
      {{"replay", "$TEXT"}, 2, "$TEXT: byte 0: this is no MCAP file"},
      {{"replay", "$DAMAGED"}, 2, "a chunk"},
      {{"replay", "$FILE", "--rate", "-1"}, 2, "--rate"},
      {{"replay", "$FILE", "--from", "1e6"}, 2, "it ends at"},
      {{"replay", "$FILE", "--wait", "1", "--startup-timeout", "0.3", "--domain", "$DOMAIN"}, 3, "0 of 1 observers"},

      {{"run", "$GOOD", "--record", "/dev/full", "--out", "$OUT/run"}, 2, "/dev/full"},
      {{"run", "$GOOD", "--record", "", "--out", "$OUT/run"}, 2, "--record: it names no file"},
      {{"run", "$TEXT", "--record", "$TEXT", "--out", "$OUT/run"}, 2, "cannot write $TEXT: the same command reads"},
      {{"run", "$GOOD", "--in-process", "--record", "$GOOD", "--out", "$OUT/run"}, 2, "the same command reads"},

      {{"verify"}, 2, "A"},
      {{"verify", "$FILE"}, 2, "--rerun"},
      {{"verify", "$FILE", "$NONE"}, 2, "$NONE"},
      {{"verify", "$FILE", "$TEXT"}, 2, "$TEXT: byte 0: this is no MCAP file"},
      {{"verify", "$DAMAGED", "$FILE"}, 2, "$DAMAGED: byte"},
      {{"verify", "$FILE", "$FILE", "--rerun"}, 2, "--rerun"},
  };
}

/// Each option that is a number with a fraction, with values that none may have.
std::vector<FailureRow> number_rows() {
  const std::vector<std::string> replay{"replay", "$FILE"};
  const std::vector<std::string> sphere{"inject", "obstacle", "sphere"};
  struct Option {
    std::vector<std::string> before;
    std::string name;
    std::vector<std::string> wrong;
    std::vector<std::string> after = {};
  };
  const std::vector<Option> options{
      {{"chaos", "$GOOD"}, "--limit", {"0.5", "4000"}},
      {{"run", "$GOOD"}, "--realtime", {"0", "1e9"}},
      {{"run", "$GOOD"}, "--startup-timeout", {"0"}},
      {replay, "--rate", {"-1", "1e7"}},
      {replay, "--from", {"-1", "1e300"}},
      {{"status", "--watch"}, "--interval", {"0"}},
      {{"topics", "--watch"}, "--interval", {"0"}},
      {{"monitor"}, "--startup-timeout", {"0"}},
      {{"sweep", "$GOOD"}, "--require-success", {"1.1", "-0.1"}},
      {{"hold"}, "--deadline", {"0"}},
      {{"goto", "1", "2", "3", "--agent", "1"}, "--speed", {"0", "1e5"}},
      {{"goto"}, "POINT", {"1e9", "-1e300"}, {"1", "1", "--agent", "1"}},
      {sphere, "--at", {"1e9", "-1e300"}, {"1", "1", "--radius", "1"}},
      {sphere, "--velocity", {"1e5"}, {"0", "0", "--at", "1", "1", "1", "--radius", "1"}},
      {sphere, "--radius", {"0", "-1", "1e305"}, {"--at", "1", "1", "1"}},
  };
  std::vector<FailureRow> rows;
  for (const Option& option : options) {
    std::vector<std::string> wrong = option.wrong;
    wrong.insert(wrong.end(), {"nan", "inf", "-inf", "1e999"});
    for (const std::string& value : wrong) {
      std::vector<std::string> words = option.before;
      if (option.name.starts_with("-")) words.push_back(option.name);
      words.push_back(value);
      words.insert(words.end(), option.after.begin(), option.after.end());
      rows.push_back({words, 2, option.name});
    }
  }
  return rows;
}

/// What is said is short, and what is given UTF-8.
std::vector<FailureRow> text_rows() {
  return {
      {{"validate", "x/\xff\xfe.yaml"}, 2, "argument 2 is not UTF-8: x/??.yaml"},
      {{"sweep", "x\xff.yaml", "--json"}, 2, "argument 2 is not UTF-8"},
      {{"run", "$GOOD", "--in-process", "--out", "$OUT/\xc3"}, 2, "argument 5 is not UTF-8"},
      {{"report", "\xff", "--json"}, 2, "argument 2 is not UTF-8"},
      {{"hold", "--swarm", std::string(3000, 'x')}, 2, "--swarm"},
      {{"hold", "--swarm", "two\nlines"}, 2, "--swarm: 'two?lines'"},
  };
}

}  // namespace

const std::vector<VerbRow>& verb_rows() {
  static const std::vector<std::string> kLive{"--swarm", "$LIVE", "--domain", "$DOMAIN", "--deadline", "60"};
  static const auto on_live = [](std::vector<std::string> words) {
    words.insert(words.end(), kLive.begin(), kLive.end());
    return words;
  };
  static const std::vector<VerbRow> kRows{
      {"abort", Prints::Document, on_live({}), Needs::Swarm},
      {"chaos", Prints::Document, {"$GOOD", "--runs", "1", "--out", "$OUT/chaos", "--domain", "$DOMAIN"}},
      {"doctor", Prints::Document, {"--agents", "1", "--domain", "$DOMAIN"}},
      {"dump", Prints::Lines, {"$FILE", "--topic", "skein/tick"}},
      {"goto", Prints::Document, on_live({"10", "20", "30", "--agent", "1"}), Needs::Swarm},
      {"hold", Prints::Document, on_live({}), Needs::Swarm},
      {"inject", Prints::Document, on_live({"obstacle", "sphere", "--at", "1e6", "1e6", "0", "--radius", "5"}),
       Needs::Swarm},
      {"kill", Prints::Document, on_live({"--agent", "1"}), Needs::Swarm},
      {"land", Prints::Document, on_live({"--agent", "1"}), Needs::Swarm},
      {"monitor", Prints::Screen, {}},
      {"pause", Prints::Document, on_live({"--agent", "1"}), Needs::Swarm},
      {"plot", Prints::Document, {"$FILE", "-o", "$OUT/plots"}},
      {"profile", Prints::Document, {"host"}},
      {"record", Prints::Document, {"--swarm", "$LIVE", "--domain", "$DOMAIN", "-o", "$OUT/r.mcap"}, Needs::Swarm},
      {"replay", Prints::Document, {"$FILE", "--rate", "0", "--domain", "$DOMAIN"}},
      {"report", Prints::Document, {"$FILE", "-o", "$OUT/page.html"}},
      {"reproduce", Prints::Document, {"rendezvous", "--quick", "--seeds", "1"}},
      {"restart", Prints::Document, on_live({"--agent", "1"}), Needs::Swarm},
      {"resume", Prints::Document, on_live({}), Needs::Swarm},
      {"run", Prints::Document, {"$GOOD", "--in-process", "--out", "$OUT/run"}},
      {"start", Prints::Document, on_live({}), Needs::Start},
      {"status", Prints::Document, {"--swarm", "$LIVE", "--domain", "$DOMAIN"}, Needs::Swarm},
      {"sweep", Prints::Document, {"$GOOD", "--runs", "2"}},
      {"topics", Prints::Document, {"--swarm", "$LIVE", "--domain", "$DOMAIN"}, Needs::Swarm},
      {"validate", Prints::Document, {"$GOOD"}},
      {"verify", Prints::Document, {"$FILE", "--rerun"}},
      {"version", Prints::Document, {}},
  };
  return kRows;
}

const std::vector<FailureRow>& failure_rows() {
  static const std::vector<FailureRow> kRows = [] {
    std::vector<FailureRow> all;
    for (const auto& rows :
         {job_rows(), campaign_rows(), observer_rows(), steering_rows(), file_rows(), number_rows(), text_rows()})
      all.insert(all.end(), rows.begin(), rows.end());
    return all;
  }();
  return kRows;
}

}  // namespace skein::e2e
