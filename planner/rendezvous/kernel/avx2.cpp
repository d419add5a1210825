#include "planner/rendezvous/kernel/table.hpp"

namespace skein::rendezvous::kernel {

extern const Kernel kAvx2Kernel;
constinit const Kernel kAvx2Kernel = kernel_with<LanesOf<4>>();

}  // namespace skein::rendezvous::kernel
