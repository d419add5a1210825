// One DDS participant with its topics, publishers and subscribers; all end with it. Internal to idl/bus.
#pragma once

#include <chrono>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <string>
#include <utility>
#include <vector>

#include "idl/bus/dds_qos.hpp"
#include "idl/bus/inbox.hpp"
#include "idl/bus/peer_book.hpp"

namespace skein::bus {

/// Seconds of the steady clock.
[[nodiscard]] double monotonic_s();

[[nodiscard]] ProcessKey process_key(const eprosima::fastrtps::rtps::GUID_t& guid);

/// Where agent K's sense topic is: `<swarm>/sense/K`.
[[nodiscard]] std::string sense_partition(const std::string& swarm, AgentId agent);

/// What is left of a time limit, in seconds.
class Deadline {
 public:
  explicit Deadline(std::chrono::milliseconds limit) : end_(std::chrono::steady_clock::now() + limit) {}
  [[nodiscard]] double left_s() const {
    const std::chrono::duration<double> left = end_ - std::chrono::steady_clock::now();
    return left.count() > 0.0 ? left.count() : 0.0;
  }

 private:
  std::chrono::steady_clock::time_point end_;
};

class Participant {
 public:
  /// Tells `book` of processes and endpoints that come and go, and rings `wake` then; both must outlive it.
  /// @param partitions those that this process has endpoints in; endpoints in others are not its counterparts
  /// @throws std::invalid_argument, std::runtime_error as DdsAgentPort does.
  Participant(const DdsConfig& config, std::vector<std::string> partitions, PeerBook& book, const Wake& wake);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// The topic of the table, made on first use.
  [[nodiscard]] fdds::Topic* topic(const TopicSpec& spec, const fdds::TypeSupport& type);
  /// A new group of endpoints in one partition.
  [[nodiscard]] fdds::Publisher* publisher(const std::string& partition);
  [[nodiscard]] fdds::Subscriber* subscriber(const std::string& partition);

  [[nodiscard]] ProcessKey key() const { return process_key(participant_->guid()); }

 private:
  class Listener final : public fdds::DomainParticipantListener {
   public:
    Listener(std::vector<std::string> partitions, PeerBook& book, const Wake& wake)
        : partitions_(std::move(partitions)), book_(book), wake_(wake) {}
    void on_participant_discovery(fdds::DomainParticipant*,
                                  eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
    void on_subscriber_discovery(fdds::DomainParticipant*,
                                 eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;
    void on_publisher_discovery(fdds::DomainParticipant*,
                                eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;

   private:
    template <typename Endpoint>
    void note(const Endpoint& endpoint, bool own_writes, bool is_there);

    const std::vector<std::string> partitions_;
    PeerBook& book_;
    const Wake& wake_;
  };

  Listener listener_;
  fdds::DomainParticipant* participant_ = nullptr;
};

}  // namespace skein::bus
