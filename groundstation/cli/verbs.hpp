// The verbs of `skein`, one file each: a verb adds its flags to the command line and gives back what runs it.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <string>

namespace skein {

/// Runs the verb after parsing. @return the exit code (docs/architecture.md)
using VerbAction = std::function<int()>;

[[nodiscard]] VerbAction add_chaos_verb(CLI::App& app);
[[nodiscard]] VerbAction add_doctor_verb(CLI::App& app);
[[nodiscard]] VerbAction add_monitor_verb(CLI::App& app);
[[nodiscard]] VerbAction add_plot_verb(CLI::App& app);
[[nodiscard]] VerbAction add_profile_verb(CLI::App& app);
[[nodiscard]] VerbAction add_dump_verb(CLI::App& app);
[[nodiscard]] VerbAction add_record_verb(CLI::App& app);
[[nodiscard]] VerbAction add_replay_verb(CLI::App& app);
[[nodiscard]] VerbAction add_report_verb(CLI::App& app);
[[nodiscard]] VerbAction add_reproduce_verb(CLI::App& app);
[[nodiscard]] VerbAction add_run_verb(CLI::App& app);
[[nodiscard]] VerbAction add_status_verb(CLI::App& app);
/// start, hold, resume, abort, land, goto, inject, pause, kill, restart: by name.
[[nodiscard]] std::map<std::string, VerbAction> add_steer_verbs(CLI::App& app);
[[nodiscard]] VerbAction add_sweep_verb(CLI::App& app);
[[nodiscard]] VerbAction add_topics_verb(CLI::App& app);
[[nodiscard]] VerbAction add_validate_verb(CLI::App& app);
[[nodiscard]] VerbAction add_verify_verb(CLI::App& app);
[[nodiscard]] VerbAction add_version_verb(CLI::App& app);

}  // namespace skein
