#include "planner/rendezvous/kernel/table.hpp"

namespace skein::rendezvous::kernel {

extern const Kernel kBaselineKernel;
constinit const Kernel kBaselineKernel = kernel_with<LanesOf<2>>();

}  // namespace skein::rendezvous::kernel
