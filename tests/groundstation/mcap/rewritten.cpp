#include "tests/groundstation/mcap/rewritten.hpp"

#include <map>

namespace skein::mcap::tests {

Bytes rewritten(ByteView file, const Change& change) {
  const Reader reader(file);
  const Contents& contents = reader.contents();
  Bytes out;
  Writer writer([&](ByteView bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); });
  std::map<std::uint16_t, std::uint16_t> schemas;
  std::map<std::uint16_t, std::uint16_t> channels;
  for (const auto& [id, schema] : contents.schemas) {
    schemas[id] = writer.add_schema(schema.name, schema.encoding, schema.data);
  }
  for (const auto& [id, channel] : contents.channels) {
    channels[id] =
        writer.add_channel(schemas.at(channel.schema_id), channel.topic, channel.message_encoding, channel.metadata);
  }
  for (const MetadataIndex& index : contents.metadata) writer.add_metadata(reader.metadata(index.name).value());
  for (const AttachmentIndex& index : contents.attachments) writer.attach(reader.attachment(index.name).value());
  std::size_t number = 0;
  reader.for_each([&](const Message& message) {
    Bytes payload(message.data.begin(), message.data.end());
    change(number++, contents.channels.at(message.channel_id).topic, payload);
    Message changed = message;
    changed.channel_id = channels.at(message.channel_id);
    changed.data = payload;
    writer.write(changed);
  });
  writer.finish();
  return out;
}

}  // namespace skein::mcap::tests
