#include "groundstation/figure/gnuplot_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "groundstation/figure/figures.hpp"

namespace skein::figure {
namespace {

constexpr std::array<std::string_view, 8> kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                   "#e69f00", "#56b4e9", "#8c564b", "#444444"};
constexpr std::array<std::string_view, 5> kDashes{"solid", "(12,4)", "(4,3)", "(12,3,3,3)", "(20,5)"};
constexpr std::string_view kApostrophe = "\xE2\x80\x99";
constexpr double kKilometres_m = 3000.0;
constexpr double kEqual = 1e-6;        // of a value: closer than that is the same
constexpr double kAround = 0.02;       // shown around one value
constexpr double kLogarithmic = 20.0;  // most over least from which an axis is logarithmic
constexpr double kBeyond = 1.3;
constexpr std::size_t kBelow = 12;
constexpr std::size_t kBeside = 40;

}  // namespace

std::string quote(std::string_view text) {
  std::string inside;
  for (const char c : text) {
    if (c == '\'') {
      inside += kApostrophe;
    } else {
      inside += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return "'" + inside + "'";
}

std::string colour(std::size_t i) {
  return fmt::format("linecolor rgb '{}'", kColours[i % kColours.size()]);
}

std::string dash(std::size_t i) {
  return fmt::format("dashtype {}", kDashes[i % kDashes.size()]);
}

Block::Block(std::string_view name) : text_(fmt::format("${} << EOD\n", name)) {}

Block& Block::row(double x, double y) {
  text_ += fmt::format("{:.9g} {:.9g}\n", x, y);
  return *this;
}

Block& Block::row(double x, double y, double z) {
  text_ += fmt::format("{:.9g} {:.9g} {:.9g}\n", x, y, z);
  return *this;
}

Block& Block::gap() {
  text_ += "\n";
  return *this;
}

void Span::take(double value) {
  if (empty()) {
    low = high = value;
  } else {
    low = std::min(low, value);
    high = std::max(high, value);
  }
}

Span Span::widened(double share, double least) const {
  const double size = std::max(std::abs(low), std::abs(high));
  double by = std::max(share * width(), least);
  if (by <= kEqual * size) by = kAround * size;
  if (by <= 0.0) by = kAround;
  return {low - by, high + by};
}

bool is_logarithmic(const Span& values) {
  return values.low > 0.0 && values.high > kLogarithmic * values.low;
}

std::string y_axis(const Span& values) {
  if (is_logarithmic(values)) {
    return fmt::format("set logscale y\nset format y '%g'\nset yrange [{:.9g}:{:.9g}]\n", values.low / kBeyond,
                       values.high * kBeyond);
  }
  const Span shown = values.widened(0.06, 0.0);
  return fmt::format("set yrange [{:.9g}:{:.9g}]\n", shown.low, shown.high);
}

LengthUnit unit_for(double extent_m) {
  return extent_m > kKilometres_m ? LengthUnit{"km", 1000.0} : LengthUnit{};
}

std::string key_for(std::size_t n) {
  if (n > kBeside) return "unset key\n";
  if (n > kBelow) return "set key outside right top vertical Left reverse maxrows 26 samplen 2.5 width -1 font ',12'\n";
  return kKeyBelow;
}

std::size_t stride_for(std::size_t points_of_all) {
  return 1 + points_of_all / kMostPoints;
}

}  // namespace skein::figure
