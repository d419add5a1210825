#include "planner/core/text/utf8.hpp"

#include <algorithm>

namespace skein {
namespace {

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

/// Whether a character may begin there, in UTF-8.
bool begins(char c) {
  return (static_cast<unsigned>(static_cast<unsigned char>(c)) & 0xC0U) != 0x80U;
}

}  // namespace

std::size_t utf8_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  const unsigned second = byte(1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  const bool beyond = first == 0xF4 && second >= 0x90;
  return overlong || surrogate || beyond ? 0 : size;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = utf8_size(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string one_line(std::string_view text, std::size_t most) {
  std::string line;
  while (!text.empty()) {
    const std::size_t size = utf8_size(text);
    if (size == 0 || is_control(text.front())) {
      line += '?';
    } else {
      line += text.substr(0, size);
    }
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  if (line.size() <= most) return line;
  constexpr std::string_view kGap = " ... ";
  std::size_t head = (most - kGap.size()) / 2;
  std::size_t tail = line.size() - head;
  while (!begins(line[head])) --head;
  while (tail < line.size() && !begins(line[tail])) ++tail;
  return line.substr(0, head).append(kGap).append(line.substr(tail));
}

}  // namespace skein
