// A program under test as its user starts it: in a process group of its own, with its output read to the end.
#pragma once

#include <sys/types.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace skein::e2e {

struct Ended {
  int exit_code = -1;  ///< 128 + signal if a signal ended it
  std::string out;
  std::string err;
};

class Program {
 public:
  /// Starts `arguments[0]`. @param environment NAME=VALUE, on top of this process's own
  explicit Program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {});
  /// Kills the whole group if it still runs.
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Reads output until `seconds` have passed, standard error holds `text` (unless empty), or all output is closed.
  /// @return whether the text was found
  bool read_until(const std::string& text, double seconds);
  /// What a terminal does on Ctrl-C: the signal goes to the whole foreground group.
  void signal_group(int number) const;
  /// Reads to the end and reaps; kills the group after `seconds`.
  Ended wait(double seconds);

 private:
  bool read_some(double seconds);

  pid_t pid_ = -1;
  int out_ = -1;
  int err_ = -1;
  Ended ended_;
  bool reaped_ = false;
};

/// Runs to the end; a run over `seconds` is killed and gives exit code 137.
[[nodiscard]] Ended run_program(const std::vector<std::string>& arguments, double seconds,
                                const std::vector<std::string>& environment = {});

/// Pids of processes whose command line holds `text`, this one and its own children with `exclude` left out.
[[nodiscard]] std::vector<pid_t> processes_with(const std::string& text);

/// Polls until no process's command line holds `text`. @return whether that was so within `seconds`
[[nodiscard]] bool gone_within(const std::string& text, double seconds);

/// Names in /dev/shm.
[[nodiscard]] std::set<std::string> shared_memory_files();

/// A new, empty folder for one test's output, removed with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace skein::e2e
