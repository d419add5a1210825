// Memory on the stack for the short lists of one step: no step of a controller need ask the heap.
//
// Lists are std::pmr::vector; what does not fit comes from the heap. Source, Departs from source: none.
#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>

namespace skein {

class Scratch {
 public:
  Scratch() = default;
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  /// Valid as long as this is.
  [[nodiscard]] std::pmr::memory_resource* memory() { return &memory_; }

 private:
  static constexpr std::size_t kBytes = 8192;

  alignas(std::max_align_t) std::array<std::byte, kBytes> bytes_;
  std::pmr::monotonic_buffer_resource memory_{bytes_.data(), bytes_.size()};
};

}  // namespace skein
