#include "tests/groundstation/e2e/program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace skein::e2e {
namespace {

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> raw;
  for (const std::string& text : texts) raw.push_back(const_cast<char*>(text.c_str()));
  raw.push_back(nullptr);
  return raw;
}

/// Reads what is there. @return whether the pipe is still open
bool drain(int& descriptor, std::string& into) {
  std::array<char, 4096> buffer{};
  const ssize_t size = read(descriptor, buffer.data(), buffer.size());
  if (size > 0) into.append(buffer.data(), static_cast<std::size_t>(size));
  if (size == 0) {
    close(descriptor);
    descriptor = -1;
  }
  return descriptor >= 0;
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
  std::array<int, 2> out{};
  std::array<int, 2> err{};
  if (pipe2(out.data(), O_CLOEXEC) != 0 || pipe2(err.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe");
  std::vector<std::string> all = environment;
  for (char** entry = environ; *entry != nullptr; ++entry) all.emplace_back(*entry);
  const std::vector<char*> argv = pointers(arguments);
  const std::vector<char*> envp = pointers(all);
  pid_ = fork();
  if (pid_ == 0) {
    setpgid(0, 0);
    dup2(out[1], STDOUT_FILENO);
    dup2(err[1], STDERR_FILENO);
    execve(argv[0], argv.data(), envp.data());
    _exit(127);
  }
  setpgid(pid_, pid_);
  close(out[1]);
  close(err[1]);
  out_ = out[0];
  err_ = err[0];
}

Program::~Program() {
  if (!reaped_) {
    kill(-pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  for (const int descriptor : {out_, err_}) {
    if (descriptor >= 0) close(descriptor);
  }
}

bool Program::read_some(double seconds) {
  std::array<pollfd, 2> set{{{out_, POLLIN, 0}, {err_, POLLIN, 0}}};
  const int ready = poll(set.data(), set.size(), std::max(0, static_cast<int>(seconds * 1000.0)));
  if (ready <= 0) return false;
  if (set[0].revents != 0) drain(out_, ended_.out);
  if (set[1].revents != 0) drain(err_, ended_.err);
  return true;
}

bool Program::read_until(const std::string& text, double seconds) {
  const double until_s = now_s() + seconds;
  const auto found = [&] { return !text.empty() && ended_.err.find(text) != std::string::npos; };
  while (!found() && now_s() < until_s && (out_ >= 0 || err_ >= 0)) read_some(until_s - now_s());
  return found();
}

void Program::signal_group(int number) const {
  kill(-pid_, number);
}

Ended Program::wait(double seconds) {
  const double until_s = now_s() + seconds;
  while ((out_ >= 0 || err_ >= 0) && now_s() < until_s) read_some(until_s - now_s());
  if (out_ >= 0 || err_ >= 0) kill(-pid_, SIGKILL);
  int status = 0;
  waitpid(pid_, &status, 0);
  reaped_ = true;
  ended_.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return ended_;
}

Ended run_program(const std::vector<std::string>& arguments, double seconds,
                  const std::vector<std::string>& environment) {
  return Program(arguments, environment).wait(seconds);
}

std::vector<pid_t> processes_with(const std::string& text) {
  std::vector<pid_t> pids;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file(entry.path() / "cmdline", std::ios::binary);
    const std::string line{std::istreambuf_iterator<char>(file), {}};
    if (line.find(text) != std::string::npos) pids.push_back(static_cast<pid_t>(std::stol(name)));
  }
  return pids;
}

bool gone_within(const std::string& text, double seconds) {
  const double until_s = now_s() + seconds;
  while (!processes_with(text).empty()) {
    if (now_s() > until_s) return false;
    poll(nullptr, 0, 10);
  }
  return true;
}

std::set<std::string> shared_memory_files() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/shm")) names.insert(entry.path().filename());
  return names;
}

ScratchFolder::ScratchFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / ("skein-e2e-" + std::string(6, 'X'))).string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("mkdtemp");
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace skein::e2e
