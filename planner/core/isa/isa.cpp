#include "planner/core/isa/isa.hpp"

#include <fmt/core.h>

namespace skein {
namespace {

std::optional<Isa> isa_of(std::string_view name) {
  for (const Isa isa : kIsas) {
    if (name_of(isa) == name) return isa;
  }
  return std::nullopt;
}

bool is_set(const char* wanted) {
  return wanted != nullptr && *wanted != '\0';
}

}  // namespace

std::string_view name_of(Isa isa) {
  switch (isa) {
    case Isa::Scalar:
      return "scalar";
    case Isa::Baseline:
      return "baseline";
    case Isa::Avx2:
      return "avx2";
    case Isa::Avx512:
      return "avx512";
  }
  return "unknown";
}

bool is_supported(Isa isa) {
  switch (isa) {
    case Isa::Avx2:
      return __builtin_cpu_supports("avx2") != 0;
    case Isa::Avx512:
      return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
             __builtin_cpu_supports("avx512vl") != 0;
    default:
      return true;
  }
}

std::optional<std::string> isa_fault(const char* wanted) {
  if (!is_set(wanted)) return std::nullopt;
  const std::optional<Isa> isa = isa_of(wanted);
  if (isa && is_supported(*isa)) return std::nullopt;
  std::string allowed;
  for (const Isa each : kIsas) {
    if (is_supported(each)) allowed += (allowed.empty() ? "" : ", ") + std::string(name_of(each));
  }
  return fmt::format("{} is '{}', which {}; allowed here: {}", kIsaVariable, wanted,
                     isa ? "this processor lacks" : "is no instruction set", allowed);
}

Isa chosen_isa(const char* wanted) {
  if (is_set(wanted) && !isa_fault(wanted)) return *isa_of(wanted);
  if (is_supported(Isa::Avx512)) return Isa::Avx512;
  return is_supported(Isa::Avx2) ? Isa::Avx2 : Isa::Baseline;
}

}  // namespace skein
