// skein start, hold, resume, abort, land, goto, inject, pause, kill, restart: steering a swarm that others started.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <iostream>
#include <memory>
#include <vector>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/steer/steering.hpp"
#include "idl/convert/limits.hpp"
#include "idl/process/common_flags.hpp"
#include "idl/process/number_within.hpp"
#include "planner/core/lockstep/names.hpp"

namespace skein {
namespace {

constexpr int kUsage = 2;
constexpr double kLookForSwarm_s = 10.0;

struct SteerArguments {
  CommonFlags common;
  SteerRequest request;
  std::string verb;
  std::string what;  ///< of inject
  std::string shape;
  std::vector<double> point;
  std::vector<double> velocity;
  AgentId agent = kAllAgents;
  bool json = false;
};

using Shared = std::shared_ptr<SteerArguments>;
using limits::kPosition_m;
using limits::kSpeed_mps;

/// What the wire lets through (of a radius: in what agents sense): the world does not answer a command that is beyond.
CLI::Validator within(double bound) {
  return number_within(-bound, bound);
}

int run(const SteerArguments& arguments) {
  try {
    const SteerResult result = steer(arguments.common, arguments.request);
    if (arguments.json && !result.json.is_null()) std::cout << result.json.dump(2) << std::endl;
    if (result.exit_code != 0) {
      std::cerr << fmt::format("skein {}: {}\n", arguments.verb, result.reason);
      return result.exit_code;
    }
    if (!arguments.json) {
      const auto agents = result.json.at("acknowledged").get<std::vector<AgentId>>();
      std::cout << fmt::format("{}: round {}{}", arguments.verb, result.json.at("round").get<std::uint32_t>(),
                               agents.empty() ? "" : fmt::format(", acknowledged by {}", fmt::join(agents, ", ")))
                << std::endl;
    }
    return std::cout ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << fmt::format("skein {}: {}\n", arguments.verb, error.what());
    return kUsage;
  }
}

Vec3 vector_of(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

CLI::App* add_verb(CLI::App& app, const char* name, const char* about, const Shared& arguments) {
  CLI::App* verb = app.add_subcommand(name, about);
  arguments->verb = name;
  arguments->common.startup_timeout_s = kLookForSwarm_s;
  add_common_flags(*verb, arguments->common);
  verb->get_option("--startup-timeout")->description("seconds in which a swarm must be heard");
  verb->add_option("--deadline", arguments->request.deadline_s, "seconds in which it must be acknowledged")
      ->check(number_within(0.1, 3600.0))
      ->capture_default_str();
  verb->add_flag("--json", arguments->json, "print JSON on standard output");
  verb->footer(fmt::format("Example: skein {} --swarm geese", name));
  return verb;
}

CLI::Option* add_agent(CLI::App& verb, const Shared& arguments, const char* help) {
  return verb.add_option("--agent", arguments->agent, help)->check(CLI::Range(AgentId{1}, AgentId{kMaxAgents}));
}

VerbAction add_order(CLI::App& app, OrderKind kind, const char* about) {
  auto arguments = std::make_shared<SteerArguments>();
  CLI::App* verb = add_verb(app, std::string(name_of(kind)).c_str(), about, arguments);
  const bool one = kind != OrderKind::Start && kind != OrderKind::Abort;
  if (one) {
    add_agent(*verb, arguments, "of this agent alone; by default all");
    verb->footer(fmt::format("Example: skein {} --swarm geese --agent 3", name_of(kind)));
  }
  return [arguments, kind] {
    arguments->request.what = Order{0, arguments->agent, kind, Vec3::Zero(), 0.0};
    return run(*arguments);
  };
}

VerbAction add_goto(CLI::App& app) {
  auto arguments = std::make_shared<SteerArguments>();
  auto speed_mps = std::make_shared<double>(0.0);
  CLI::App* verb = add_verb(app, "goto", "send an agent to a point, where it holds", arguments);
  verb->add_option("POINT", arguments->point, "X Y Z in metres")->required()->expected(3)->check(within(kPosition_m));
  add_agent(*verb, arguments, "the agent")->required();
  verb->add_option("--speed", *speed_mps, "m/s; by default the vehicle's own")->check(number_above_0(kSpeed_mps));
  verb->footer("Example: skein goto 120 -40 10 --agent 3 --speed 4");
  return [arguments, speed_mps] {
    arguments->request.what = Order{0, arguments->agent, OrderKind::Goto, vector_of(arguments->point), *speed_mps};
    return run(*arguments);
  };
}

VerbAction add_inject(CLI::App& app) {
  auto arguments = std::make_shared<SteerArguments>();
  auto obstacle = std::make_shared<Injection>();
  CLI::App* verb = add_verb(app, "inject", "put an obstacle into the world, which no agent is told of", arguments);
  verb->add_option("WHAT", arguments->what, "obstacle")->required()->check(CLI::IsMember({"obstacle"}));
  verb->add_option("SHAPE", arguments->shape, "sphere, or column: upright, without ends")
      ->required()
      ->check(CLI::IsMember({"sphere", "column"}));
  verb->add_option("--at", arguments->point, "X Y Z of its centre in metres")
      ->required()
      ->expected(3)
      ->check(within(kPosition_m));
  verb->add_option("--radius", obstacle->radius_m, "metres")->required()->check(number_above_0(kPosition_m));
  verb->add_option("--velocity", arguments->velocity, "VX VY VZ in m/s; by default it never moves")
      ->expected(3)
      ->check(within(kSpeed_mps));
  verb->footer("Example: skein inject obstacle sphere --at 100 50 10 --radius 5 --velocity -2 0 0");
  return [arguments, obstacle] {
    obstacle->position_m = vector_of(arguments->point);
    if (!arguments->velocity.empty()) obstacle->velocity_mps = vector_of(arguments->velocity);
    obstacle->column = arguments->shape == "column";
    arguments->request.what = *obstacle;
    return run(*arguments);
  };
}

VerbAction add_fault(CLI::App& app, InjectionKind kind, const char* about) {
  auto arguments = std::make_shared<SteerArguments>();
  CLI::App* verb = add_verb(app, std::string(name_of(kind)).c_str(), about, arguments);
  add_agent(*verb, arguments, "the agent")->required();
  verb->footer(fmt::format("Example: skein {} --agent 3", name_of(kind)));
  return [arguments, kind] {
    Injection fault;
    fault.kind = kind;
    fault.agent = arguments->agent;
    arguments->request.what = fault;
    return run(*arguments);
  };
}

}  // namespace

std::map<std::string, VerbAction> add_steer_verbs(CLI::App& app) {
  return {
      {"start", add_order(app, OrderKind::Start, "start the mission of a world that waits for it (--wait-start)")},
      {"hold", add_order(app, OrderKind::Hold, "have agents wait where they are")},
      {"resume", add_order(app, OrderKind::Resume, "have agents go on with their mission")},
      {"abort", add_order(app, OrderKind::Abort, "end the run, which has failed")},
      {"land", add_order(app, OrderKind::Land, "have agents go down, and end their mission")},
      {"goto", add_goto(app)},
      {"inject", add_inject(app)},
      {"pause", add_fault(app, InjectionKind::Pause, "stop an agent's process (of skein run)")},
      {"kill", add_fault(app, InjectionKind::Kill, "kill an agent's process (of skein run)")},
      {"restart", add_fault(app, InjectionKind::Restart, "kill an agent's process and start another (of skein run)")},
  };
}

}  // namespace skein
