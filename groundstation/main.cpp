// skein VERB: the ground station.
#include <map>

#include "groundstation/cli/verbs.hpp"
#include "idl/process/common_flags.hpp"
#include "simworld/report/report.hpp"

int main(int argc, char** argv) {
  skein::keep_standard_streams();
  CLI::App app("Skein: distributed UAV swarms over DDS", "skein");
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string(skein::version()));
  std::map<std::string, skein::VerbAction> verbs{
      {"chaos", skein::add_chaos_verb(app)},       {"doctor", skein::add_doctor_verb(app)},
      {"dump", skein::add_dump_verb(app)},         {"monitor", skein::add_monitor_verb(app)},
      {"plot", skein::add_plot_verb(app)},         {"profile", skein::add_profile_verb(app)},
      {"record", skein::add_record_verb(app)},     {"replay", skein::add_replay_verb(app)},
      {"report", skein::add_report_verb(app)},     {"reproduce", skein::add_reproduce_verb(app)},
      {"run", skein::add_run_verb(app)},           {"status", skein::add_status_verb(app)},
      {"sweep", skein::add_sweep_verb(app)},       {"topics", skein::add_topics_verb(app)},
      {"validate", skein::add_validate_verb(app)}, {"verify", skein::add_verify_verb(app)},
      {"version", skein::add_version_verb(app)},
  };
  verbs.merge(skein::add_steer_verbs(app));
  if (const auto code = skein::parse_or_exit_code(app, argc, argv)) return *code;
  return verbs.at(app.get_subcommands().front()->get_name())();
}
