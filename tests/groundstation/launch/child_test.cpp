// Child processes: how they end, what is said of it, and that they do not outlive who started them.
#include "groundstation/launch/child.hpp"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <iterator>

#include "idl/process/poll.hpp"
#include "simworld/control/control_channel.hpp"

namespace skein {
namespace {

constexpr double kPatience_s = 20.0;

std::string log_path() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return testing::TempDir() + "skein-child-" + std::to_string(getpid()) + "-" + test->name() + ".log";
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The status of a child that is about to end.
std::optional<int> status_of(Child& child) {
  const double until_s = steady_now_s() + kPatience_s;
  while (child.running() && steady_now_s() < until_s) wait_readable({}, 0.01);
  return child.status();
}

TEST(Child, OutputGoesToTheLogAndTheStatusIsKept) {
  const std::string log = log_path();
  Child child("/bin/sh", {"-c", "echo out; echo err >&2; exit 3"}, log, -1);
  const auto status = status_of(child);
  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(describe_status(*status), "exit status 3");
  EXPECT_EQ(child.status(), status);  // reaped once, known for ever
  EXPECT_EQ(text_of(log), "out\nerr\n");
  child.signal(SIGKILL);  // reaches nobody
  unlink(log.c_str());
}

TEST(Child, ASignalIsNamed) {
  const std::string log = log_path();
  Child child("/bin/sh", {"-c", "exec tail -f /dev/null"}, log, -1);
  EXPECT_TRUE(child.running());
  EXPECT_TRUE(pss_mb(child.pid()).has_value());
  child.signal(SIGKILL);
  const auto status = status_of(child);
  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(describe_status(*status), "signal 9 (Killed)");
  unlink(log.c_str());
}

TEST(Child, IsStoppedContinuedAndKilledEvenWhileStopped) {
  const std::string log = log_path();
  Child child("/bin/sh", {"-c", "exec tail -f /dev/null"}, log, -1);
  EXPECT_FALSE(child.stopped());
  child.stop();
  EXPECT_TRUE(child.stopped());
  EXPECT_TRUE(child.running());
  child.signal(SIGCONT);
  EXPECT_FALSE(child.stopped());
  child.stop();
  child.kill_and_reap();
  EXPECT_FALSE(child.stopped());
  ASSERT_TRUE(child.status().has_value());
  EXPECT_EQ(describe_status(*child.status()), "signal 9 (Killed)");
  child.kill_and_reap();  // nothing is left to be killed
  child.stop();
  unlink(log.c_str());
}

TEST(Child, AProgramThatIsNotThereEndsWith127) {
  const std::string log = log_path();
  Child child("/nowhere/at/all", {}, log, -1);
  const auto status = status_of(child);
  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(describe_status(*status), "exit status 127");
  unlink(log.c_str());
}

TEST(Child, ALogThatCannotBeWrittenThrows) {
  EXPECT_THROW(Child("/bin/true", {}, "/nowhere/at/all.log", -1), std::system_error);
}

TEST(Child, LeadsItsOwnProcessGroupWithoutStandardInput) {
  const std::string log = log_path();
  Child child("/bin/sh", {"-c", "cat; test \"$(cut -d' ' -f5 /proc/$$/stat)\" = $$"}, log, -1);
  EXPECT_EQ(status_of(child), std::optional(0));
  unlink(log.c_str());
}

TEST(Child, InheritsOneDescriptor) {
  const std::string log = log_path();
  auto [near, far] = ControlChannel::pair();
  Child child("/bin/sh", {"-c", "printf '{\"progress\": {}}' >&" + std::to_string(far.fd())}, log, far.fd());
  far.close();
  EXPECT_EQ(status_of(child), std::optional(0)) << text_of(log);
  const auto message = near.receive();
  ASSERT_TRUE(message.has_value());
  EXPECT_TRUE(message->contains("progress"));
  unlink(log.c_str());
}

TEST(Child, DiesWithItsLauncher) {
  const std::string log = log_path();
  std::array<int, 2> pipe_ends{};
  ASSERT_EQ(pipe(pipe_ends.data()), 0);
  ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);  // the orphan becomes ours, so that its end can be awaited
  const pid_t launcher = fork();
  ASSERT_GE(launcher, 0);
  if (launcher == 0) {
    const Child child("/bin/sh", {"-c", "trap '' TERM HUP INT; tail -f /dev/null"}, log, -1);
    const pid_t pid = child.pid();
    const bool told = write(pipe_ends[1], &pid, sizeof pid) == sizeof pid;
    _exit(told ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(launcher, &status, 0), launcher);
  EXPECT_EQ(status, 0);
  pid_t orphan = 0;
  ASSERT_EQ(read(pipe_ends[0], &orphan, sizeof orphan), static_cast<ssize_t>(sizeof orphan));
  const double until_s = steady_now_s() + kPatience_s;
  pid_t reaped = 0;
  while ((reaped = waitpid(orphan, &status, WNOHANG)) == 0 && steady_now_s() < until_s) wait_readable({}, 0.01);
  EXPECT_EQ(reaped, orphan);
  // killed, or not begun because the launcher was gone first
  EXPECT_TRUE(describe_status(status) == "signal 9 (Killed)" || describe_status(status) == "exit status 127");
  if (reaped == 0) kill(orphan, SIGKILL);
  for (const int end : pipe_ends) close(end);
  unlink(log.c_str());
}

}  // namespace
}  // namespace skein
