// Whoever's participant is made anew, at whatever round: a run over DDS is that of one process in memory, to the state
// hash and the answers that were counted, and nobody is lost.
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <memory>

#include "agent/runtime/agent_session.hpp"
#include "groundstation/inprocess/in_process.hpp"
#include "idl/bus/dds_port.hpp"
#include "idl/process/poll.hpp"
#include "simworld/scenario/scenario.hpp"

namespace skein {
namespace {

constexpr std::uint32_t kDomain = 20;
constexpr std::uint64_t kWorldNonce = 1;
constexpr double kPatience_s = 120.0;

Scenario scenario(const std::string& path, std::vector<Override> overrides) {
  auto result = load_scenario(std::string(SKEIN_SOURCE_DIR) + "/" + path, overrides, std::nullopt);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::runtime_error(fault->line());
  return std::get<Scenario>(std::move(result));
}

bus::DdsConfig config(AgentId id) {
  bus::DdsConfig c;
  c.domain = kDomain;
  const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  c.swarm = name + "-" + std::to_string(::getpid());
  c.id = id;
  c.nonce = kWorldNonce + 100ULL * id;
  return c;
}

/// World and agents over DDS, in one thread.
class DdsRun {
 public:
  explicit DdsRun(const Scenario& scenario)
      : ids_(ids_of(scenario.mission)),
        world_port_(config(kWorldId), ids_),
        world_(scenario, session_options(), world_port_, nullptr, steady_now_s()) {
    for (const AgentId id : ids_) {
      auto agent = std::make_unique<Agent>(id);
      agents_.push_back(std::move(agent));
    }
  }

  /// To the end, or until patience ends. Every `period` rounds one participant is made anew: the world's, the first
  /// agent's and so on in turn.
  void run(std::uint32_t period) {
    std::uint32_t renewed_at = 0;
    for (const double end_s = steady_now_s() + kPatience_s; world_.state() != WorldSession::State::Done;) {
      if (steady_now_s() > end_s) return;
      for (const auto& agent : agents_) {
        if (agent->session.state() != AgentSession::State::Finished) agent->session.poll(steady_now_s());
      }
      world_.poll(steady_now_s());
      const std::uint32_t round = world_.run().rounds();
      if (round >= renewed_at + period && !world_.run().finished()) {
        renewed_at = round;
        renew(renewals_++ % (agents_.size() + 1));
      }
      wait();
    }
  }

  [[nodiscard]] const WorldSession& world() const { return world_; }
  [[nodiscard]] std::size_t renewals() const { return renewals_; }

 private:
  struct Agent {
    bus::DdsAgentPort port;
    AgentSession session;
    explicit Agent(AgentId id) : port(config(id)), session(id, config(id).nonce, port, steady_now_s()) {}
  };

  static SessionOptions session_options() {
    SessionOptions options;
    options.run = 1;
    options.nonce = kWorldNonce;
    return options;
  }
  void renew(std::size_t member) {
    if (member == 0) {
      world_port_.renew();
    } else {
      agents_[member - 1]->port.renew();
    }
  }
  void wait() const {
    std::vector<pollfd> polled{{world_port_.wake_fd(), POLLIN, 0}};
    for (const auto& agent : agents_) polled.push_back({agent->port.wake_fd(), POLLIN, 0});
    ::poll(polled.data(), polled.size(), 20);
  }

  std::vector<AgentId> ids_;
  bus::DdsWorldPort world_port_;
  WorldSession world_;
  std::vector<std::unique_ptr<Agent>> agents_;
  std::size_t renewals_ = 0;
};

void expect_as_undisturbed(const Scenario& scenario, std::uint32_t period, std::size_t least_renewals) {
  eprosima::fastrtps::LibrarySettingsAttributes settings;
  settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
  eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
  std::uint64_t hash = 0;
  TopicCounts counts;
  InProcessOptions options;
  options.on_round = [&](const WorldSession& session) {
    hash = session.run().state_hash();
    counts = session.topics();
  };
  const InProcessResult alone = run_in_process(scenario, options);
  DdsRun over_dds(scenario);
  over_dds.run(period);
  const WorldSession& world = over_dds.world();
  ASSERT_EQ(world.state(), WorldSession::State::Done) << "at round " << world.run().rounds();
  EXPECT_EQ(world.start_failure(), "");
  EXPECT_EQ(world.outcome().exit_code, alone.exit_code) << world.outcome().reason;
  EXPECT_EQ(world.run().state_hash(), hash);
  EXPECT_TRUE(world.run().changes().empty());
  EXPECT_EQ(world.topics().representative.samples, counts.representative.samples);
  EXPECT_EQ(world.topics().obstacle_map.samples, counts.obstacle_map.samples);
  EXPECT_GE(over_dds.renewals(), least_renewals);
}

TEST(Renewal, OfEachInTurnLeavesNoTraceInAPlanAndItsFlight) {
  expect_as_undisturbed(scenario("tests/data/small.yaml", {{"planner.generations", "20"}}), 29, 7);
}

TEST(Renewal, OfEachInTurnLeavesNoTraceInATransitWithSharedMaps) {
  expect_as_undisturbed(scenario("deploy/scenarios/transit-partition.yaml", {}), 3, 7);
}

}  // namespace
}  // namespace skein
