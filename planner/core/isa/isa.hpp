// The instruction sets that hot kernels are compiled for, and which of them a process uses.
//
// A kernel is written once and compiled per set; all give the same bits, so the choice is about speed alone.
// SKEIN_ISA names one, otherwise the widest one here is taken. `scalar` works on one candidate at a time,
// `baseline` on packs of two doubles (SSE2, which every x86-64 has), `avx2` of four, `avx512` of eight.
// Source: none. Departs from source: none. Complexity: O(1).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace skein {

enum class Isa { Scalar = 0, Baseline = 1, Avx2 = 2, Avx512 = 3 };

inline constexpr std::array<Isa, 4> kIsas{Isa::Scalar, Isa::Baseline, Isa::Avx2, Isa::Avx512};
inline constexpr const char* kIsaVariable = "SKEIN_ISA";

[[nodiscard]] std::string_view name_of(Isa isa);
/// Whether this processor, and the system on it, can run code of the set.
[[nodiscard]] bool is_supported(Isa isa);

/// What is wrong with a value of SKEIN_ISA: one line, or nothing. Null or empty: not set.
[[nodiscard]] std::optional<std::string> isa_fault(const char* wanted);
/// The set that a value of SKEIN_ISA asks for; the widest one here if it is not set or has a fault. What each gains is
/// in docs/benchmarks.md.
[[nodiscard]] Isa chosen_isa(const char* wanted);

}  // namespace skein
