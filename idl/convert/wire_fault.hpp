// What is wrong with a sample that came over the wire, and how often it happened.
//
// Wire data is checked once, where it enters (idl/convert/convert.hpp): the result is a value or a fault, never half a
// value. A refused sample is dropped and counted by its reason; it never ends a process.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

namespace skein {

enum class WireFaultReason : std::uint8_t {
  NonFinite = 0,         ///< a number is NaN or infinite
  OutOfRange = 1,        ///< a number, a length of a sequence or a text is outside what the field allows
  UnknownAgent = 2,      ///< an agent id is 0, over kMaxAgents or not one of the mission's
  WrongRun = 3,          ///< the sample belongs to another run
  WrongIncarnation = 4,  ///< the sender is not live under this incarnation (and nonce)
  WrongSender = 5,       ///< the header's sender may not send this sample
  BadEnum = 6,           ///< an octet stands for no enumerator
  BadOrder = 7,          ///< a list that ascends strictly does not: disorder or a duplicate
  BadMission = 8,        ///< the parts of a mission contradict each other
  BadOptions = 9,        ///< planner options that fail validate()
};
inline constexpr std::size_t kWireFaultReasons = 10;

/// The word for reports and logs: "non_finite", "out_of_range" ...
[[nodiscard]] std::string_view name_of(WireFaultReason reason);

struct WireFault {
  WireFaultReason reason = WireFaultReason::OutOfRange;
  std::string_view where;  ///< static text: the first field that is refused, "tick.time_s"

  bool operator==(const WireFault&) const = default;
};

/// A checked value, or why it was refused.
template <typename T>
class [[nodiscard]] Checked {
 public:
  Checked(T value) : content_(std::move(value)) {}      // NOLINT(google-explicit-constructor): a result converts
  Checked(const WireFault& fault) : content_(fault) {}  // NOLINT(google-explicit-constructor): from both its sides

  [[nodiscard]] bool ok() const { return std::holds_alternative<T>(content_); }
  explicit operator bool() const { return ok(); }

  /// @pre ok(); throws std::logic_error otherwise.
  [[nodiscard]] const T& value() const& { return *require(std::get_if<T>(&content_)); }
  [[nodiscard]] T&& value() && { return std::move(*require(std::get_if<T>(&content_))); }
  /// @pre !ok(); throws std::logic_error otherwise.
  [[nodiscard]] const WireFault& fault() const { return *require(std::get_if<WireFault>(&content_)); }

 private:
  template <typename Pointer>
  static Pointer require(Pointer pointer) {
    if (pointer == nullptr) throw std::logic_error("Checked: asked for the side that it does not hold");
    return pointer;
  }

  std::variant<T, WireFault> content_;
};

/// How many samples were refused, by reason.
class FaultCounts {
 public:
  void add(WireFaultReason reason) { ++counts_[static_cast<std::size_t>(reason)]; }
  [[nodiscard]] std::uint64_t of(WireFaultReason reason) const { return counts_[static_cast<std::size_t>(reason)]; }
  [[nodiscard]] std::uint64_t total() const;

  bool operator==(const FaultCounts&) const = default;

 private:
  std::array<std::uint64_t, kWireFaultReasons> counts_{};
};

}  // namespace skein
