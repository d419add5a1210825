#include "tests/planner/rendezvous/kernel/random_batch.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "planner/core/math/det_math.hpp"

namespace skein::test {
namespace {

using rendezvous::ph::Controls;
using rendezvous::ph::Hermite;
using rendezvous::ph::PlanarPose;

/// One number in four lies at the slow end of the range, where the speed rises steeply.
double draw_control(RandomStream& stream, double chord_m) {
  const double high = stream.below(4) == 0 ? 0.15 : 6.0;
  return chord_m * stream.uniform(0.03, high);
}

}  // namespace

RandomBatch random_batch(std::uint64_t seed, std::uint64_t index, std::size_t lanes) {
  RandomStream stream(seed, 0, Purpose::Test, index);
  RandomBatch batch;
  batch.lanes = lanes;
  batch.ends.resize(rendezvous::kernel::Ends::Count, lanes);
  batch.m.resize(2, lanes);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto place = [&] { return Vec2(stream.uniform(-2e4, 2e4), stream.uniform(-2e4, 2e4)); };
    const auto angle = [&] { return stream.uniform(-math::kPi, math::kPi); };
    const PlanarPose start{place(), angle()};
    const PlanarPose end{place(), angle()};
    const Hermite hermite(start, end);
    const Controls controls{draw_control(stream, hermite.chord_m()), draw_control(stream, hermite.chord_m())};
    rendezvous::put_ends(hermite, lane, batch.ends);
    batch.m.row(0)[lane] = controls.m0_m;
    batch.m.row(1)[lane] = controls.m1_m;
    batch.hermites.push_back(hermite);
    batch.controls.push_back(controls);
  }
  batch.ends.pad(lanes);
  batch.m.pad(lanes);
  return batch;
}

std::vector<Isa> supported_wide_isas() {
  std::vector<Isa> isas;
  std::ranges::copy_if(kIsas, std::back_inserter(isas),
                       [](Isa isa) { return isa != Isa::Scalar && is_supported(isa); });
  return isas;
}

std::uint64_t count_or(const char* name, std::uint64_t plain) {
  if (const char* set = std::getenv(name)) return std::max<std::uint64_t>(1, std::strtoull(set, nullptr, 10));
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return std::max<std::uint64_t>(1, plain / 50);
#else
  return plain;
#endif
}

}  // namespace skein::test
