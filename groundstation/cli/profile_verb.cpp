// skein profile: the settings of a deployment, for the environment of its processes.
#include <fmt/core.h>

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/profile/deployment.hpp"
#include "simworld/lockstep/run.hpp"

namespace skein {
namespace {

struct ProfileArguments {
  std::string deployment;
  std::string server = "discovery:11811";
  std::string out;
  bool json = false;
};

std::string check_server(const std::string& text) {
  const bool plain = text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_:;") ==
                     std::string::npos;
  return !text.empty() && plain ? "" : fmt::format("'{}' is no server; allowed: HOST:PORT", text);
}

int show(const ProfileArguments& arguments) {
  const std::vector<Setting> settings = *settings_of(arguments.deployment, arguments.server);
  std::string text = shell_text(arguments.deployment, settings);
  if (arguments.json) {
    nlohmann::ordered_json document;
    for (const Setting& setting : settings) document[setting.name] = setting.value;
    text = document.dump(2) + "\n";
  }
  if (arguments.out.empty()) {
    std::cout << text;
    return static_cast<int>(ExitCode::Success);
  }
  std::ofstream file(arguments.out, std::ios::binary);
  file << text;
  file.close();
  if (file) return static_cast<int>(ExitCode::Success);
  std::cerr << fmt::format("cannot write {}\n", arguments.out);
  return static_cast<int>(ExitCode::Usage);
}

}  // namespace

VerbAction add_profile_verb(CLI::App& app) {
  auto arguments = std::make_shared<ProfileArguments>();
  CLI::App* verb = app.add_subcommand("profile", "print the settings of a deployment, as a script for sh");
  verb->add_option("DEPLOYMENT", arguments->deployment, "host, containers or discovery-server")
      ->required()
      ->check(CLI::IsMember(deployments()));
  verb->add_option("--server", arguments->server, "HOST:PORT of the discovery server")
      ->check(check_server)
      ->capture_default_str();
  verb->add_option("-o,--out", arguments->out, "file to write instead of standard output");
  verb->add_flag("--json", arguments->json, "print JSON");
  verb->footer("Example: skein profile containers -o containers.env");
  return [arguments] { return show(*arguments); };
}

}  // namespace skein
