#include <algorithm>

#include "simworld/collision/clearance.hpp"
#include "simworld/world/world.hpp"

namespace skein {

void World::note(bool touching, std::vector<bool>& open, std::size_t key, const Contact& contact) {
  if (touching && !open[key]) contacts_.push_back(contact);
  open[key] = touching;
}

void World::check_vehicles(std::uint32_t step) {
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    for (std::size_t j = i + 1; j < vehicles_.size(); ++j) {
      if (!in_the_air(i) || !in_the_air(j)) continue;
      const VehicleSpec& a = vehicles_[i].spec;
      const VehicleSpec& b = vehicles_[j].spec;
      const double distance_m = separation_m(motions_[i], motions_[j]);
      min_separation_m_ = std::min(min_separation_m_.value_or(distance_m), distance_m);
      const std::size_t key = i * vehicles_.size() + j;
      least_m_[key] = std::min(least_m_[key], distance_m);
      note(distance_m <= a.radius_m + b.radius_m, touching_, key,
           {ContactKind::Vehicles, step, a.id, b.id, distance_m});
      note(distance_m < a.safety_radius_m + b.safety_radius_m, near_, key,
           {ContactKind::NearMiss, step, a.id, b.id, distance_m});
    }
  }
}

void World::check_zones(std::uint32_t step) {
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    if (!in_the_air(i)) continue;
    for (std::size_t z = 0; z < zones_.size(); ++z) {
      const double distance_m = clearance_m(motions_[i], zones_[z]);
      const double body_m = distance_m - vehicles_[i].spec.radius_m;
      min_clearance_m_ = std::min(min_clearance_m_.value_or(body_m), body_m);
      const ContactKind kind = zones_[z].no_fly ? ContactKind::NoFly : ContactKind::VehicleObstacle;
      note(body_m <= 0.0, in_zone_, i * zones_.size() + z,
           {kind, step, vehicles_[i].spec.id, static_cast<std::uint32_t>(z), distance_m});
    }
  }
}

void World::check_hidden(std::uint32_t step) {
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    if (!in_the_air(i)) continue;
    for (std::size_t h = 0; h < hidden_.size(); ++h) {
      const double radius_m = vehicles_[i].spec.radius_m;
      // Farther away than the least clearance so far it changes no figure.
      const double at_least_m = least_clearance_m(motions_[i], hidden_bounds_[h]) - radius_m;
      const bool far = at_least_m > 0.0 && min_clearance_m_ && at_least_m >= *min_clearance_m_;
      const double distance_m = far ? at_least_m + radius_m : clearance_m(motions_[i], hidden_[h]);
      const double body_m = distance_m - radius_m;
      min_clearance_m_ = std::min(min_clearance_m_.value_or(body_m), body_m);
      note(body_m <= 0.0, in_hidden_, i * hidden_.size() + h,
           {ContactKind::Hidden, step, vehicles_[i].spec.id, static_cast<std::uint32_t>(h), distance_m});
    }
  }
}

void World::check_terrain(std::uint32_t step) {
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    if (!in_the_air(i)) continue;
    const double distance_m = clearance_m(motions_[i], *terrain_);
    const double body_m = distance_m - vehicles_[i].spec.radius_m;
    min_clearance_m_ = std::min(min_clearance_m_.value_or(body_m), body_m);
    note(body_m <= 0.0, grounded_, i, {ContactKind::Terrain, step, vehicles_[i].spec.id, 0, distance_m});
  }
}

}  // namespace skein
