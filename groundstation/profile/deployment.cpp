#include "groundstation/profile/deployment.hpp"

#include <fmt/core.h>

namespace skein {
namespace {

std::vector<Setting> on_one_host() {
  return {{"SKEIN_PROFILE", "udp", "nothing in /dev/shm; shm is an option on one machine"},
          {"SKEIN_STARTUP_TIMEOUT", "30", "seconds until all agents must be matched"}};
}

std::vector<Setting> in_containers() {
  return {{"SKEIN_PROFILE", "udp", "containers share no memory"},
          {"SKEIN_STARTUP_TIMEOUT", "120", "seconds until all agents must be matched: containers start one by one"}};
}

}  // namespace

std::vector<std::string> deployments() {
  return {"containers", "discovery-server", "host"};
}

std::optional<std::vector<Setting>> settings_of(std::string_view deployment, std::string_view server) {
  if (deployment == "host") return on_one_host();
  if (deployment == "containers") return in_containers();
  if (deployment != "discovery-server") return std::nullopt;
  std::vector<Setting> settings = in_containers();
  settings.push_back({"ROS_DISCOVERY_SERVER", std::string(server), "Fast DDS: found there, not by multicast"});
  return settings;
}

std::string shell_text(std::string_view deployment, const std::vector<Setting>& settings) {
  std::string text = fmt::format("# made by: skein profile {}\n", deployment);
  for (const Setting& setting : settings) {
    text += fmt::format("export {0}=\"${{{0}:-{1}}}\"  # {2}\n", setting.name, setting.value, setting.why);
  }
  return text;
}

}  // namespace skein
