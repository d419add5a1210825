#include "groundstation/chaos/outcome.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace skein::chaos {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 5> kResults{"completed", "degraded", "unsafe", "hung", "stopped"};

template <typename T>
Json json_or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <typename T>
std::optional<T> optional_of(const Json& value) {
  return value.is_null() ? std::nullopt : std::optional<T>(value.get<T>());
}

/// The enumerator of that name.
template <typename Enumerator, std::size_t kCount>
Enumerator named(const std::array<std::string_view, kCount>& names, const std::string& name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw std::runtime_error("unknown name '" + name + "'");
  return static_cast<Enumerator>(found - names.begin());
}

}  // namespace

bool is_sound(const RunOutcome& outcome) {
  const bool ended = outcome.result == Result::Completed || outcome.result == Result::Degraded;
  return ended && outcome.orphans.empty() && outcome.leftovers.empty() && outcome.unexplained.empty() &&
         !outcome.replay_differs && outcome.maps_differ == 0 && outcome.unaccepted.empty();
}

Json json_of(const RunOutcome& outcome) {
  Json run{{"seed", outcome.seed},
           {"kind", name_of(outcome.kind)},
           {"fault", outcome.fault},
           {"befallen", outcome.befallen},
           {"injected", outcome.injected},
           {"result", kResults[static_cast<std::size_t>(outcome.result)]},
           {"exit_code", outcome.exit_code},
           {"reason", outcome.reason},
           {"state_hash", outcome.state_hash},
           {"replay_differs", outcome.replay_differs},
           {"sound", is_sound(outcome)},
           {"wall_s", outcome.wall_s}};
  run["recovery_steps"] = json_or_null(outcome.recovery_steps);
  run["recovery_s"] = json_or_null(outcome.recovery_s);
  run["orphans"] = outcome.orphans;
  run["leftovers"] = outcome.leftovers;
  run["unexplained"] = outcome.unexplained;
  run["unaccepted_plans"] = outcome.unaccepted;
  run["maps_due"] = outcome.maps_due;
  run["maps_differ"] = outcome.maps_differ;
  return run;
}

RunOutcome outcome_of(const Json& run) try {
  RunOutcome outcome;
  run.at("seed").get_to(outcome.seed);
  outcome.kind = named<Kind>(kNames, run.at("kind"));
  run.at("fault").get_to(outcome.fault);
  run.at("befallen").get_to(outcome.befallen);
  run.at("injected").get_to(outcome.injected);
  outcome.result = named<Result>(kResults, run.at("result"));
  run.at("exit_code").get_to(outcome.exit_code);
  run.at("reason").get_to(outcome.reason);
  run.at("state_hash").get_to(outcome.state_hash);
  run.at("replay_differs").get_to(outcome.replay_differs);
  run.at("wall_s").get_to(outcome.wall_s);
  outcome.recovery_steps = optional_of<std::uint32_t>(run.at("recovery_steps"));
  outcome.recovery_s = optional_of<double>(run.at("recovery_s"));
  run.at("orphans").get_to(outcome.orphans);
  run.at("leftovers").get_to(outcome.leftovers);
  run.at("unexplained").get_to(outcome.unexplained);
  run.at("unaccepted_plans").get_to(outcome.unaccepted);
  run.at("maps_due").get_to(outcome.maps_due);
  run.at("maps_differ").get_to(outcome.maps_differ);
  return outcome;
} catch (const nlohmann::json::exception& error) {
  throw std::runtime_error(error.what());
}

}  // namespace skein::chaos
