// The settings of each deployment, and that they give way to what is set already.
#include "groundstation/profile/deployment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

namespace skein {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view kServer = "10.1.2.3:11811";

std::string value_of(const std::vector<Setting>& settings, const std::string& name) {
  const auto found = std::ranges::find(settings, name, &Setting::name);
  return found == settings.end() ? "" : found->value;
}

/// What sh says to `script`.
std::string sh(const std::string& script) {
  const std::string command = "exec sh -uc '" + script + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::array<char, 256> buffer{};
  std::string text;
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe.get()) != nullptr) text += buffer.data();
  return text;
}

TEST(Deployment, EachHasSettingsAndNoOtherDoes) {
  for (const std::string& name : deployments()) EXPECT_FALSE(settings_of(name, kServer)->empty()) << name;
  EXPECT_FALSE(settings_of("moon", kServer).has_value());
}

TEST(Deployment, OnlyADiscoveryServersProcessesAskIt) {
  EXPECT_EQ(value_of(*settings_of("discovery-server", kServer), "ROS_DISCOVERY_SERVER"), kServer);
  EXPECT_EQ(value_of(*settings_of("containers", kServer), "ROS_DISCOVERY_SERVER"), "");
  EXPECT_EQ(value_of(*settings_of("host", kServer), "ROS_DISCOVERY_SERVER"), "");
}

TEST(Deployment, ContainersShareNoMemory) {
  EXPECT_EQ(value_of(*settings_of("containers", kServer), "SKEIN_PROFILE"), "udp");
  EXPECT_EQ(value_of(*settings_of("discovery-server", kServer), "SKEIN_PROFILE"), "udp");
}

TEST(Deployment, AShellReadsItAndWhatIsSetStays) {
  const std::string text = shell_text("discovery-server", *settings_of("discovery-server", kServer));
  EXPECT_EQ(sh("unset ROS_DISCOVERY_SERVER\n" + text + "env | grep ^ROS_"), "ROS_DISCOVERY_SERVER=10.1.2.3:11811\n");
  EXPECT_EQ(sh("SKEIN_STARTUP_TIMEOUT=7\n" + text + "env | grep ^SKEIN_STARTUP"), "SKEIN_STARTUP_TIMEOUT=7\n");
  EXPECT_THAT(text, HasSubstr("made by: skein profile discovery-server"));
  EXPECT_THAT(text, Not(HasSubstr("\'")));
}

}  // namespace
}  // namespace skein
