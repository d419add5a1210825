// Typed writers and readers, usable once constructed, gone with their scope. Internal to idl/bus.
//
// Both report their matches to the PeerBook; a reader drains itself into an inbox from the thread of DDS that delivers.
// Departs from the generated types: reading never throws (the stock code lets a bad boolean escape into the thread
// of DDS) and the key is computed without the shared buffer, which is not safe between writer and reader.
#pragma once

#include <fastcdr/exceptions/Exception.h>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "idl/bus/dds_participant.hpp"
#include "idl/msg/beaconPubSubTypes.h"
#include "idl/msg/commandPubSubTypes.h"
#include "idl/msg/injectPubSubTypes.h"
#include "idl/msg/missionPubSubTypes.h"
#include "idl/msg/obstacle_mapPubSubTypes.h"
#include "idl/msg/representativePubSubTypes.h"
#include "idl/msg/sensePubSubTypes.h"
#include "idl/msg/tickPubSubTypes.h"

namespace skein::bus {

template <typename Sample>
struct Carried;
template <>
struct Carried<wire::Mission> {
  using Type = v7::MissionPubSubType;
  static constexpr TopicId kTopic = TopicId::Mission;
};
template <>
struct Carried<wire::Tick> {
  using Type = v7::TickPubSubType;
  static constexpr TopicId kTopic = TopicId::Tick;
};
template <>
struct Carried<wire::Sense> {
  using Type = v7::SensePubSubType;
  static constexpr TopicId kTopic = TopicId::Sense;
};
template <>
struct Carried<wire::Beacon> {
  using Type = v7::BeaconPubSubType;
  static constexpr TopicId kTopic = TopicId::Beacon;
};
template <>
struct Carried<wire::Representative> {
  using Type = v7::RepresentativePubSubType;
  static constexpr TopicId kTopic = TopicId::Representative;
};

template <>
struct Carried<wire::ObstacleMap> {
  using Type = v7::ObstacleMapPubSubType;
  static constexpr TopicId kTopic = TopicId::ObstacleMap;
};
template <>
struct Carried<wire::Command> {
  using Type = v7::CommandPubSubType;
  static constexpr TopicId kTopic = TopicId::Command;
};
template <>
struct Carried<wire::Inject> {
  using Type = v7::InjectPubSubType;
  static constexpr TopicId kTopic = TopicId::Inject;
};

template <typename Sample>
class GuardedType final : public Carried<Sample>::Type {
  using Base = typename Carried<Sample>::Type;

 public:
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
    try {
      return Base::deserialize(payload, data);
    } catch (const eprosima::fastcdr::exception::Exception&) {
      return false;
    }
  }

  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool force_md5) override {
    if constexpr (requires(const Sample& sample) { sample.agent(); }) {
      if (force_md5) return Base::getKey(data, handle, force_md5);
      const std::uint32_t agent = static_cast<const Sample*>(data)->agent();
      for (unsigned i = 0; i < 16; ++i) {
        handle->value[i] = i < 4 ? static_cast<std::uint8_t>(agent >> (24 - 8 * i)) : std::uint8_t{0};
      }
      return true;
    } else {
      return Base::getKey(data, handle, force_md5);
    }
  }
};

template <typename Sample>
fdds::Topic* topic_of(Participant& participant) {
  return participant.topic(topic(Carried<Sample>::kTopic), fdds::TypeSupport(new GuardedType<Sample>()));
}

