#include "idl/convert/area_wire.hpp"

#include "idl/convert/limits.hpp"
#include "idl/convert/parts.hpp"

namespace skein {
namespace {

constexpr std::uint8_t kCylinder = 0;
constexpr std::uint8_t kBox = 1;

}  // namespace

wire::Area wire_area(const Zone& zone) {
  wire::Area out;
  out.no_fly(zone.no_fly);
  if (const auto* cylinder = std::get_if<Cylinder>(&zone.shape)) {
    out.shape(kCylinder);
    out.min_m(wire_point({cylinder->centre_m.x(), cylinder->centre_m.y(), cylinder->z_min_m}));
    out.max_m(wire_point({0.0, 0.0, cylinder->z_max_m}));
    out.radius_m(cylinder->radius_m);
  } else {
    const auto& box = std::get<Box>(zone.shape);
    out.shape(kBox);
    out.min_m(wire_point(box.min_m));
    out.max_m(wire_point(box.max_m));
  }
  return out;
}

Zone plain_zone(const wire::Area& area) {
  const Vec3 low = plain_point(area.min_m());
  const Vec3 high = plain_point(area.max_m());
  if (area.shape() == kBox) return {Box{low, high}, area.no_fly()};
  return {Cylinder{Vec2(low.x(), low.y()), area.radius_m(), low.z(), high.z()}, area.no_fly()};
}

void check_area(Checker& check, const wire::Area& area, std::string_view where) {
  check.enumerator(area.shape(), kCylinder, kBox, where);
  check.position(area.min_m(), where);
  check.position(area.max_m(), where);
  check.within(area.radius_m(), 0.0, limits::kPosition_m, where);
  const bool flat = area.shape() == kCylinder;
  check.require(area.min_m().z() <= area.max_m().z(), WireFaultReason::BadMission, where);
  check.require(flat || area.min_m().x() <= area.max_m().x(), WireFaultReason::BadMission, where);
  check.require(flat || area.min_m().y() <= area.max_m().y(), WireFaultReason::BadMission, where);
}

wire::Announced wire_announced(const Announcement& announced) {
  wire::Announced out;
  out.place(wire_area({announced.shape, false}));
  out.from_s(announced.from_s);
  out.to_s(announced.to_s);
  out.early_s(announced.early_s);
  out.clear_s(announced.clear_s);
  return out;
}

Announcement plain_announced(const wire::Announced& announced) {
  return {plain_zone(announced.place()).shape, announced.from_s(), announced.to_s(), announced.early_s(),
          announced.clear_s()};
}

}  // namespace skein
