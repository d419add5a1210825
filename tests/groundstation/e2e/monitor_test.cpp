// Only whole processes can prove it: a second terminal shows a swarm that others started, at any size and with any
// terminal, leaves the terminal as it was, and the swarm does not notice.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <memory>
#include <regex>

#include "tests/groundstation/e2e/skein.hpp"
#include "tests/groundstation/e2e/tmux.hpp"

namespace skein::e2e {
namespace {

const std::string kDomain = "93";
constexpr double kLong_s = 60.0;  ///< for what must come, however busy the machine is

/// rendezvous-ring of twelve agents, on its way.
class Ring {
 public:
  Ring(const std::string& swarm, const std::string& realtime)
      : program_({binary("skein"), "run", scenario_path("rendezvous-ring"), "--agents", "12", "--realtime", realtime,
                  "--domain", kDomain, "--swarm", swarm, "--out", out_.path(), "--json"}) {}
  [[nodiscard]] bool plans() { return program_.read_until("planning:", kLong_s); }
  [[nodiscard]] bool flies() { return program_.read_until("flight:", kLong_s); }
  Program& program() { return program_; }

 private:
  ScratchFolder out_;
  Program program_;
};

std::string monitor(const std::string& swarm, const std::string& more = "") {
  return binary("skein") + " monitor --domain " + kDomain + " --swarm " + swarm + " " + more;
}

/// Says afterwards how it ended, and whether the terminal's settings are those from before.
std::string and_after(const std::string& command) {
  return "before=$(stty -g); " + command + "; code=$?; [ \"$before\" = \"$(stty -g)\" ] && echo left-clean-$code; cat";
}

/// Whether each of twelve agents has its row, heard.
bool has_twelve(const std::string& screen) {
  for (int id = 1; id <= 12; ++id) {
    const std::string number = (id < 10 ? "  " : " ") + std::to_string(id);
    const bool found = screen.find(number + " planning") != std::string::npos ||
                       screen.find(number + " ready") != std::string::npos ||
                       screen.find(number + " flying") != std::string::npos;
    if (!found) return false;
  }
  return true;
}

unsigned long step_of(const std::string& screen) {
  const std::size_t place = screen.find("  step ");
  return place == std::string::npos ? 0 : std::stoul(screen.substr(place + 7));
}

bool is_left_as_it_was(const Tmux& terminal) {
  return terminal.ask("#{cursor_flag} #{alternate_on} #{keypad_flag}") == "1 0 0";
}

TEST(Monitor, ShowsAllTwelveWithinThreeSecondsAndObeysItsKeys) {
  Ring ring("monitor-ring", "1");
  ASSERT_TRUE(ring.plans());
  const Tmux terminal(80, 24, and_after(monitor("monitor-ring")), {"LC_ALL=C.UTF-8"});
  EXPECT_TRUE(terminal.shows(has_twelve, 3.0)) << terminal.screen();
  EXPECT_TRUE(terminal.shows("q leave", kLong_s));
  EXPECT_TRUE(terminal.shows(">  1 ", kLong_s));
  terminal.keys({"n"});
  EXPECT_TRUE(terminal.shows(">  2 ", kLong_s)) << terminal.screen();
  EXPECT_TRUE(terminal.shows("agent 2: cost", kLong_s)) << terminal.screen();
  terminal.keys({"v"});
  EXPECT_TRUE(terminal.shows("x-z", kLong_s)) << terminal.screen();
  terminal.keys({"1", "f"});
  EXPECT_TRUE(terminal.shows("following", kLong_s)) << terminal.screen();
  terminal.keys({"Up"});
  EXPECT_TRUE(terminal.shows([](const auto& s) { return s.find("following") == std::string::npos; }, kLong_s));
  const auto wide = [](const std::string& s) { return s.substr(s.find("x-y"), 16); };
  const std::string before = wide(terminal.screen());
  terminal.keys({"+"});
  EXPECT_TRUE(terminal.shows([&](const auto& s) { return wide(s) != before; }, kLong_s)) << terminal.screen();
  terminal.keys({"?"});
  EXPECT_TRUE(terminal.shows("table of all figures", kLong_s)) << terminal.screen();
  terminal.keys({"?", "t"});
  EXPECT_TRUE(terminal.shows(" late", kLong_s)) << terminal.screen();
  terminal.keys({"q"});
  EXPECT_TRUE(terminal.shows("left-clean-0", kLong_s)) << terminal.screen();
  EXPECT_TRUE(is_left_as_it_was(terminal));
}

TEST(Monitor, FollowsTheWindowsSize) {
  Ring ring("monitor-size", "1");
  ASSERT_TRUE(ring.plans());
  const Tmux terminal(80, 24, and_after(monitor("monitor-size")), {"LC_ALL=C.UTF-8"});
  ASSERT_TRUE(terminal.shows(has_twelve, kLong_s)) << terminal.screen();
  terminal.resize(160, 50);
  EXPECT_TRUE(terminal.shows(" late", kLong_s)) << terminal.screen();
  terminal.resize(30, 8);
  EXPECT_TRUE(terminal.shows("at least 40 x 12", kLong_s)) << terminal.screen();
  terminal.resize(80, 24);
  EXPECT_TRUE(
      terminal.shows([](const auto& s) { return has_twelve(s) && s.find(" late") == std::string::npos; }, kLong_s))
      << terminal.screen();
  terminal.keys({"q"});
  EXPECT_TRUE(terminal.shows("left-clean-0", kLong_s)) << terminal.screen();
}

TEST(Monitor, RefusesATerminalOnWhichItCannotDraw) {
  Ring ring("monitor-dumb", "1");
  ASSERT_TRUE(ring.plans());
  const Tmux dumb(80, 24, and_after("TERM=dumb " + monitor("monitor-dumb")));
  EXPECT_TRUE(dumb.shows("left-clean-2", kLong_s)) << dumb.screen();
  EXPECT_TRUE(dumb.shows("terminal of type 'dumb'", kLong_s)) << dumb.screen();
}

TEST(Monitor, NeedsNeitherColourNorBraille) {
  Ring ring("monitor-plain", "1");
  ASSERT_TRUE(ring.plans());
  const Tmux plain(80, 24, "TERM=vt100 " + monitor("monitor-plain"), {"LC_ALL=C", "NO_COLOR=1"});
  const Tmux colourless(80, 24, monitor("monitor-plain"), {"LC_ALL=C.UTF-8", "NO_COLOR=1"});
  const Tmux coloured(80, 24, monitor("monitor-plain"), {"LC_ALL=C.UTF-8", "NO_COLOR="});
  for (const Tmux* terminal : {&plain, &colourless, &coloured}) {
    ASSERT_TRUE(terminal->shows(has_twelve, kLong_s)) << terminal->screen();
  }
  const std::string ascii = plain.screen();
  EXPECT_TRUE(std::ranges::all_of(ascii, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); })) << ascii;
  const auto has_colour = [](const Tmux& terminal) {
    return std::regex_search(terminal.screen(true), std::regex("\x1b\\[([0-9;]*;)?3[1-6]m"));
  };
  EXPECT_FALSE(has_colour(plain)) << plain.screen(true);
  EXPECT_FALSE(has_colour(colourless)) << colourless.screen(true);
  EXPECT_TRUE(has_colour(coloured)) << coloured.screen(true);
}

