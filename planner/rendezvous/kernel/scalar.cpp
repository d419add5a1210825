#include "planner/rendezvous/kernel/table.hpp"

namespace skein::rendezvous::kernel {

extern const Kernel kScalarKernel;
constinit const Kernel kScalarKernel = kernel_with<LanesOf<1>>();

}  // namespace skein::rendezvous::kernel
