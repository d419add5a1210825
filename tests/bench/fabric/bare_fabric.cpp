// What plain Fast DDS makes of Skein's exchange: the same endpoints, QoS and samples, and nothing else.
//
// bare_fabric N [SECONDS] [DOMAIN] starts N agents, processes of their own as Skein's are, and is the world. Round: one
// tick to all, N representatives each to all others and the world, N beacons to the world; an agent answers a tick when
// it has the representatives of the round before. No planner, no checks, no repeats of what is lost, no state hash.
// Listeners count, and wake the main thread once a round is complete. Prints one JSON object: agents, discovery_s,
// rounds, rounds_per_s.
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <map>
#include <string>
#include <vector>

#include "idl/bus/dds_endpoint.hpp"
#include "idl/convert/convert.hpp"

namespace {

using namespace skein;
using namespace skein::bus;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kHello = 0;  // the round in which agents say that they are matched

/// What arrived, by round, and the main thread that waits for it.
struct Count {
  std::mutex mutex;
  std::condition_variable complete;
  std::uint32_t tick = 0;
  bool finished = false;
  std::map<std::uint32_t, std::size_t> representatives;
  std::map<std::uint32_t, std::size_t> beacons;
  std::size_t needed_representatives = 0;
  std::size_t needed_beacons = 0;
  std::uint32_t awaited = 0;  ///< the round that is waited for

  void add(const wire::Mission&) {}
  void add(const wire::Sense&) {}
  void add(const wire::ObstacleMap&) {}
  void add(const wire::Tick& sample) {
    tick = sample.round();
    finished = sample.phase() == static_cast<std::uint8_t>(Phase::Finished);
  }
  void add(const wire::Representative& sample) { ++representatives[sample.round()]; }
  void add(const wire::Beacon& sample) { ++beacons[sample.round()]; }

  [[nodiscard]] bool answerable() {
    return tick > awaited && (tick == 1 || representatives[tick - 1] >= needed_representatives || finished);
  }
  [[nodiscard]] bool closed() {
    return beacons[awaited] >= needed_beacons &&
           (awaited == kHello || representatives[awaited] >= needed_representatives);
  }
  void forget_before(std::uint32_t round) {
    representatives.erase(representatives.begin(), representatives.lower_bound(round));
    beacons.erase(beacons.begin(), beacons.lower_bound(round));
  }
};

template <typename Sample>
class CountingListener final : public fdds::DataReaderListener {
 public:
  CountingListener(Count& count, bool is_world, eprosima::fastrtps::rtps::GuidPrefix_t own)
      : count_(count), is_world_(is_world), own_(own) {}

  void on_data_available(fdds::DataReader* reader) override {
    fdds::SampleInfo info;
    while (reader->take_next_sample(&sample_, &info) == eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data || info.sample_identity.writer_guid().guidPrefix == own_) continue;
      const std::lock_guard lock(count_.mutex);
      count_.add(sample_);
      if (is_world_ ? count_.closed() : count_.answerable()) count_.complete.notify_one();
    }
  }

 private:
  Count& count_;
  bool is_world_;
  eprosima::fastrtps::rtps::GuidPrefix_t own_;
  Sample sample_;
};

