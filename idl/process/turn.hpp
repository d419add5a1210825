// Whose turn it is to serve what a process does: its own thread's, or that of the thread of DDS that brought the
// samples.
//
// A round over DDS hangs on the time from a sample's arrival to the answer. The thread that delivers the last sample
// serves it itself if the process's own thread is not at it (take), and is spared the change of threads; else the own
// thread is woken and serves. Both do the same thing under one lock, so that which of them did it cannot be told.
#pragma once

#include <exception>
#include <functional>
#include <mutex>
#include <utility>

namespace skein {

class Turn {
 public:
  /// For a thread of DDS: serves, if nobody else does. @return whether that was all; false: wake the own thread
  bool take() {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || !serve_ || failure_) return false;
    try {
      return serve_();
    } catch (...) {
      failure_ = std::current_exception();
      return false;
    }
  }
  /// For the process's own thread: nobody else serves while it holds this. @throws what a thread of DDS met
  [[nodiscard]] std::unique_lock<std::mutex> own() {
    std::unique_lock lock(mutex_);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return lock;
  }

  /// What threads of DDS do in their turn, while this object lives; it is made and destroyed by the own thread.
  class Service {
   public:
    /// @param serve returns whether the own thread has nothing to do meanwhile
    Service(Turn& turn, std::function<bool()> serve) : turn_(turn) {
      const std::lock_guard lock(turn_.mutex_);
      turn_.serve_ = std::move(serve);
    }
    ~Service() {
      const std::lock_guard lock(turn_.mutex_);
      turn_.serve_ = nullptr;
    }
    Service(const Service&) = delete;
    Service& operator=(const Service&) = delete;

   private:
    Turn& turn_;
  };

 private:
  std::mutex mutex_;
  std::function<bool()> serve_;
  std::exception_ptr failure_;
};

}  // namespace skein
