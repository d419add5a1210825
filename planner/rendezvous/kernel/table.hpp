// The kernel of the instruction set that the including file is compiled for.
#pragma once

#include "planner/rendezvous/kernel/interpolate.hpp"
#include "planner/rendezvous/kernel/interpolate_in_space.hpp"
#include "planner/rendezvous/kernel/judge.hpp"
#include "planner/rendezvous/kernel/judge_in_space.hpp"
#include "planner/rendezvous/kernel/kernel.hpp"
#include "planner/rendezvous/kernel/meet.hpp"
#include "planner/rendezvous/kernel/walk.hpp"

namespace skein::rendezvous::kernel {
namespace {

template <typename Lanes>
constexpr Kernel kernel_with() {
  return {Lanes::kWidth,
          {interpolate<Lanes>, measure<Lanes>, judge<Lanes>, walk<Paths, Lanes>, meet<2, Lanes>},
          {interpolate_in_space<Lanes>, measure_in_space<Lanes>, judge_in_space<Lanes>, walk<SpatialPaths, Lanes>,
           meet<3, Lanes>}};
}

}  // namespace
}  // namespace skein::rendezvous::kernel
