// usage: skein_cyclone_listener DOMAIN SWARM
//   Joins a swarm's partitions as a program of another vendor would, by Cyclone DDS alone: nothing of Skein but its
//   IDL, topic names and partitions (docs/wire.md). Reads best effort, but for the latched mission. Says `listening` on
//   standard error when its readers are there and `heard TOPIC` with the first sample of each, and when the run's last
//   tick has come prints every sample that it heard, one JSON object a line. Exit code 0; 1 without a last tick within
//   60 s.
#include <dds/dds.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/cyclone/fields.hpp"

namespace skein::cyclone {
namespace {

constexpr std::uint8_t kFinished = 3;  ///< phase of a tick: the last
constexpr std::int32_t kDepth = 256;
constexpr std::uint32_t kBatch = 64;
constexpr auto kLimit = std::chrono::seconds(60);
constexpr auto kRest = std::chrono::milliseconds(500);  ///< for what is still on its way when the last tick has come

dds_entity_t require(dds_entity_t entity, const char* what) {
  if (entity < 0) throw std::runtime_error(std::string(what) + ": " + dds_strretcode(-entity));
  return entity;
}

struct Topic {
  const char* name;
  const dds_topic_descriptor_t* type;
  bool latched;
  bool per_agent;
  Json (*fields)(const void* sample);
};

template <typename Sample>
Json fields_of(const void* sample) {
  return *static_cast<const Sample*>(sample);
}

const std::array<Topic, 8> kTopics{{
    {"skein/mission", &skein_v7_Mission_desc, true, false, fields_of<skein_v7_Mission>},
    {"skein/tick", &skein_v7_Tick_desc, false, false, fields_of<skein_v7_Tick>},
    {"skein/sense", &skein_v7_Sense_desc, false, true, fields_of<skein_v7_Sense>},
    {"skein/beacon", &skein_v7_Beacon_desc, false, false, fields_of<skein_v7_Beacon>},
    {"skein/representative", &skein_v7_Representative_desc, false, false, fields_of<skein_v7_Representative>},
    {"skein/obstacle_map", &skein_v7_ObstacleMap_desc, false, false, fields_of<skein_v7_ObstacleMap>},
    {"skein/command", &skein_v7_Command_desc, false, false, fields_of<skein_v7_Command>},
    {"skein/inject", &skein_v7_Inject_desc, false, false, fields_of<skein_v7_Inject>},
}};

dds_entity_t make_reader(dds_entity_t participant, const std::string& swarm, const Topic& topic) {
  const dds_entity_t described =
      require(dds_create_topic(participant, topic.type, topic.name, nullptr, nullptr), topic.name);
  dds_qos_t* qos = dds_create_qos();
  const std::string partition = topic.per_agent ? swarm + "/sense/*" : swarm;
  const char* const partitions = partition.c_str();
  dds_qset_partition(qos, 1, const_cast<const char**>(&partitions));
  const dds_entity_t subscriber = require(dds_create_subscriber(participant, qos, nullptr), "subscriber");
  dds_reset_qos(qos);
  dds_qset_reliability(qos, topic.latched ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, DDS_SECS(1));
  dds_qset_durability(qos, topic.latched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, topic.latched ? 1 : kDepth);
  const dds_entity_t reader = require(dds_create_reader(subscriber, described, qos, nullptr), "reader");
  dds_delete_qos(qos);
  return reader;
}

class Listener {
 public:
  Listener(dds_domainid_t domain, const std::string& swarm)
      : participant_(require(dds_create_participant(domain, nullptr, nullptr), "participant")),
        waiting_(require(dds_create_waitset(participant_), "waitset")) {
    for (std::size_t i = 0; i < kTopics.size(); ++i) {
      readers_[i] = make_reader(participant_, swarm, kTopics[i]);
      const dds_entity_t unread = require(dds_create_readcondition(readers_[i], DDS_ANY_STATE), "condition");
      require(dds_waitset_attach(waiting_, unread, static_cast<dds_attach_t>(i)), "attach");
    }
  }
  ~Listener() { dds_delete(participant_); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// Takes what comes. @return whether the last tick did
  bool run() {
    using Clock = std::chrono::steady_clock;
    Clock::time_point end = Clock::now() + kLimit;
    bool ending = false;
    while (Clock::now() < end) {
      std::array<dds_attach_t, kTopics.size()> ready{};
      dds_waitset_wait(waiting_, ready.data(), ready.size(), DDS_MSECS(100));
      for (std::size_t i = 0; i < kTopics.size(); ++i) take(i);
      if (finished_ && !std::exchange(ending, true)) end = Clock::now() + kRest;
    }
    return finished_;
  }
  [[nodiscard]] const std::vector<Json>& heard() const { return heard_; }

 private:
  void take(std::size_t index) {
    std::array<void*, kBatch> samples{};  // null: lent
    std::array<dds_sample_info_t, kBatch> infos{};
    const dds_return_t count = dds_take(readers_[index], samples.data(), infos.data(), kBatch, kBatch);
    require(count, "take");
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      if (!infos[i].valid_data) continue;
      if (!std::exchange(said_[index], true)) std::cerr << "heard " << kTopics[index].name << std::endl;
      heard_.push_back({{"topic", kTopics[index].name}, {"sample", kTopics[index].fields(samples[i])}});
      if (kTopics[index].type != &skein_v7_Tick_desc) continue;
      finished_ = finished_ || static_cast<const skein_v7_Tick*>(samples[i])->phase == kFinished;
    }
    if (count > 0) require(dds_return_loan(readers_[index], samples.data(), count), "loan");
  }

  dds_entity_t participant_;
  dds_entity_t waiting_;
  std::array<dds_entity_t, kTopics.size()> readers_{};
  std::vector<Json> heard_;
  std::array<bool, kTopics.size()> said_{};
  bool finished_ = false;
};

int listen(dds_domainid_t domain, const std::string& swarm) {
  Listener listener(domain, swarm);
  std::cerr << "listening\n";
  const bool finished = listener.run();
  for (const Json& sample : listener.heard()) std::cout << sample.dump() << "\n";
  return finished && std::cout.flush() ? 0 : 1;
}

}  // namespace
}  // namespace skein::cyclone

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    return skein::cyclone::listen(static_cast<dds_domainid_t>(std::strtoul(argv[1], nullptr, 10)), argv[2]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
