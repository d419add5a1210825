// Random paths in the kernel's tables: any poses and headings, controls over the whole search range and its slow ends.
#pragma once

#include <vector>

#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/cost/batch.hpp"
#include "planner/rendezvous/kernel/dispatch.hpp"

namespace skein::test {

template <typename Space>
struct RandomBatch {
  std::size_t lanes = 0;
  std::vector<typename Space::Hermite> hermites;
  std::vector<rendezvous::ph::Controls> controls;
  rendezvous::kernel::LaneTable ends;
  rendezvous::kernel::LaneTable m;  ///< rows m0, m1
};

/// `lanes` paths (at least 1), drawn from the stream (seed, index).
template <typename Space = rendezvous::Planar>
[[nodiscard]] RandomBatch<Space> random_batch(std::uint64_t seed, std::uint64_t index, std::size_t lanes);

/// Kernels of the instruction sets that this machine has, without the scalar one.
[[nodiscard]] std::vector<Isa> supported_wide_isas();

/// SKEIN_<name> of the environment, else `plain`, or a fiftieth of it (at least 1) under sanitizers.
[[nodiscard]] std::uint64_t count_or(const char* name, std::uint64_t plain);

}  // namespace skein::test
