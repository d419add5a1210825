#include "tests/groundstation/mcap/files.hpp"

#include "planner/core/random/random_stream.hpp"

namespace skein::mcap::tests {
namespace {

Bytes random_bytes(RandomStream& random, std::size_t size) {
  Bytes bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(4));  // so that zstd has something
  return bytes;
}

Held held(const Message& message) {
  return {message.channel_id, message.sequence, message.log_time, message.publish_time,
          Bytes(message.data.begin(), message.data.end())};
}

}  // namespace

Written random_file(std::uint64_t seed, std::size_t messages, bool compressed) {
  RandomStream random(seed, 0, Purpose::Test, 0);
  Written written;
  const auto sink = [&](ByteView bytes) { written.file.insert(written.file.end(), bytes.begin(), bytes.end()); };
  Writer writer(sink, {"skein test", 300 + random.below(300), compressed});
  written.attachment = {1, 2, "scenario.yaml", "application/yaml", random_bytes(random, random.below(200)), 0};
  writer.attach(written.attachment);
  const std::size_t channels = 1 + random.below(4);
  for (std::size_t i = 0; i < channels; ++i) {
    const std::string name = "type" + std::to_string(i);
    const std::uint16_t schema = writer.add_schema(name, "omgidl", random_bytes(random, random.below(40)));
    (void)writer.add_channel(schema, "topic" + std::to_string(i / 2), "cdr", {{"agent", std::to_string(i)}});
  }
  for (std::size_t i = 0; i < messages; ++i) {
    Held message{static_cast<std::uint16_t>(1 + random.below(channels)), static_cast<std::uint32_t>(i),
                 1000 + 10 * (i / 3) + random.below(15), random.next(), random_bytes(random, random.below(80))};
    writer.write({message.channel, message.sequence, message.log_time, message.publish_time, message.data});
    written.messages.push_back(std::move(message));
  }
  writer.flush();
  written.metadata = {"run", {{"seed", "7"}, {"swarm", "geese"}}};
  writer.add_metadata(written.metadata);
  writer.finish();
  return written;
}

std::vector<Held> messages_of(const Reader& reader) {
  std::vector<Held> messages;
  reader.for_each([&](const Message& message) { messages.push_back(held(message)); });
  return messages;
}

}  // namespace skein::mcap::tests
