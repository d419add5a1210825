// Which of the compiled kernels is used.
//
// Apart from kernel.hpp, so that the files compiled for wider instruction sets see nothing of the standard library.
// Source: none. Departs from source: none. Complexity: O(1).
#pragma once

#include "planner/core/isa/isa.hpp"
#include "planner/rendezvous/kernel/kernel.hpp"

namespace skein::rendezvous::kernel {

/// The kernel compiled for a set. @pre is_supported(isa), when it is called
[[nodiscard]] const Kernel& kernel_of(Isa isa);

/// The kernel of the set that SKEIN_ISA asks for, else of the widest one here; the same for the life of the process.
[[nodiscard]] const Kernel& chosen_kernel();

}  // namespace skein::rendezvous::kernel
