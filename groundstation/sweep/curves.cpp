#include "groundstation/sweep/curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "groundstation/figure/outline.hpp"
#include "planner/rendezvous/path_profile.hpp"

namespace skein {
namespace {

constexpr std::size_t kPoints = 201;
constexpr std::size_t kLongestTitle = 100;

void write(const CurveFiles& files, const char* what, const std::string& text) {
  const std::filesystem::path path = files.folder / fmt::format("{}-{}.csv", files.stem, what);
  std::ofstream file(path);
  file << text << std::flush;
  if (!file) throw CurvesNotWritten(fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
}

std::string zone_text(std::size_t number, const figure::Outline& outline) {
  std::string text;
  for (const Vec2& corner : outline.corners_m) {
    text += fmt::format("{},{:d},{},{},{},{},{:d}\n", number, outline.kind == figure::ZoneKind::NoFly ? 1 : 0,
                        corner.x(), corner.y(), outline.heights_m.min, outline.heights_m.max,
                        outline.kind == figure::ZoneKind::Hidden ? 1 : 0);
  }
  return text;
}

/// What the planners published, round by round, as lines.
class Convergence {
 public:
  void note(const Run& run) {
    if (run.planning_rounds() == noted_) return;
    noted_ = run.planning_rounds();
    for (const RosterEntry& entry : run.roster()) {
      const PlanFigures& plan = *std::ranges::find(run.plan(), entry.agent, &PlanFigures::agent);
      lines_ += fmt::format("{},{},{},{},{}\n", plan.agent, noted_, plan.generation, plan.cost, plan.length_m);
    }
  }
  [[nodiscard]] std::string text() const { return "vehicle,round,generation,cost,path_length_m\n" + lines_; }

 private:
  std::uint32_t noted_ = 0;
  std::string lines_;
};

/// Where everybody was at the end of each flight step, the starts as step 0, as lines.
class Positions {
 public:
  void note(const Run& run) {
    if (next_step_ > run.steps_flown()) return;
    next_step_ = run.steps_flown() + 1;
    for (const VehicleRecord& vehicle : run.world().vehicles()) {
      const Vec3& r = vehicle.state.position_m;
      lines_ += fmt::format("{},{},{},{},{}\n", vehicle.spec.id, run.steps_flown(), r.x(), r.y(), r.z());
    }
  }
  [[nodiscard]] std::string text() const { return "vehicle,step,x_m,y_m,z_m\n" + lines_; }

 private:
  std::uint32_t next_step_ = 0;
  std::string lines_;
};

std::string paths_text(const Mission& mission, const nlohmann::ordered_json& vehicles) {
  std::string text =
      "vehicle,arc_m,x_m,y_m,z_m,ground_m,curvature_per_m,torsion_per_m,max_curvature_per_m,max_torsion_per_m\n";
  for (const auto& vehicle : vehicles) {
    const rendezvous::PlannedPath plan{vehicle.at("id").get<AgentId>(),
                                       vehicle.at("particle").get<std::vector<double>>()};
    if (plan.particle.empty()) continue;
    const VehicleSpec& spec = vehicle_of(mission, plan.agent);
    for (const rendezvous::ProfilePoint& point : rendezvous::path_profile(mission, plan, kPoints)) {
      const Vec3& r = point.position_m;
      const std::string ground = mission.terrain ? fmt::format("{}", ground_m(*mission.terrain, {r.x(), r.y()})) : "";
      text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", plan.agent, point.arc_m, r.x(), r.y(), r.z(), ground,
                          point.curvature_per_m, point.torsion_per_m, spec.max_curvature_per_m, spec.max_torsion_per_m);
    }
  }
  return text;
}

}  // namespace

CurveFiles curve_files(const std::filesystem::path& folder, std::size_t row, const std::string& title) {
  std::string name = title.substr(0, kLongestTitle);
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!plain && std::string_view("=.+-_").find(c) == std::string_view::npos) c = '_';
  }
  return {folder, fmt::format("{}-{}", row + 1, name)};
}

void write_zones(const Scenario& scenario, const CurveFiles& files) {
  std::error_code error;
  std::filesystem::create_directories(files.folder, error);
  if (error) throw CurvesNotWritten(fmt::format("cannot make {}: {}", files.folder.string(), error.message()));
  std::string text = "zone,no_fly,x_m,y_m,z_min_m,z_max_m,hidden\n";
  std::size_t number = 0;
  for (const Zone& zone : scenario.mission.zones) text += zone_text(++number, figure::outline_of(zone));
  for (const Obstacle& obstacle : scenario.world.hidden) text += zone_text(++number, figure::outline_of(obstacle));
  write(files, "zones", text);
}

InProcessResult run_with_curves(const Scenario& scenario, const CurveFiles& files) {
  Convergence convergence;
  Positions positions;
  const bool transit = scenario.mission.transit.has_value();
  InProcessOptions options;
  options.on_round = [&](const WorldSession& session) {
    if (transit) {
      positions.note(session.run());
    } else {
      convergence.note(session.run());
    }
  };
  InProcessResult result = run_in_process(scenario, options);
  if (transit) {
    write(files, "positions", positions.text());
  } else {
    write(files, "paths", paths_text(scenario.mission, result.report.at("vehicles")));
    write(files, "convergence", convergence.text());
  }
  return result;
}

}  // namespace skein
