// Wire structs to CDR bytes (little endian, with the 4-byte encapsulation) and back, as DDS carries them.
#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/exceptions/Exception.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace skein::testing {

using Bytes = std::vector<std::uint8_t>;

template <typename Wire>
Bytes encode(const Wire& sample) {
  using eprosima::fastcdr::Cdr;
  Bytes bytes(Wire::getCdrSerializedSize(sample) + 4);
  eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
  Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  sample.serialize(cdr);
  bytes.resize(cdr.getSerializedDataLength());
  return bytes;
}

/// Nothing if the bytes are no sample.
template <typename Wire>
std::optional<Wire> decode(Bytes bytes) {
  using eprosima::fastcdr::Cdr;
  eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
  Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
  try {
    cdr.read_encapsulation();
    Wire sample;
    sample.deserialize(cdr);
    return sample;
  } catch (const eprosima::fastcdr::exception::Exception&) {
    return std::nullopt;
  }
}

}  // namespace skein::testing
