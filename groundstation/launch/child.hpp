// A child process of the launcher, which dies with it.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace skein {

class Child {
 public:
  /// Starts `program` with `arguments`; its output goes to the file `log`. The child leads its own process group, so
  /// that Ctrl-C reaches the launcher alone, and is killed when the launcher's thread ends.
  /// @param inherited descriptor that stays open in the child, or -1. @throws std::system_error
  Child(const std::string& program, const std::vector<std::string>& arguments, const std::string& log, int inherited);

  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Reaps the child if it has ended. @return its wait status, once it has
  std::optional<int> status();
  [[nodiscard]] bool running() { return !status().has_value(); }
  void signal(int number) const;
  /// Stops the child (SIGSTOP), and returns once it is stopped or has ended.
  void stop() const;
  [[nodiscard]] bool stopped() const;
  /// Returns once the child has ended.
  void wait();
  /// Kills the child, and returns once it has ended.
  void kill_and_reap();

 private:
  pid_t pid_;
  std::optional<int> status_;
};

/// "exit status 3" or "signal 9 (Killed)".
[[nodiscard]] std::string describe_status(int wait_status);

/// Proportional set size of a process in MB (/proc/PID/smaps_rollup), or nothing if it cannot be read.
[[nodiscard]] std::optional<double> pss_mb(pid_t pid);

}  // namespace skein