template <typename Sample>
class Writer final : private fdds::DataWriterListener {
 public:
  Writer(Participant& participant, fdds::Publisher* publisher, PeerBook& book, const Wake& wake)
      : own_(participant.key()), publisher_(publisher), book_(book), wake_(wake) {
    fdds::DataWriterQos qos = publisher->get_default_datawriter_qos();
    apply(topic(kTopic), qos);
    writer_ =
        publisher->create_datawriter(topic_of<Sample>(participant), qos, this, fdds::StatusMask::publication_matched());
    if (writer_ == nullptr) throw std::runtime_error("DDS cannot make a writer of " + std::string(topic(kTopic).name));
  }
  ~Writer() override {
    writer_->set_listener(nullptr);
    publisher_->delete_datawriter(writer_);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// False if DDS did not accept the sample.
  [[nodiscard]] bool write(const Sample& sample) {
    return writer_->write(const_cast<Sample*>(&sample));  // write() only reads it
  }
  [[nodiscard]] bool flush(double limit_s) {
    return writer_->wait_for_acknowledgments(eprosima::fastrtps::Duration_t(limit_s)) ==
           eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK;
  }

 private:
  static constexpr TopicId kTopic = Carried<Sample>::kTopic;

  void on_publication_matched(fdds::DataWriter*, const fdds::PublicationMatchedStatus& status) override {
    const ProcessKey process = process_key(eprosima::fastrtps::rtps::iHandle2GUID(status.last_subscription_handle));
    if (process == own_ || status.current_count_change < 0) return;  // who goes is told by discovery
    book_.matched(process, endpoint_bit(kTopic, true));
    wake_.ring();
  }

  const ProcessKey own_;
  fdds::Publisher* publisher_;
  PeerBook& book_;
  const Wake& wake_;
  fdds::DataWriter* writer_ = nullptr;
};

template <typename Sample, typename Inbound>
class Reader final : private fdds::DataReaderListener {
 public:
  Reader(Participant& participant, fdds::Subscriber* subscriber, PeerBook& book, const Wake& wake,
         Inbox<Inbound>& inbox, Ring ring)
      : own_(participant.key()), subscriber_(subscriber), book_(book), wake_(wake), inbox_(inbox), ring_(ring) {
    fdds::DataReaderQos qos = subscriber->get_default_datareader_qos();
    apply(topic(kTopic), qos);
    // an observer that hangs must not slow a swarm; what is latched is sent once, and would else be missed
    if (book.own().role == Role::Observer && !topic(kTopic).latched) {
      qos.reliability().kind = fdds::BEST_EFFORT_RELIABILITY_QOS;
    }
    reader_ =
        subscriber->create_datareader(topic_of<Sample>(participant), qos, this,
                                      fdds::StatusMask::subscription_matched() << fdds::StatusMask::data_available());
    if (reader_ == nullptr) throw std::runtime_error("DDS cannot make a reader of " + std::string(topic(kTopic).name));
  }
  ~Reader() override {
    reader_->set_listener(nullptr);
    subscriber_->delete_datareader(reader_);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

 private:
  static constexpr TopicId kTopic = Carried<Sample>::kTopic;

  void on_data_available(fdds::DataReader* reader) override {
    Sample sample;
    fdds::SampleInfo info;
    std::uint64_t unread = reader->get_unread_count();
    while (unread > 0) {
      const bool taken =
          reader->take_next_sample(&sample, &info) == eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK;
      // a process hears its own writer too; nobody needs its own samples
      if (taken && info.valid_data && process_key(info.sample_identity.writer_guid()) != own_) {
        inbox_.put(std::move(sample), ring_);
      }
      if (taken && --unread == 0) return;  // what came meanwhile has a notice of its own
      sample = Sample();
      if (taken) continue;
      // Bytes that are no sample end a take as if there were none left; what follows them would wait for the next.
      const std::uint64_t left = reader->get_unread_count();
      if (left >= unread) break;
      unread = left;
    }
  }

  void on_subscription_matched(fdds::DataReader*, const fdds::SubscriptionMatchedStatus& status) override {
    const ProcessKey process = process_key(eprosima::fastrtps::rtps::iHandle2GUID(status.last_publication_handle));
    if (process == own_ || status.current_count_change < 0) return;  // who goes is told by discovery
    book_.matched(process, endpoint_bit(kTopic, false));
    wake_.ring();
  }

  const ProcessKey own_;
  fdds::Subscriber* subscriber_;
  PeerBook& book_;
  const Wake& wake_;
  Inbox<Inbound>& inbox_;
  const Ring ring_;
  fdds::DataReader* reader_ = nullptr;
};

}  // namespace skein::bus
