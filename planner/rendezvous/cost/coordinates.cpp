#include "planner/rendezvous/cost/coordinates.hpp"

#include <algorithm>

#include "planner/core/math/det_math.hpp"

namespace skein::rendezvous {
namespace {

constexpr double kStartChords = 2.0;
constexpr double kStartAngle_rad = 2.0;

}  // namespace

template <typename Space>
Interval range_of(const ParticipantIn<Space>& uav, std::size_t i) {
  return is_angle<Space>(i) ? Interval{-math::kPi, math::kPi} : uav.range_m;
}

template <typename Space>
Interval start_range(const ParticipantIn<Space>& uav, std::size_t i) {
  if (is_angle<Space>(i)) return {-kStartAngle_rad, kStartAngle_rad};
  if (i < 2) return uav.range_m;
  return {uav.range_m.min, std::max(uav.range_m.min, std::min(uav.range_m.max, kStartChords * uav.hermite.chord_m()))};
}

template <typename Space>
ph::Controls clamped(const ParticipantIn<Space>& uav, ph::Controls controls) {
  for (std::size_t i = 0; i < controls.size(); ++i) controls[i] = range_of(uav, i).clamp(controls[i]);
  return controls;
}

template <typename Space>
std::optional<ph::Controls> controls_of(std::span<const double> particle) {
  for (std::size_t segments = 1; segments <= ph::kMaxSegments; ++segments) {
    if (particle.size() != particle_size<Space>(segments)) continue;
    ph::Controls controls;
    controls.interior.size = particle.size() - 2;
    for (std::size_t i = 0; i < particle.size(); ++i) controls[i] = particle[i];
    return controls;
  }
  return std::nullopt;
}

std::vector<double> particle_of(const ph::Controls& controls) {
  std::vector<double> particle(controls.size());
  for (std::size_t i = 0; i < particle.size(); ++i) particle[i] = controls[i];
  return particle;
}

void add_to(StateHash& hash, const ph::Controls& controls) {
  for (std::size_t i = 0; i < controls.size(); ++i) hash.add(controls[i]);
}

template Interval range_of(const ParticipantIn<Planar>&, std::size_t);
template Interval range_of(const ParticipantIn<Spatial>&, std::size_t);
template Interval start_range(const ParticipantIn<Planar>&, std::size_t);
template Interval start_range(const ParticipantIn<Spatial>&, std::size_t);
template ph::Controls clamped(const ParticipantIn<Planar>&, ph::Controls);
template ph::Controls clamped(const ParticipantIn<Spatial>&, ph::Controls);
template std::optional<ph::Controls> controls_of<Planar>(std::span<const double>);
template std::optional<ph::Controls> controls_of<Spatial>(std::span<const double>);

}  // namespace skein::rendezvous
