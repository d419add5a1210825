// A bounded queue between the threads of DDS and the one thread that owns a port, with an eventfd to wait on.
//
// Listeners put and never block; the owner polls wake_fd() and drains. When the queue is full its oldest sample goes
// and is counted: the lockstep protocol asks again for what it lacks.
#pragma once

#include <sys/eventfd.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <deque>
#include <iterator>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

namespace skein::bus {

/// An eventfd, closed with its owner.
class Wake {
 public:
  Wake() : fd_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (fd_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  }
  ~Wake() { ::close(fd_); }
  Wake(const Wake&) = delete;
  Wake& operator=(const Wake&) = delete;

  [[nodiscard]] int fd() const { return fd_; }
  /// Makes the descriptor readable. Its counter cannot fill up between two clear(), so the result needs no look.
  void ring() const { [[maybe_unused]] const auto written = ::eventfd_write(fd_, 1); }
  void clear() const {
    eventfd_t count = 0;
    [[maybe_unused]] const auto read = ::eventfd_read(fd_, &count);
  }

 private:
  int fd_;
};

template <typename Sample>
class Inbox {
 public:
  Inbox(std::size_t bound, const Wake& wake) : bound_(bound), wake_(wake) {}

  template <typename Part>
  void put(Part&& sample) {
    {
      const std::lock_guard lock(mutex_);
      if (queue_.size() == bound_) {
        queue_.pop_front();
        lost_.fetch_add(1, std::memory_order_relaxed);
      }
      queue_.emplace_back(std::forward<Part>(sample));
    }
    wake_.ring();
  }

  /// Moves everything to the end of `into` and makes the wake descriptor unreadable.
  void drain(std::vector<Sample>& into) {
    wake_.clear();
    const std::lock_guard lock(mutex_);
    into.insert(into.end(), std::make_move_iterator(queue_.begin()), std::make_move_iterator(queue_.end()));
    queue_.clear();
  }

  [[nodiscard]] std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }

 private:
  const std::size_t bound_;
  const Wake& wake_;
  std::mutex mutex_;
  std::deque<Sample> queue_;
  std::atomic<std::uint64_t> lost_{0};
};

}  // namespace skein::bus
