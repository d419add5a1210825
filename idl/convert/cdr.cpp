#include "idl/convert/cdr.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/exceptions/Exception.h>

namespace skein {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

constexpr std::size_t kEncapsulation = 4;

}  // namespace

template <typename Wire>
Bytes to_cdr(const Wire& sample) {
  Bytes bytes(Wire::getCdrSerializedSize(sample) + kEncapsulation);
  FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
  Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  sample.serialize(cdr);
  bytes.resize(cdr.getSerializedDataLength());
  return bytes;
}

template <typename Wire>
std::optional<Wire> from_cdr(std::span<const std::uint8_t> bytes) {
  Bytes copy(bytes.begin(), bytes.end());  // Fast CDR reads from what it could write to
  FastBuffer buffer(reinterpret_cast<char*>(copy.data()), copy.size());
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

template Bytes to_cdr(const wire::Mission&);
template Bytes to_cdr(const wire::Tick&);
template Bytes to_cdr(const wire::Sense&);
template Bytes to_cdr(const wire::Representative&);
template Bytes to_cdr(const wire::ObstacleMap&);
template Bytes to_cdr(const wire::Beacon&);
template Bytes to_cdr(const wire::Command&);
template Bytes to_cdr(const wire::Inject&);
template std::optional<wire::Mission> from_cdr(std::span<const std::uint8_t>);
template std::optional<wire::Tick> from_cdr(std::span<const std::uint8_t>);
template std::optional<wire::Sense> from_cdr(std::span<const std::uint8_t>);
template std::optional<wire::Representative> from_cdr(std::span<const std::uint8_t>);
template std::optional<wire::ObstacleMap> from_cdr(std::span<const std::uint8_t>);
template std::optional<wire::Beacon> from_cdr(std::span<const std::uint8_t>);
template std::optional<wire::Command> from_cdr(std::span<const std::uint8_t>);
template std::optional<wire::Inject> from_cdr(std::span<const std::uint8_t>);

}  // namespace skein
