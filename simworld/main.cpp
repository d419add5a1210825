// skein-simworld SCENARIO: the truth of a run, and the only reader of its scenario.
#include "idl/process/number_within.hpp"
#include "simworld/process/world_process.hpp"
#include "simworld/report/report.hpp"

int main(int argc, char** argv) {
  skein::keep_standard_streams();
  CLI::App app("The world of a Skein swarm: owns simulated time, vehicles and roster", "skein-simworld");
  skein::WorldArguments arguments;
  skein::add_common_flags(app, arguments.common);
  skein::add_world_options(app, arguments);
  app.add_flag("--recorded", arguments.recorded, "the launcher says which rounds are recorded")->group("");
  app.add_option("--control-fd", arguments.control_fd, "descriptor of the launcher's socket pair")->group("");
  app.add_option("--settle-time", arguments.settle_s, "seconds of silence before the mission is published")
      ->check(skein::number_within(0.0, 3600.0))
      ->group("");
  app.set_version_flag("--version", std::string(skein::version()));
  if (const auto code = skein::parse_or_exit_code(app, argc, argv)) return *code;
  return skein::run_world(arguments);
}
