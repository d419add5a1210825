// The world as a process: scenario in, run over DDS, report out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "idl/process/common_flags.hpp"
#include "simworld/lockstep/faults.hpp"
#include "simworld/scenario/scenario.hpp"

namespace skein {

/// What the world is asked to run. `skein run` passes its own flags on.
struct WorldArguments {
  CommonFlags common;
  std::string scenario;
  std::optional<std::uint64_t> seed;
  std::vector<Override> overrides;
  std::vector<Fault> faults;
  bool fail_fast = false;
  double realtime = 0.0;   ///< times real time; 0: as fast as it goes
  std::string out;         ///< folder for report, scenario copy and logs; empty: skein-runs/<time>-<seed>
  double settle_s = 1.0;   ///< silence before the mission is published, in which another world may be found
  std::string checkpoint;  ///< folder from which a world that died is started again; empty for none
  bool checkpoint_sync = false;
  bool recorded = false;    ///< the launcher records: it says which rounds it has
  bool wait_start = false;  ///< the mission starts when a command says so as well
  int control_fd = -1;      ///< of the launcher's socket pair; -1 when started by hand
};

/// Adds SCENARIO, --seed, --set, --planner: what names a scenario.
void add_scenario_options(CLI::App& app, WorldArguments& arguments);

/// Adds those and --out, --fail-fast / --keep-going, --fault: what run and world have in common.
void add_world_options(CLI::App& app, WorldArguments& arguments);

/// The scenario with the overrides, or nothing after one line on standard error.
[[nodiscard]] std::optional<Scenario> load_or_complain(const WorldArguments& arguments);

/// Creates `out`, or by default a new folder skein-runs/<time>-<seed>, and writes the scenario's copy into it.
/// @return the folder. @throws std::runtime_error with one line
[[nodiscard]] std::string prepare_out(const std::string& out, const Scenario& scenario);

/// Runs to the end and writes the report. @return the exit code (docs/architecture.md)
[[nodiscard]] int run_world(const WorldArguments& arguments);

}  // namespace skein
