// skein-agent --id K: one UAV. It knows its id and how to reach the bus, nothing else.
#include "agent/process/agent_process.hpp"

int main(int argc, char** argv) {
  skein::keep_standard_streams();
  CLI::App app("One UAV of a Skein swarm", "skein-agent");
  skein::AgentArguments arguments;
  skein::add_common_flags(app, arguments.common);
  app.add_option("--id", arguments.id, "id of the vehicle, 1 to 256")
      ->required()
      ->check(CLI::Range(1U, skein::kMaxAgents));
  app.add_option(
         "--world-timeout", arguments.world_timeout_s,
         "seconds without a world before the agent ends; default: --startup-timeout before its first tick, 30 after it")
      ->check(CLI::Range(0.1, 3600.0));
  app.set_version_flag("--version", SKEIN_VERSION);
  if (const auto code = skein::parse_or_exit_code(app, argc, argv)) return *code;
  return skein::run_agent(arguments);
}
