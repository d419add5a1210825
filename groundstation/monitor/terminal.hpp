// The terminal: copies a grid to it and reads keys; leaves it as it was found, however the process ends.
//
// ncurses behind it, with what the terminal is known to be able to (TERM): without colours there are none, as with
// NO_COLOR. It takes no signal: the owner does, and calls resize(). Source: ncurses(3). Departs from source: none.
#pragma once

#include <optional>

#include "groundstation/monitor/controls.hpp"

namespace skein::monitor {

class Terminal {
 public:
  /// Takes the terminal over. One at a time. @throws std::runtime_error if it is none that can be drawn on
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  /// Whether the locale's characters are Unicode, so that Braille patterns can be shown.
  [[nodiscard]] Symbols symbols() const { return symbols_; }
  void show(const Grid& grid);
  /// The next key, or nothing; returns at once.
  [[nodiscard]] std::optional<Key> key();
  /// After a change of the window: its size is asked for again, and everything is drawn anew.
  void resize();

 private:
  Symbols symbols_;
  bool colour_ = false;
};

}  // namespace skein::monitor
