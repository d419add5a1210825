#include "planner/rendezvous/kernel/table.hpp"

namespace skein::rendezvous::kernel {

extern const Kernel kAvx512Kernel;
constinit const Kernel kAvx512Kernel = kernel_with<LanesOf<8>>();

}  // namespace skein::rendezvous::kernel
