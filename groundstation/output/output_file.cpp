#include "groundstation/output/output_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <utility>

namespace skein {
namespace {

namespace fs = std::filesystem;

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }
  /// @return whether all was written: some file systems say so late
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw std::runtime_error(fmt::format("cannot write {}: {}", path, why));
}

[[noreturn]] void refuse_for_errno(const std::string& path) {
  refuse(path, std::strerror(errno));
}

/// Whether it is replaced as a whole: what is under /dev and /proc stands for something else.
bool is_replaced(const std::string& path) {
  const bool stands_for_another = path.starts_with("/dev/") && !path.starts_with("/dev/shm/");
  if (stands_for_another || path.starts_with("/proc/")) return false;
  std::error_code ignored;
  return !fs::exists(path, ignored) || fs::is_regular_file(path, ignored);
}

/// Where a symbolic link leads.
fs::path target_of(const std::string& path) {
  std::error_code failed;
  fs::path target = fs::weakly_canonical(fs::absolute(path), failed);
  return failed ? fs::absolute(path) : target;
}

bool is_same(const std::string& path, const std::string& other) {
  if (other.empty()) return false;
  std::error_code failed;
  return target_of(path) == target_of(other) || fs::equivalent(path, other, failed);
}

/// A new file beside the target. @return its descriptor, -1 if there can be none (errno)
int open_beside(const fs::path& target, std::string& name) {
  for (unsigned number = 0;; ++number) {
    name = (target.parent_path() / fmt::format(".skein-{}-{}", ::getpid(), number)).string();
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
}

bool write_all(int fd, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t wrote = ::write(fd, bytes.data() + at, bytes.size() - at);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) return false;
    at += static_cast<std::size_t>(wrote);
  }
  return true;
}

bool is_standard_output(const std::string& path) {
  struct stat file {};
  struct stat out {};
  return ::stat(path.c_str(), &file) == 0 && ::fstat(STDOUT_FILENO, &out) == 0 && file.st_dev == out.st_dev &&
         file.st_ino == out.st_ino && !S_ISCHR(out.st_mode);
}

/// In place: a device, or a file in a folder that takes no other.
void write_into(const std::string& path, const std::string& bytes) {
  if (is_standard_output(path)) {  // opened again it would begin at its start, over what was printed
    if (std::cout << bytes << std::flush) return;
    refuse(path, "standard output does not take it");
  }
  Descriptor file(::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
  if (file.get() < 0 || !write_all(file.get(), bytes) || !file.close()) refuse_for_errno(path);
}

}  // namespace

void check_output(const std::string& path, const std::vector<std::string>& others) {
  std::error_code ignored;
  if (path.empty()) refuse("''", "a file needs a name");
  if (fs::is_directory(path, ignored)) refuse(path, "it is a folder");
  if (!is_replaced(path)) {
    if (::access(path.c_str(), W_OK) != 0) refuse_for_errno(path);
    return;
  }
  for (const std::string& other : others) {
    if (is_same(path, other)) refuse(path, fmt::format("the same command reads or writes it as {}", other));
  }
  const fs::path target = target_of(path);
  if (fs::exists(target, ignored)) {
    const Descriptor file(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.get() < 0) refuse_for_errno(path);
    return;
  }
  std::string name;
  const Descriptor file(open_beside(target, name));
  if (file.get() < 0) refuse_for_errno(path);
  ::unlink(name.c_str());
}

void write_output(const std::string& path, const std::string& bytes) {
  if (!is_replaced(path)) return write_into(path, bytes);
  const fs::path target = target_of(path);
  std::error_code failed;
  const fs::file_status before = fs::status(target, failed);
  const bool replaces = fs::exists(before);
  std::string name;
  Descriptor file(open_beside(target, name));
  if (file.get() < 0) {
    if (replaces && errno == EACCES) return write_into(path, bytes);
    refuse_for_errno(path);
  }
  if (replaces) fs::permissions(name, before.permissions(), failed);
  if (!write_all(file.get(), bytes) || !file.close() || ::rename(name.c_str(), target.c_str()) != 0) {
    const int fault = errno;
    ::unlink(name.c_str());
    refuse(path, std::strerror(fault));
  }
}

}  // namespace skein
