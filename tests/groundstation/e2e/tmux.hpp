// A terminal of a known size with one program in it, as tmux gives it: keys go in, the screen comes out.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace skein::e2e {

class Tmux {
 public:
  /// Starts `command` of the shell in a server and window of its own, which stay when it ends.
  /// @param environment NAME=VALUE, on top of this process's own
  Tmux(int width, int height, const std::string& command, const std::vector<std::string>& environment = {});
  /// Ends the server and all in it.
  ~Tmux();
  Tmux(const Tmux&) = delete;
  Tmux& operator=(const Tmux&) = delete;

  /// Key names of tmux: "q", "Up", "?".
  void keys(const std::vector<std::string>& names) const;
  void resize(int width, int height) const;
  /// What stands on the screen. @param escapes with the codes for colours and attributes
  [[nodiscard]] std::string screen(bool escapes = false) const;
  /// A format of tmux: "#{pane_pid}".
  [[nodiscard]] std::string ask(const std::string& format) const;
  [[nodiscard]] pid_t pid() const;
  /// Polls the screen. @return whether it came to hold what is asked for within `seconds`
  [[nodiscard]] bool shows(const std::function<bool(const std::string&)>& what, double seconds) const;
  [[nodiscard]] bool shows(const std::string& text, double seconds) const;

 private:
  [[nodiscard]] std::string run(std::vector<std::string> words) const;
  std::string server_;
};

}  // namespace skein::e2e