TEST(Monitor, LeavesTheTerminalCleanHoweverItEnds) {
  auto ring = std::make_unique<Ring>("monitor-end", "1");
  ASSERT_TRUE(ring->plans());
  const std::string command = monitor("monitor-end");
  const Tmux stopped(80, 24, and_after(command), {"LC_ALL=C.UTF-8"});
  const Tmux closed(80, 24, "exec " + command, {"LC_ALL=C.UTF-8"});
  const Tmux over(80, 24, and_after(command), {"LC_ALL=C.UTF-8"});
  for (const Tmux* terminal : {&stopped, &closed, &over}) {
    ASSERT_TRUE(terminal->shows(has_twelve, kLong_s)) << terminal->screen();
  }
  stopped.keys({"C-c"});
  EXPECT_TRUE(stopped.shows("ended by SIGINT", kLong_s)) << stopped.screen();
  EXPECT_TRUE(is_left_as_it_was(stopped));
  ASSERT_EQ(kill(closed.pid(), SIGHUP), 0);
  EXPECT_TRUE(closed.shows("ended by SIGHUP", kLong_s)) << closed.screen();
  EXPECT_TRUE(is_left_as_it_was(closed));
  ring->program().signal_group(SIGTERM);
  EXPECT_TRUE(over.shows("left-clean-143", kLong_s)) << over.screen();
  EXPECT_TRUE(over.shows("skein monitor: ended by SIGTERM", kLong_s)) << over.screen();
  EXPECT_TRUE(is_left_as_it_was(over));
}

