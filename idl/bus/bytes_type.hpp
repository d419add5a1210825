// Any type of the topic table as its bytes: what DDS carries, with the 4 bytes of encapsulation. Internal to idl/bus.
//
// The key is read where all keyed types have it: `agent`, right after the header.
#pragma once

#include <algorithm>
#include <cstdint>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <functional>
#include <string>
#include <vector>

#include "idl/bus/topics.hpp"

namespace skein::bus {

class BytesType final : public eprosima::fastdds::dds::TopicDataType {
  using SerializedPayload = eprosima::fastrtps::rtps::SerializedPayload_t;

 public:
  using Payload = std::vector<std::uint8_t>;
  static constexpr std::uint32_t kLargest = 1U << 18;  ///< bytes of any sample; more than the bounds of idl/msg allow

  explicit BytesType(const TopicSpec& spec) {
    setName(std::string(spec.type).c_str());
    m_typeSize = kLargest;
    m_isGetKeyDefined = spec.keyed;
  }

  bool serialize(void* data, SerializedPayload* payload) override {
    const Payload& bytes = *static_cast<const Payload*>(data);
    if (bytes.size() < kEncapsulation || bytes.size() > payload->max_size) return false;
    std::copy(bytes.begin(), bytes.end(), payload->data);
    payload->encapsulation = is_little(bytes) ? CDR_LE : CDR_BE;
    payload->length = static_cast<std::uint32_t>(bytes.size());
    return true;
  }
  bool deserialize(SerializedPayload* payload, void* data) override {
    static_cast<Payload*>(data)->assign(payload->data, payload->data + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<const Payload*>(data)->size()); };
  }
  void* createData() override { return new Payload(); }
  void deleteData(void* data) override { delete static_cast<Payload*>(data); }

  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool) override {
    const Payload& payload = *static_cast<Payload*>(data);
    if (payload.size() < kKeyAt + kKeySize) return false;
    for (unsigned i = 0; i < 16; ++i) {
      const std::size_t byte = is_little(payload) ? kKeySize - 1 - i : i;
      handle->value[i] = i < kKeySize ? payload[kKeyAt + byte] : std::uint8_t{0};
    }
    return true;
  }

 private:
  static constexpr std::size_t kEncapsulation = 4;
  static constexpr std::size_t kKeyAt = kEncapsulation + 24;  ///< after the header
  static constexpr std::size_t kKeySize = 4;

  static bool is_little(const Payload& payload) { return payload[1] == 1; }
};

}  // namespace skein::bus
