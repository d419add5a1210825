#include "idl/bus/dds_replay_port.hpp"

#include <fastdds/dds/core/status/PublicationMatchedStatus.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <map>
#include <stdexcept>
#include <utility>

#include "idl/bus/bytes_type.hpp"
#include "idl/bus/dds_participant.hpp"

namespace skein::bus {
namespace {

class BytesWriter {
 public:
  BytesWriter(Participant& participant, fdds::Publisher* publisher, const TopicSpec& spec) : publisher_(publisher) {
    fdds::DataWriterQos qos = publisher->get_default_datawriter_qos();
    apply(spec, qos);
    writer_ = publisher->create_datawriter(participant.topic(spec, fdds::TypeSupport(new BytesType(spec))), qos);
    if (writer_ == nullptr) throw std::runtime_error("DDS cannot make a writer of " + std::string(spec.name));
  }
  ~BytesWriter() { publisher_->delete_datawriter(writer_); }
  BytesWriter(const BytesWriter&) = delete;
  BytesWriter& operator=(const BytesWriter&) = delete;

  [[nodiscard]] bool write(BytesType::Payload payload) { return writer_->write(&payload); }
  [[nodiscard]] std::uint32_t readers() const {
    fdds::PublicationMatchedStatus status;
    const auto told = writer_->get_publication_matched_status(status);
    return told == eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK
               ? static_cast<std::uint32_t>(status.current_count)
               : 0;
  }
  [[nodiscard]] bool flush(double limit_s) {
    return writer_->wait_for_acknowledgments(eprosima::fastrtps::Duration_t(limit_s)) ==
           eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK;
  }

 private:
  fdds::Publisher* publisher_;
  fdds::DataWriter* writer_ = nullptr;
};

PeerInfo in_place_of(Role role, const DdsConfig& config) {
  PeerInfo info{role, config.swarm, kWorldId, config.nonce, config.wire_version, config.start_stamp_ns};
  info.run = role == Role::World ? config.run : 0;
  return info;
}

/// Another process than the world's, to whoever counts processes by their nonces.
DdsConfig another(DdsConfig config) {
  ++config.nonce;
  return config;
}

/// Where the writer is: of the topics of each agent the agent counts.
ReplayWriter placed(ReplayWriter writer) {
  if (!topic(writer.topic).per_agent) writer.agent = kWorldId;
  return writer;
}

std::string partition_of(const std::string& swarm, const ReplayWriter& writer) {
  return topic(writer.topic).per_agent ? sense_partition(swarm, writer.agent) : swarm;
}

/// One process in the place of one or several. Members end in the opposite order: writers, then the participant.
struct Place {
  Place(Role role, const DdsConfig& config)
      : book(in_place_of(role, config)), bus(config, {config.swarm}, book, wake) {}

  Wake wake;
  PeerBook book;
  Participant bus;
  std::map<std::string, fdds::Publisher*> publishers;
  std::map<ReplayWriter, BytesWriter> writers;
};

}  // namespace

struct DdsReplayPort::Impl {
  explicit Impl(const DdsConfig& config) : world(Role::World, config), agents(Role::Observer, another(config)) {}

  void add(const std::string& swarm, const ReplayWriter& writer) {
    Place& place = writer.from_world ? world : agents;
    const std::string partition = partition_of(swarm, writer);
    if (!place.publishers.contains(partition)) place.publishers[partition] = place.bus.publisher(partition);
    place.writers.try_emplace(writer, place.bus, place.publishers[partition], topic(writer.topic));
  }

  Place world;
  Place agents;
};

DdsReplayPort::DdsReplayPort(const DdsConfig& config, std::span<const ReplayWriter> writers)
    : impl_(std::make_unique<Impl>(config)) {
  for (const ReplayWriter& writer : writers) impl_->add(config.swarm, placed(writer));
}
DdsReplayPort::~DdsReplayPort() = default;

bool DdsReplayPort::publish(ReplayWriter writer, std::span<const std::uint8_t> payload) {
  auto& writers = writer.from_world ? impl_->world.writers : impl_->agents.writers;
  const auto found = writers.find(placed(writer));
  return found != writers.end() && found->second.write({payload.begin(), payload.end()});
}

std::uint32_t DdsReplayPort::tick_readers() const {
  const auto found = impl_->world.writers.find({TopicId::Tick, true, kWorldId});
  return found == impl_->world.writers.end() ? 0 : found->second.readers();
}

std::uint32_t DdsReplayPort::readers() const {
  std::uint32_t readers = 0;
  for (const Place* place : {&impl_->world, &impl_->agents}) {
    for (const auto& [name, writer] : place->writers) readers += writer.readers();
  }
  return readers;
}

std::optional<std::string> DdsReplayPort::conflict() const {
  return impl_->world.book.conflict();
}

bool DdsReplayPort::flush(std::chrono::milliseconds limit) {
  const Deadline deadline(limit);
  for (Place* place : {&impl_->world, &impl_->agents}) {
    for (auto& [name, writer] : place->writers) {
      if (!writer.flush(deadline.left_s())) return false;
    }
  }
  return true;
}

}  // namespace skein::bus
