#include "groundstation/cli/run_display.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "idl/process/poll.hpp"
#include "simworld/process/progress.hpp"

namespace skein {
namespace {

std::string line_of(const nlohmann::json& state) {
  const std::string phase = state.at("phase");
  if (phase == "waiting") {
    return fmt::format("discovery: {} of {} agents", state.at("introduced").get<int>(), state.at("agents").get<int>());
  }
  if (phase == "planning") {
    return fmt::format("planning: round {}, generation {}, longest path {:.3f} km", state.at("round").get<int>(),
                       state.at("generation").get<int>(), state.at("longest_m").get<double>() / 1000.0);
  }
  if (phase == "flying") {
    return fmt::format("flight: step {}, {:.1f} s, {} of {} arrived", state.at("step").get<int>(),
                       state.at("time_s").get<double>(), state.at("arrived").get<int>(), state.at("live").get<int>());
  }
  return "";
}

std::string number(const nlohmann::ordered_json& value, double scale, int digits) {
  return value.is_number() ? fmt::format("{:.{}f}", value.get<double>() * scale, digits) : "-";
}

}  // namespace

RunDisplay::RunDisplay(bool json)
    : json_(json),
      terminal_(isatty(STDERR_FILENO) == 1),
      colour_(isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr) {}

void RunDisplay::put(const std::string& line, bool lasting) {
  if (terminal_) {
    std::cerr << "\r\x1b[K" << line << (lasting ? "\n" : "") << std::flush;
    unfinished_ = !lasting;
  } else if (lasting) {
    std::cerr << line << "\n" << std::flush;
  }
}

void RunDisplay::show(const nlohmann::json& progress) {
  const std::string line = line_of(progress);
  if (line.empty()) return;
  const std::string phase = progress.at("phase");
  if (stage_ == "waiting" && phase != "waiting") {
    const int agents = progress.at("agents").get<int>();
    const std::string whole = fmt::format("discovery: {} of {} agents", agents, agents);
    if (last_line_ != whole) put(whole, true);  // the last agents came between two looks
  }
  if (!stage_.empty() && stage_ != phase) end();
  const std::string mark = progress.at("mark");
  put(line, !terminal_ && mark != mark_);
  mark_ = mark;
  last_line_ = line;
  stage_ = phase;
}

void RunDisplay::note(const std::string& line) {
  end();
  put(line, true);
}

void RunDisplay::end() {
  if (std::exchange(unfinished_, false)) std::cerr << "\n" << std::flush;
}

void RunDisplay::result(const nlohmann::ordered_json& report, const std::string& folder) const {
  if (json_) {
    std::cout << report.dump(2) << "\n" << std::flush;
    return;
  }
  std::cout << fmt::format("{:>8} {:>10} {:>13} {:>13} {:>9} {:>14}  {}\n", "vehicle", "pid", "planned (km)",
                           "flown (km)", "arrival", "curvature/km", "status");
  for (const auto& vehicle : report.at("vehicles")) {
    std::string status = vehicle.at("status");
    if (const std::string why = vehicle.at("reason"); !why.empty()) status += " (" + why + ")";
    std::cout << fmt::format("{:>8} {:>10} {:>13} {:>13} {:>9} {:>14}  {}\n", vehicle.at("id").get<int>(),
                             vehicle.at("pid").is_null() ? "-" : vehicle.at("pid").dump(),
                             number(vehicle.at("planned_length_m"), 1e-3, 4),
                             number(vehicle.at("path_length_m"), 1e-3, 4),
                             vehicle.at("arrival_step").is_null() ? "-" : vehicle.at("arrival_step").dump(),
                             number(vehicle.at("max_curvature_per_m"), 1e3, 3), status);
  }
  std::cout << fmt::format("planned in {} s ({} rounds), flown {} steps at {} times real time\n",
                           number(report.at("plan_s"), 1.0, 3), report.at("rounds").get<int>(),
                           report.at("steps").get<int>(), number(report.at("realtime_factor"), 1.0, 0));
  std::cout << fmt::format("separation at least {} m, clearance at least {} m, collisions {}\n",
                           number(report.at("min_separation_m"), 1.0, 1), number(report.at("min_clearance_m"), 1.0, 1),
                           report.at("collisions").get<int>());
  std::cout << fmt::format("state hash {}, seed {}, report {}/report.json\n",
                           report.at("state_hash").get<std::string>(), report.at("seed").dump(), folder);
  verdict(report);
}

void RunDisplay::outcome(const nlohmann::ordered_json& result) const {
  if (json_) {
    std::cout << result.dump(2) << "\n" << std::flush;
    return;
  }
  std::cout << fmt::format("ended at step {}, {} s; state hash {}\n", result.at("step").get<int>(),
                           number(result.at("time_s"), 1.0, 1), result.at("state_hash").get<std::string>());
  verdict(result);
}

void RunDisplay::verdict(const nlohmann::ordered_json& report) const {
  const bool good = report.at("success").get<bool>();
  const char* paint = colour_ ? (good ? "\x1b[32m" : "\x1b[31m") : "";
  std::cout << fmt::format("{}{}: {}{}\n", paint, good ? "success" : "failed", report.at("reason").get<std::string>(),
                           colour_ ? "\x1b[0m" : "")
            << std::flush;
}

}  // namespace skein
