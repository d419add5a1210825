// A bounded queue between the threads of DDS and the one thread that owns a port, with an eventfd to wait on.
//
// Listeners put and never block; the owner polls wake_fd() and drains. When the queue is full its oldest sample goes
// and is counted: the lockstep protocol asks again for what it lacks.
//
// The owner's own thread need not be woken if the thread that delivers can serve in its place (Delivery): that saves a
// change of threads a round. A wake-up costs more than a sample, and an owner that waits for n samples can do nothing
// with fewer. So it may say how many counted samples it waits for (wake_after), and is woken once: of N agents' round,
// by N wake-ups instead of N^2.
#pragma once

#include <sys/eventfd.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <functional>
#include <iterator>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

namespace skein::bus {

/// Called by the thread of DDS that brought what the owner of a port waits for; false: the owner is to be woken.
using Delivery = std::function<bool()>;

/// An eventfd, closed with its owner.
class Wake {
 public:
  explicit Wake(Delivery delivery = {})
      : delivery_(std::move(delivery)), fd_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (fd_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  }
  ~Wake() { ::close(fd_); }
  Wake(const Wake&) = delete;
  Wake& operator=(const Wake&) = delete;

  [[nodiscard]] int fd() const { return fd_; }
  /// Makes the descriptor readable. Its counter cannot fill up between two clear(), so the result needs no look.
  void ring() const { [[maybe_unused]] const auto written = ::eventfd_write(fd_, 1); }
  /// What was awaited is here: serves it in this thread, or wakes the owner.
  void deliver() const {
    if (!delivery_ || !delivery_()) ring();
  }
  void clear() const {
    eventfd_t count = 0;
    [[maybe_unused]] const auto read = ::eventfd_read(fd_, &count);
  }

 private:
  const Delivery delivery_;
  int fd_;
};

/// Whether a sample wakes the owner.
enum class Ring : std::uint8_t {
  Now,      ///< at once
  Counted,  ///< when as many have come as the owner waits for
  Silent,   ///< when the owner waits for nothing in particular
};

template <typename Sample>
class Inbox {
 public:
  Inbox(std::size_t bound, const Wake& wake) : bound_(bound), wake_(wake) {}

  template <typename Part>
  void put(Part&& sample, Ring ring = Ring::Now) {
    bool wakes = ring == Ring::Now;
    {
      const std::lock_guard lock(mutex_);
      if (queue_.size() == bound_) {
        queue_.erase(queue_.begin());
        lost_.fetch_add(1, std::memory_order_relaxed);
      }
      queue_.emplace_back(std::forward<Part>(sample));
      if (ring == Ring::Counted) ++counted_;
      wakes = wakes || counted_ >= wake_after_;
    }
    if (wakes) wake_.deliver();
  }

  /// From now on `count` counted samples wake the owner, those included that came since the last drain; 0: any sample
  /// does.
  void wake_after(std::size_t count) {
    const std::lock_guard lock(mutex_);
    if (count < wake_after_ && !queue_.empty() && counted_ >= count) wake_.ring();
    wake_after_ = count;
  }

  /// Moves everything to the end of `into` and makes the wake descriptor unreadable.
  void drain(std::vector<Sample>& into) {
    wake_.clear();
    const std::lock_guard lock(mutex_);
    if (into.empty()) {
      into.swap(queue_);  // both keep their memory from round to round
    } else {
      into.insert(into.end(), std::make_move_iterator(queue_.begin()), std::make_move_iterator(queue_.end()));
      queue_.clear();
    }
    counted_ = 0;
  }

  [[nodiscard]] std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }

 private:
  const std::size_t bound_;
  const Wake& wake_;
  std::mutex mutex_;
  std::vector<Sample> queue_;
  std::size_t counted_ = 0;  ///< in the queue
  std::size_t wake_after_ = 0;
  std::atomic<std::uint64_t> lost_{0};
};

}  // namespace skein::bus
