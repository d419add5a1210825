#include "tests/planner/rendezvous/kernel/random_batch.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "planner/core/math/det_math.hpp"

namespace skein::test {
namespace {

using rendezvous::Planar;
using rendezvous::Spatial;
using rendezvous::ph::Controls;
using rendezvous::ph::PlanarPose;

/// One number in four lies at the slow end of the range, where the speed rises steeply.
double draw_control(RandomStream& stream, double chord_m) {
  const double high = stream.below(4) == 0 ? 0.15 : 6.0;
  return chord_m * stream.uniform(0.03, high);
}

double draw_angle(RandomStream& stream) {
  return stream.uniform(-math::kPi, math::kPi);
}

Planar::Hermite random_hermite(Planar, RandomStream& stream) {
  const auto place = [&] { return Vec2(stream.uniform(-2e4, 2e4), stream.uniform(-2e4, 2e4)); };
  const PlanarPose start{place(), draw_angle(stream)};
  const PlanarPose end{place(), draw_angle(stream)};
  return Planar::Hermite(start, end);
}

/// One in four lies level, in a plane.
Spatial::Hermite random_hermite(Spatial, RandomStream& stream) {
  const bool level = stream.below(4) == 0;
  const auto draw = [&] {
    Pose pose;
    pose.position_m = {stream.uniform(-2e4, 2e4), stream.uniform(-2e4, 2e4), level ? 0.0 : stream.uniform(0.0, 8e3)};
    pose.heading_rad = draw_angle(stream);
    pose.climb_rad = level ? 0.0 : stream.uniform(-1.2, 1.2);
    return pose;
  };
  const Pose start = draw();
  const Pose end = draw();
  return Spatial::Hermite(start, end);
}

}  // namespace

template <typename Space>
RandomBatch<Space> random_batch(std::uint64_t seed, std::uint64_t index, std::size_t lanes) {
  RandomStream stream(seed, 0, Purpose::Test, index);
  RandomBatch<Space> batch;
  batch.lanes = lanes;
  batch.ends.resize(Space::EndRows::Count, lanes);
  batch.m.resize(2, lanes);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const typename Space::Hermite hermite = random_hermite(Space{}, stream);
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

template RandomBatch<Planar> random_batch(std::uint64_t, std::uint64_t, std::size_t);
template RandomBatch<Spatial> random_batch(std::uint64_t, std::uint64_t, std::size_t);

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