TEST(Monitor, WithoutASwarmOrATerminalItSaysSoInOneLine) {
  const Tmux nobody(80, 24, and_after(monitor("monitor-nobody", "--startup-timeout 0.5")));
  EXPECT_TRUE(nobody.shows("no world of swarm monitor-nobody in domain 93 within 0.5 s", kLong_s)) << nobody.screen();
  EXPECT_TRUE(nobody.shows("left-clean-3", kLong_s)) << nobody.screen();
  const Ended piped = run_program({binary("skein"), "monitor", "--domain", kDomain}, 30.0);
  EXPECT_EQ(piped.exit_code, 2) << piped.err;
  EXPECT_NE(piped.err.find("no terminal; `skein status --watch` needs none"), std::string::npos) << piped.err;
}

// A monitor that is stopped reads nothing: what is sent to it is lost, and nobody waits.
TEST(Monitor, AttachingStoppingAndLeavingTenTimesChangesNoBit) {
  const ScratchFolder out;
  const SkeinRun alone =
      skein_run(scenario_path("rendezvous-ring"), 103, out.path(), {"--agents", "12", "--in-process"});
  ASSERT_TRUE(alone.report.is_object()) << alone.ended.err;
  Ring ring("monitor-hash", "6");
  ASSERT_TRUE(ring.plans());
  std::unique_ptr<Tmux> before;
  for (int i = 0; i < 10; ++i) {
    auto now =
        std::make_unique<Tmux>(80, 24, "exec " + monitor("monitor-hash"), std::vector<std::string>{"LC_ALL=C.UTF-8"});
    ASSERT_TRUE(now->shows(has_twelve, kLong_s)) << i << "\n" << now->screen();
    const unsigned long step = step_of(now->screen());
    const auto went_on = [&](const std::string& screen) { return step_of(screen) > step + 5; };
    EXPECT_TRUE(now->shows(went_on, kLong_s)) << i << "\n" << now->screen();
    if (before && i % 2 == 0) {
      ASSERT_EQ(kill(before->pid(), SIGCONT), 0);
      before->keys({"q"});
      EXPECT_TRUE(before->shows([&](const auto&) { return before->ask("#{pane_dead}") == "1"; }, kLong_s));
    }
    before = std::move(now);  // the one before that still is stopped ends with its terminal
    ASSERT_EQ(kill(before->pid(), SIGSTOP), 0);
  }
  before.reset();
  const Ended ended = ring.program().wait(180.0);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const auto report = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << ended.err;
  EXPECT_EQ(report.at("state_hash"), alone.report.at("state_hash"));
  EXPECT_TRUE(report.at("roster_changes").empty());
}

}  // namespace
}  // namespace skein::e2e
