// mcap_alter IN OUT MESSAGE BYTE BITS: a recording with one byte of one payload changed, and checksums that match.
//
// MESSAGE counts from 0 in the order of the file, BYTE from 0 with the 4 bytes of encapsulation; BITS (0 to 255) are
// those that flip. Exit code 0; 2 with one line if there is no such file, message or byte.
#include <charconv>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "groundstation/mcap/file.hpp"
#include "tests/groundstation/mcap/rewritten.hpp"

namespace {

std::size_t number_of(const std::string& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) throw std::invalid_argument(text + " is no number");
  return number;
}

void alter(const std::string& in, const std::string& out, std::size_t message, std::size_t byte, std::size_t bits) {
  if (bits > 255) throw std::invalid_argument("BITS are 0 to 255");
  const skein::mcap::MappedFile file(in);
  bool found = false;
  const auto changed = skein::mcap::tests::rewritten(
      file.bytes(), [&](std::size_t number, const std::string&, skein::mcap::Bytes& payload) {
        if (number != message) return;
        payload.at(byte) ^= static_cast<std::uint8_t>(bits);
        found = true;
      });
  if (!found) throw std::invalid_argument("there is no message " + std::to_string(message));
  skein::mcap::OutputFile(out).write(changed);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::cerr << "usage: mcap_alter IN OUT MESSAGE BYTE BITS\n";
    return 2;
  }
  try {
    alter(argv[1], argv[2], number_of(argv[3]), number_of(argv[4]), number_of(argv[5]));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "mcap_alter: " << error.what() << "\n";
    return 2;
  }
}
