#include "groundstation/monitor/terminal.hpp"

#define NCURSES_NOMACROS 1
#define NCURSES_WIDECHAR 1
#include <curses.h>
#include <langinfo.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <clocale>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

namespace skein::monitor {
namespace {

constexpr std::array<short, 7> kColours{-1,         COLOR_RED,     COLOR_GREEN, COLOR_YELLOW,
                                        COLOR_BLUE, COLOR_MAGENTA, COLOR_CYAN};

attr_t attributes_of(const Style& style) {
  attr_t attributes = A_NORMAL;
  if (style.bold) attributes |= A_BOLD;
  if (style.dim) attributes |= A_DIM;
  if (style.reverse) attributes |= A_REVERSE;
  return attributes;
}

bool speaks_unicode() {
  std::setlocale(LC_CTYPE, "");
  return std::string_view(nl_langinfo(CODESET)) == "UTF-8";
}

bool wants_colour() {
  const char* no_colour = std::getenv("NO_COLOR");
  return no_colour == nullptr || *no_colour == '\0';
}

}  // namespace

Terminal::Terminal() : symbols_(speaks_unicode() ? Symbols::Braille : Symbols::Ascii) {
  if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) {
    throw std::runtime_error("standard input and output are no terminal; `skein status --watch` needs none");
  }
  const bool known = newterm(nullptr, stdout, stdin) != nullptr;
  if (!known || tigetstr("cup") == nullptr) {  // it cannot put the cursor anywhere
    if (known) endwin();
    const char* name = std::getenv("TERM");
    throw std::runtime_error(std::string("cannot draw on a terminal of type '") + (name == nullptr ? "" : name) + "'");
  }
  cbreak();
  noecho();
  nonl();
  keypad(stdscr, TRUE);
  nodelay(stdscr, TRUE);
  curs_set(0);
  set_escdelay(25);
  colour_ = wants_colour() && has_colors();
  if (!colour_) return;
  start_color();
  use_default_colors();
  for (std::size_t i = 1; i < kColours.size(); ++i) init_pair(static_cast<short>(i), kColours[i], -1);
}

Terminal::~Terminal() {
  erase();
  refresh();
  endwin();
}

int Terminal::width() const {
  return getmaxx(stdscr);
}

int Terminal::height() const {
  return getmaxy(stdscr);
}

void Terminal::show(const Grid& grid) {
  erase();
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const Glyph& glyph = grid.at(x, y);
      if (glyph == Glyph{}) continue;
      const std::array<wchar_t, 2> text{static_cast<wchar_t>(glyph.symbol), L'\0'};
      cchar_t shown;
      const auto pair = static_cast<short>(colour_ ? glyph.style.colour : Colour::Default);
      setcchar(&shown, text.data(), attributes_of(glyph.style), pair, nullptr);
      mvadd_wch(y, x, &shown);
    }
  }
  refresh();
}

std::optional<Key> Terminal::key() {
  switch (const int code = getch()) {
    case ERR:
      return std::nullopt;
    case KEY_UP:
      return Key{0, Special::Up};
    case KEY_DOWN:
      return Key{0, Special::Down};
    case KEY_LEFT:
      return Key{0, Special::Left};
    case KEY_RIGHT:
      return Key{0, Special::Right};
    default:
      return Key{code > 0 && code < 128 ? static_cast<char>(code) : '\0', Special::None};
  }
}

void Terminal::resize() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0 && size.ws_col > 0) {
    resizeterm(size.ws_row, size.ws_col);
  }
  clearok(curscr, TRUE);
}

}  // namespace skein::monitor
