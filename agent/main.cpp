// skein-agent --id K: one UAV, or several with --id 1-8. It knows its ids and how to reach the bus, nothing else;
// without
// --id it asks the world for one.
#include "agent/process/agent_process.hpp"
#include "idl/process/id_list.hpp"
#include "idl/process/number_within.hpp"

int main(int argc, char** argv) {
  skein::keep_standard_streams();
  CLI::App app("One UAV of a Skein swarm, or several in one process", "skein-agent");
  skein::AgentArguments arguments;
  skein::add_common_flags(app, arguments.common);
  std::string ids;
  app.add_option("--id", ids,
                 "id of the vehicle, 1 to 256, or several: 1-8, 1,3,5-7; default: the lowest that the world has free")
      ->check([](const std::string& text) {
        return skein::id_list_from(text) ? ""
                                         : "'" + text + "' is no list of ids; allowed: 1 to 256, as 3, 1-8, 1,3,5-7";
      });
  app.add_option(
         "--world-timeout", arguments.world_timeout_s,
         "seconds without a world before the agent ends; default: --startup-timeout before its first tick, 30 after it")
      ->envname("SKEIN_WORLD_TIMEOUT")
      ->check(skein::number_within(0.1, 3600.0));
  app.set_version_flag("--version", SKEIN_VERSION);
  if (const auto code = skein::parse_or_exit_code(app, argc, argv)) return *code;
  if (!ids.empty()) arguments.ids = *skein::id_list_from(ids);
  return skein::run_agent(arguments);
}
