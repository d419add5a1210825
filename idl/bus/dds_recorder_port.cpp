#include "idl/bus/dds_recorder_port.hpp"

#include <algorithm>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "idl/bus/bytes_type.hpp"
#include "idl/bus/dds_participant.hpp"

namespace skein::bus {
namespace {

namespace rtps = eprosima::fastrtps::rtps;
WriterKey key_of(const rtps::GUID_t& guid) {
  WriterKey key;
  const auto end = std::copy_n(guid.guidPrefix.value, rtps::GuidPrefix_t::size, key.begin());
  std::copy_n(guid.entityId.value, rtps::EntityId_t::size, end);
  return key;
}

class BytesReader final : private fdds::DataReaderListener {
 public:
  BytesReader(Participant& participant, fdds::Subscriber* subscriber, const TopicSpec& spec, bool reliable,
              Inbox<RawSample>& inbox)
      : subscriber_(subscriber), topic_(spec.id), inbox_(inbox) {
    fdds::DataReaderQos qos = subscriber->get_default_datareader_qos();
    apply(spec, qos);
    if (!reliable && !spec.latched) qos.reliability().kind = fdds::BEST_EFFORT_RELIABILITY_QOS;
    fdds::Topic* topic = participant.topic(spec, fdds::TypeSupport(new BytesType(spec)));
    reader_ = subscriber->create_datareader(topic, qos, this, fdds::StatusMask::data_available());
    if (reader_ == nullptr) throw std::runtime_error("DDS cannot make a reader of " + std::string(spec.name));
  }
  ~BytesReader() override {
    reader_->set_listener(nullptr);
    subscriber_->delete_datareader(reader_);
  }
  BytesReader(const BytesReader&) = delete;
  BytesReader& operator=(const BytesReader&) = delete;

 private:
  void on_data_available(fdds::DataReader* reader) override {
    fdds::SampleInfo info;
    for (std::uint64_t unread = reader->get_unread_count(); unread > 0; --unread) {
      RawSample sample;
      const auto taken = reader->take_next_sample(&sample.payload, &info);
      if (taken != eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) return;
      if (!info.valid_data) continue;
      sample.topic = topic_;
      sample.writer = key_of(info.sample_identity.writer_guid());
      sample.sequence = info.sample_identity.sequence_number().to64long();
      inbox_.put(std::move(sample), Ring::Now);
    }
  }

  fdds::Subscriber* subscriber_;
  const TopicId topic_;
  Inbox<RawSample>& inbox_;
  fdds::DataReader* reader_ = nullptr;
};

PeerInfo observer(const DdsConfig& config) {
  return {Role::Observer, config.swarm, kWorldId, config.nonce, config.wire_version, config.start_stamp_ns};
}

/// The swarm's own, and each agent's for what it senses: partitions of readers expand wildcards.
std::vector<std::string> all_partitions(const std::string& swarm) {
  return {swarm, swarm + "/sense/*"};
}

// Members end in the opposite order: readers, then the participant.
struct Readers {
  Readers(const DdsConfig& config, bool reliable, PeerBook& book, const Wake& wake, Inbox<RawSample>& inbox)
      : participant(config, all_partitions(config.swarm), book, wake),
        subscriber(participant.subscriber(all_partitions(config.swarm))) {
    for (const TopicSpec& spec : kTopics) {
      all.push_back(std::make_unique<BytesReader>(participant, subscriber, spec, reliable, inbox));
    }
  }

  Participant participant;
  fdds::Subscriber* subscriber;
  std::vector<std::unique_ptr<BytesReader>> all;
};

}  // namespace

// Members end in the opposite order: what is on the bus, then what its listeners use.
struct DdsRecorderPort::Impl {
  Impl(const DdsConfig& own_config, RecorderReads reads)
      : config(own_config), reliable(reads.reliable), book(observer(config)), inbox(reads.inbox, wake) {
    join();
  }
  void join() { bus.emplace(config, reliable, book, wake, inbox); }

  const DdsConfig config;
  const bool reliable;
  Wake wake;
  PeerBook book;
  Inbox<RawSample> inbox;
  std::optional<Readers> bus;
};

DdsRecorderPort::DdsRecorderPort(const DdsConfig& config, RecorderReads reads)
    : impl_(std::make_unique<Impl>(config, reads)) {}
DdsRecorderPort::~DdsRecorderPort() = default;

void DdsRecorderPort::take(std::vector<RawSample>& into) {
  impl_->inbox.drain(into);
}

void DdsRecorderPort::renew() {
  impl_->bus.reset();
  impl_->book.renew();
  impl_->join();
  impl_->wake.ring();
}

int DdsRecorderPort::wake_fd() const {
  return impl_->wake.fd();
}

bool DdsRecorderPort::has_world() const {
  return std::ranges::binary_search(impl_->book.swarms(true), impl_->book.own().swarm);
}

}  // namespace skein::bus
