#include "planner/rendezvous/kernel/dispatch.hpp"

#include <cstdlib>

namespace skein::rendezvous::kernel {

extern const Kernel kScalarKernel;
extern const Kernel kBaselineKernel;
extern const Kernel kAvx2Kernel;
extern const Kernel kAvx512Kernel;

const Kernel& kernel_of(Isa isa) {
  switch (isa) {
    case Isa::Scalar:
      return kScalarKernel;
    case Isa::Avx2:
      return kAvx2Kernel;
    case Isa::Avx512:
      return kAvx512Kernel;
    default:
      return kBaselineKernel;
  }
}

const Kernel& chosen_kernel() {
  static const Kernel& chosen = kernel_of(chosen_isa(std::getenv(kIsaVariable)));
  return chosen;
}

}  // namespace skein::rendezvous::kernel
