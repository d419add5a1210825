// Collects the first fault of a sample, so that a converter reads as the list of what must hold.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "idl/convert/convert.hpp"

namespace skein {

class Checker {
 public:
  explicit Checker(const WireContext& context) : context_(context) {}

  /// The first broken requirement stands; later ones are not looked at.
  void require(bool holds, WireFaultReason reason, std::string_view where) {
    if (!fault_ && !holds) fault_ = WireFault{reason, where};
  }

  /// Finite and within [low, high].
  void within(double value, double low, double high, std::string_view where);
  void size_at_most(std::size_t size, std::size_t bound, std::string_view where) {
    require(size <= bound, WireFaultReason::OutOfRange, where);
  }
  /// An octet that stands for an enumerator from `first` to `last`.
  template <typename Enum>
  void enumerator(std::uint8_t octet, Enum first, Enum last, std::string_view where) {
    require(octet >= static_cast<std::uint8_t>(first) && octet <= static_cast<std::uint8_t>(last),
            WireFaultReason::BadEnum, where);
  }
  void position(const wire::Point3& point, std::string_view where);
  void velocity(const wire::Point3& vector, std::string_view where);
  /// At most `bound` of them, by ascending id from 1.
  void tracks(const std::vector<wire::Sighting>& tracks, std::size_t bound, std::string_view where);
  void pose(const wire::DirectedPoint& pose, std::string_view where);
  /// Printable: no control characters.
  void text(std::string_view value, std::string_view where);

  /// 1 to kMaxAgents, and one of the context's known ids.
  void agent(std::uint32_t id, std::string_view where);
  /// Live under this incarnation according to the context's roster; 0 is no incarnation.
  void incarnation(std::uint32_t id, std::uint32_t incarnation, std::optional<std::uint64_t> nonce,
                   std::string_view where);
  void run(std::uint64_t run, std::string_view where);
  void sender(const wire::Header& head, std::uint32_t sender, std::string_view where);

  [[nodiscard]] bool ok() const { return !fault_.has_value(); }
  /// @pre !ok()
  [[nodiscard]] const WireFault& fault() const { return *fault_; }

 private:
  void point(const wire::Point3& point, double bound, std::string_view where);

  const WireContext& context_;
  std::optional<WireFault> fault_;
};

}  // namespace skein
