#include "simworld/report/flight_report.hpp"

#include "planner/core/lockstep/names.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

Json step_or_null(std::uint32_t step) {
  return step == 0 ? Json(nullptr) : Json(step);
}

Json movers_of(const World& world) {
  Json list = Json::array();
  for (const MoverRecord& mover : world.movers()) {
    list.push_back({{"id", mover.id},
                    {"name", mover.spec.name},
                    {"radius_m", mover.spec.radius_m},
                    {"column", mover.spec.column},
                    {"speed_mps", speed_of(mover.spec)},
                    {"appeared_step", step_or_null(mover.appeared_step)},
                    {"gone_step", step_or_null(mover.gone_step)}});
  }
  return list;
}

Json events_of(const FlightLog& log) {
  Json list = Json::array();
  for (const FlightEvent& event : log.events()) {
    list.push_back({{"step", event.step},
                    {"round", event.round},
                    {"agent", event.agent},
                    {"mode", name_of(event.mode)},
                    {"reason", name_of(event.reason)},
                    {"replanning", event.replanning},
                    {"deviation_m", event.deviation_m},
                    {"predicted_separation_m", event.predicted_separation_m}});
  }
  return list;
}

Json replans_of(const FlightLog& log) {
  Json list = Json::array();
  for (const Replan& replan : log.replans()) {
    list.push_back({{"step", replan.step},
                    {"round", replan.round},
                    {"agent", replan.agent},
                    {"reason", name_of(replan.reason)},
                    {"switch_step", step_or_null(replan.switch_step)},
                    {"ended_step", step_or_null(replan.ended_step)},
                    {"outcome", name_of(replan.outcome)}});
  }
  return list;
}

}  // namespace

void add_surprises(Json& report, const Run& run) {
  const World& world = run.world();
  report["rammed_at_rest"] = world.count(ContactKind::Rammed);
  report["mover_contacts"] = world.count(ContactKind::Mover);
  report["zone_entries"] = world.count(ContactKind::ZoneEntry);
  report["movers"] = movers_of(world);
  report["replan_rounds"] = run.replan_rounds();
  report["replans"] = replans_of(run.flight_log());
  report["events"] = events_of(run.flight_log());
  report["events_left_out"] = run.flight_log().events_left_out();
}

}  // namespace skein
