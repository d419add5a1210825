// Signals as events of a poll loop: no handler runs, nothing is interrupted.
//
// The watched signals are blocked for the process and read from a descriptor. Construct it before any thread is started
// (a DDS port starts some), so that all threads inherit the mask. Source: signalfd(2).
#pragma once

#include <initializer_list>
#include <optional>

namespace skein {

class SignalWatch {
 public:
  /// Blocks the signals and opens the descriptor. @throws std::system_error
  explicit SignalWatch(std::initializer_list<int> signals);
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// Readable when a watched signal has arrived.
  [[nodiscard]] int fd() const { return fd_; }
  /// The next signal that has arrived, or nothing; returns at once.
  [[nodiscard]] std::optional<int> take() const;

 private:
  int fd_;
};

}  // namespace skein