/// A participant with plain endpoints of the topic table.
class Process {
 public:
  Process(unsigned domain, Role role, AgentId id)
      : swarm_("bare-" + std::to_string(role == Role::World ? getpid() : getppid())), role_(role) {
    DdsConfig config;
    config.domain = domain;
    config.swarm = swarm_;
    auto* factory = fdds::DomainParticipantFactory::get_instance();
    fdds::DomainParticipantQos qos = factory->get_default_participant_qos();
    apply(config, PeerInfo{role, swarm_, id, id + 1U, wire::kWireVersion, 0}, qos);
    participant_ = factory->create_participant(domain, qos);
    if (participant_ == nullptr) std::abort();
  }
  ~Process() {
    participant_->delete_contained_entities();
    fdds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  template <typename Sample>
  fdds::DataWriter* writer(const std::string& sub = "") {
    fdds::PublisherQos group = participant_->get_default_publisher_qos();
    group.partition().push_back((swarm_ + sub).c_str());
    fdds::Publisher* publisher = participant_->create_publisher(group);
    fdds::DataWriterQos qos = publisher->get_default_datawriter_qos();
    apply(bus::topic(Carried<Sample>::kTopic), qos);
    return publisher->create_datawriter(topic<Sample>(), qos);
  }
  template <typename Sample>
  fdds::DataReader* reader(Count& count, const std::string& sub = "") {
    fdds::SubscriberQos group = participant_->get_default_subscriber_qos();
    group.partition().push_back((swarm_ + sub).c_str());
    fdds::Subscriber* subscriber = participant_->create_subscriber(group);
    fdds::DataReaderQos qos = subscriber->get_default_datareader_qos();
    apply(bus::topic(Carried<Sample>::kTopic), qos);
    auto* listener = new CountingListener<Sample>(count, role_ == Role::World, participant_->guid().guidPrefix);
    return subscriber->create_datareader(topic<Sample>(), qos, listener, fdds::StatusMask::data_available());
  }

 private:
  template <typename Sample>
  fdds::Topic* topic() {
    const std::string name(bus::topic(Carried<Sample>::kTopic).name);
    if (auto* known = participant_->lookup_topicdescription(name)) return dynamic_cast<fdds::Topic*>(known);
    const fdds::TypeSupport type(new GuardedType<Sample>());
    type.register_type(participant_);
    return participant_->create_topic(name, type.get_type_name(), fdds::TOPIC_QOS_DEFAULT);
  }

  std::string swarm_;
  Role role_;
  fdds::DomainParticipant* participant_ = nullptr;
};

int matched(fdds::DataWriter* writer) {
  fdds::PublicationMatchedStatus status;
  writer->get_publication_matched_status(status);
  return status.current_count;
}

int matched(fdds::DataReader* reader) {
  fdds::SubscriptionMatchedStatus status;
  reader->get_subscription_matched_status(status);
  return status.current_count;
}

int agent(unsigned domain, AgentId id, std::size_t agents) {
  Count count;
  count.needed_representatives = agents - 1;
  Process process(domain, Role::Agent, id);
  const std::vector<fdds::DataReader*> of_world{process.reader<wire::Mission>(count), process.reader<wire::Tick>(count),
                                                process.reader<wire::Sense>(count, "/sense/" + std::to_string(id))};
  fdds::DataReader* representatives = process.reader<wire::Representative>(count);
  fdds::DataWriter* representative = process.writer<wire::Representative>();
  fdds::DataReader* maps = process.reader<wire::ObstacleMap>(count);  // not used in a rendezvous, but there
  fdds::DataWriter* map = process.writer<wire::ObstacleMap>();
  fdds::DataWriter* beacon = process.writer<wire::Beacon>();
  Representative mine;
  mine.agent = id;
  mine.incarnation = 1;
  mine.stage = PlanStage::Searching;
  mine.particle = {1.0, 2.0};
  Beacon closing;
  closing.agent = id;
  closing.incarnation = 1;
  wire::Representative representative_sample = to_wire(mine, {1, 1});
  wire::Beacon beacon_sample = to_wire(closing, {1, 1});
  const int all = static_cast<int>(agents) + 1;  // itself and the world included
  const auto is_matched = [&] {
    for (fdds::DataReader* reader : of_world) {
      if (matched(reader) < 1) return false;
    }
    return matched(representatives) >= all && matched(representative) >= all && matched(maps) >= all &&
           matched(map) >= all && matched(beacon) >= 1;
  };
  for (bool said = false;;) {
    std::unique_lock lock(count.mutex);
    if (!count.complete.wait_for(lock, std::chrono::milliseconds(20), [&] { return count.answerable(); })) {
      lock.unlock();
      if (count.tick == 0 && !said && is_matched()) said = beacon->write(&beacon_sample);
      if (getppid() == 1) return 1;
      continue;
    }
    if (count.finished) return 0;
    const std::uint32_t round = count.awaited = count.tick;
    count.forget_before(round);
    lock.unlock();
    representative_sample.round(round);
    beacon_sample.round(round);
    representative->write(&representative_sample);
    beacon->write(&beacon_sample);
  }
}

bool wait_closed(Count& count, std::chrono::seconds limit) {
  std::unique_lock lock(count.mutex);
  return count.complete.wait_for(lock, limit, [&] { return count.closed(); });
}

int world(unsigned domain, std::size_t agents, double seconds) {
  const auto created = Clock::now();
  Count count;
  count.needed_representatives = count.needed_beacons = agents;
  Process process(domain, Role::World, kWorldId);
  process.reader<wire::Beacon>(count);
  process.reader<wire::Representative>(count);
  process.writer<wire::Representative>();
  process.reader<wire::ObstacleMap>(count);
  process.writer<wire::ObstacleMap>();
  process.writer<wire::Mission>();
  fdds::DataWriter* tick = process.writer<wire::Tick>();
  Tick open;
  open.run = 1;
  open.phase = Phase::Planning;
  for (AgentId id = 1; id <= agents; ++id) {
    process.writer<wire::Sense>("/sense/" + std::to_string(id));
    open.roster.push_back({id, 1, id, true, false});
  }
  wire::Tick sample = to_wire(open, {1, 1});
  if (!wait_closed(count, std::chrono::seconds(120))) return 3;
  const auto start = Clock::now();
  const auto since = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  std::uint32_t round = 0;
  while (since() < seconds) {
    {
      const std::lock_guard lock(count.mutex);
      count.forget_before(++round);
      count.awaited = round;
    }
    sample.round(round);
    tick->write(&sample);
    if (!wait_closed(count, std::chrono::seconds(30))) return 4;
  }
  const double took_s = since();
  sample.round(round + 1);
  sample.phase(static_cast<std::uint8_t>(Phase::Finished));
  tick->write(&sample);
  tick->wait_for_acknowledgments(eprosima::fastrtps::Duration_t(5.0));
  std::printf("{\"agents\": %zu, \"discovery_s\": %.3f, \"rounds\": %u, \"rounds_per_s\": %.1f}\n", agents,
              std::chrono::duration<double>(start - created).count(), round, round / took_s);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t agents = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 0;
  const double seconds = argc > 2 ? std::strtod(argv[2], nullptr) : 2.0;
  const unsigned domain = argc > 3 ? static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10)) : 19;
  if (agents < 1 || agents > kMaxAgents || domain > 100) {
    std::fputs("bare_fabric N [SECONDS] [DOMAIN]\n", stderr);
    return 2;
  }
  if (argc > 4) return agent(domain, static_cast<AgentId>(std::strtoul(argv[4], nullptr, 10)), agents);
  for (AgentId id = 1; id <= agents; ++id) {
    const std::array<std::string, 3> words{std::to_string(agents), std::to_string(domain), std::to_string(id)};
    if (fork() != 0) continue;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    execl("/proc/self/exe", argv[0], words[0].c_str(), "0", words[1].c_str(), words[2].c_str(), nullptr);
    _exit(127);
  }
  int result = world(domain, agents, seconds);
  if (result != 0) std::_Exit(result);  // the agents die with it
  for (std::size_t i = 0; i < agents; ++i) {
    int status = 0;
    wait(&status);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) result = 1;
  }
  return result;
}
