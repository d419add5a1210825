#include "tests/groundstation/e2e/tmux.hpp"

#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>

#include "tests/groundstation/e2e/program.hpp"

namespace skein::e2e {
namespace {

constexpr int kPoll_ms = 20;

std::string new_server() {
  static int number = 0;
  return "skein-e2e-" + std::to_string(getpid()) + "-" + std::to_string(++number);
}

}  // namespace

Tmux::Tmux(int width, int height, const std::string& command, const std::vector<std::string>& environment)
    : server_(new_server()) {
  std::vector<std::string> words{
      "-u", "-f", "/dev/null", "new-session", "-d", "-x", std::to_string(width), "-y", std::to_string(height)};
  for (const std::string& entry : environment) words.insert(words.end(), {"-e", entry});
  words.push_back(command);
  words.insert(words.end(), {";", "set-option", "-g", "remain-on-exit", "on"});
  [[maybe_unused]] const std::string said = run(words);
}

Tmux::~Tmux() {
  try {
    [[maybe_unused]] const std::string said = run({"kill-server"});
  } catch (const std::exception&) {
    server_.clear();  // it ended by itself
  }
}

std::string Tmux::run(std::vector<std::string> words) const {
  words.insert(words.begin(), {"/usr/bin/tmux", "-L", server_});
  const Ended ended = run_program(words, 30.0);
  if (ended.exit_code != 0) throw std::runtime_error("tmux " + words[3] + ": " + ended.err);
  return ended.out;
}

void Tmux::keys(const std::vector<std::string>& names) const {
  std::vector<std::string> words{"send-keys"};
  words.insert(words.end(), names.begin(), names.end());
  [[maybe_unused]] const std::string said = run(words);
}

void Tmux::resize(int width, int height) const {
  [[maybe_unused]] const std::string said =
      run({"resize-window", "-x", std::to_string(width), "-y", std::to_string(height)});
}

std::string Tmux::screen(bool escapes) const {
  std::vector<std::string> words{"capture-pane", "-p"};
  if (escapes) words.emplace_back("-e");
  return run(words);
}

std::string Tmux::ask(const std::string& format) const {
  std::string answer = run({"display-message", "-p", format});
  if (!answer.empty() && answer.back() == '\n') answer.pop_back();
  return answer;
}

pid_t Tmux::pid() const {
  return static_cast<pid_t>(std::stol(ask("#{pane_pid}")));
}

bool Tmux::shows(const std::function<bool(const std::string&)>& what, double seconds) const {
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!what(screen())) {
    if (std::chrono::steady_clock::now() > until) return false;
    poll(nullptr, 0, kPoll_ms);
  }
  return true;
}

bool Tmux::shows(const std::string& text, double seconds) const {
  return shows([&](const std::string& screen) { return screen.find(text) != std::string::npos; }, seconds);
}

}  // namespace skein::e2e
