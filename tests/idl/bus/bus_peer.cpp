// The other process of dds_process_test: an agent that answers each tick with what it has seen so far.
//
// idl_bus_peer DOMAIN SWARM ID NONCE. When its matches change, or a mission or sense sample arrives, it says so in an
// open beacon; it ends with 0 after a tick of phase Finished, with 1 if none comes within 60 s. In its beacons `step`
// counts missions, `generation` sense samples, `state_hash` ticks out of order.
#include <poll.h>

#include <chrono>
#include <cstdlib>

#include "idl/bus/dds_port.hpp"
#include "tests/idl/convert/examples.hpp"

namespace {

using namespace skein;

class Peer {
 public:
  explicit Peer(const bus::DdsConfig& config) : config_(config), port_(config) {}

  int run() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!finished_ && std::chrono::steady_clock::now() < end) {
      pollfd polled{port_.wake_fd(), POLLIN, 0};
      ::poll(&polled, 1, 100);
      std::vector<bus::AgentInbound> arrived;
      port_.take(arrived);
      for (const bus::AgentInbound& sample : arrived) {
        std::visit([this](const auto& held) { handle(held); }, sample);
      }
      if (port_.matched() != said_matched_) answer(0);
    }
    return finished_ && port_.flush(std::chrono::seconds(10)) ? 0 : 1;
  }

 private:
  void handle(const wire::Mission& mission) {
    missions_ += from_wire(mission, {}).ok() ? 1 : 0;
    answer(0);
  }
  void handle(const wire::Sense&) {
    ++senses_;
    answer(0);
  }
  void handle(const wire::Representative&) {}
  void handle(const wire::ObstacleMap&) {}
  void handle(const wire::Tick& tick) {
    if (tick.round() != last_round_ + 1) ++disorder_;
    last_round_ = tick.round();
    finished_ = from_wire(tick, {}).value().phase == Phase::Finished;
    answer(tick.round());
  }

  void answer(std::uint32_t round) {
    said_matched_ = port_.matched();
    Beacon beacon;
    beacon.agent = config_.id;
    beacon.nonce = config_.nonce;
    beacon.round = round;
    beacon.closes_round = round > 0;
    beacon.matched = said_matched_;
    beacon.step = missions_;
    beacon.generation = senses_;
    beacon.state_hash = disorder_;
    port_.publish(to_wire(beacon, {}));
  }

  bus::DdsConfig config_;
  bus::DdsAgentPort port_;
  std::vector<std::uint64_t> said_matched_;
  std::uint32_t missions_ = 0;
  std::uint32_t senses_ = 0;
  std::uint32_t last_round_ = 0;
  std::uint64_t disorder_ = 0;
  bool finished_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  bus::DdsConfig config;
  config.domain = static_cast<std::uint32_t>(std::strtoul(argv[1], nullptr, 10));
  config.swarm = argv[2];
  config.id = static_cast<AgentId>(std::strtoul(argv[3], nullptr, 10));
  config.nonce = std::strtoull(argv[4], nullptr, 10);
  config.lease_s = 2.0;
  return Peer(config).run();
}
