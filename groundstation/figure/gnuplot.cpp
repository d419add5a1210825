#include "groundstation/figure/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace skein::figure {
namespace {

constexpr int kNotFound = 127;

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(fmt::format("{}: {}", what, std::generic_category().message(errno)));
}

/// A file in memory.
class Stream {
 public:
  Stream() : descriptor_(memfd_create("skein-figure", MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail("memfd_create");
  }
  ~Stream() { close(descriptor_); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  void fill(const std::string& text) const {
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t written = write(descriptor_, text.data() + done, text.size() - done);
      if (written < 0) fail("write");
      done += static_cast<std::size_t>(written);
    }
    if (lseek(descriptor_, 0, SEEK_SET) < 0) fail("lseek");
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    std::array<char, 1 << 16> part{};
    ssize_t size = 0;
    while ((size = pread(descriptor_, part.data(), part.size(), static_cast<off_t>(text.size()))) > 0) {
      text.append(part.data(), static_cast<std::size_t>(size));
    }
    return text;
  }

 private:
  int descriptor_;
};

[[noreturn]] void become(const std::string& program, const std::array<const Stream*, 3>& streams, pid_t parent) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kNotFound + 1);
  for (int i = 0; i < 3; ++i) {
    if (dup2(streams[static_cast<std::size_t>(i)]->descriptor(), i) < 0) _exit(kNotFound + 1);
  }
  execlp(program.c_str(), program.c_str(), "-d", static_cast<char*>(nullptr));
  _exit(errno == ENOENT || errno == EACCES ? kNotFound : kNotFound + 1);
}

/// Whether it ends in time; else it is killed.
bool ends_within(pid_t child, double deadline_s) {
  const int handle = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
  if (handle < 0) fail("pidfd_open");
  pollfd wanted{handle, POLLIN, 0};
  int ready = -1;
  do {
    ready = poll(&wanted, 1, static_cast<int>(deadline_s * 1e3));
  } while (ready < 0 && errno == EINTR);
  close(handle);
  if (ready <= 0) kill(child, SIGKILL);
  return ready > 0;
}

std::string first_line(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t\r\n^");
  if (from == std::string::npos) return "it says nothing";
  return text.substr(from, text.find('\n', from) - from);
}

}  // namespace

std::string draw(const std::string& script, double deadline_s, const std::string& program) {
  const Stream in;
  const Stream out;
  const Stream err;
  in.fill(script);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) fail("fork");
  if (child == 0) become(program, {&in, &out, &err}, parent);
  const bool in_time = ends_within(child, deadline_s);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!in_time) throw std::runtime_error(fmt::format("{} did not end within {} s", program, deadline_s));
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotFound) {
    throw NoGnuplot(fmt::format("{} is not there: install Debian's package gnuplot-nox", program));
  }
  std::string picture = out.text();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || picture.empty()) {
    throw std::runtime_error(fmt::format("{} failed: {}", program, first_line(err.text())));
  }
  return picture;
}

}  // namespace skein::figure
