// skein dump FILE: the samples of a recording with all their fields, one JSON object a line.
#include <fmt/ranges.h>

#include <iostream>
#include <set>

#include "groundstation/cli/verbs.hpp"
#include "groundstation/mcap/file.hpp"
#include "groundstation/mcap/reader.hpp"
#include "groundstation/schema/decode.hpp"
#include "groundstation/schema/topics.hpp"

namespace skein {
namespace {

constexpr int kBad = 2;

struct DumpArguments {
  std::string file;
  std::string topic;
  bool json = false;  ///< nothing else is printed anyway
};

/// Decoded with the schema that the file itself carries.
class Decoder {
 public:
  explicit Decoder(const mcap::Contents& contents) : contents_(contents) {}

  std::optional<schema::Json> operator()(const mcap::Message& message) {
    const mcap::Channel& channel = contents_.channels.at(message.channel_id);
    if (!types_.contains(channel.schema_id)) {
      const mcap::Schema& schema = contents_.schemas.at(channel.schema_id);
      types_[channel.schema_id] = schema::parse_idl(std::string(schema.data.begin(), schema.data.end()), schema.name);
    }
    return schema::decode(types_[channel.schema_id], message.data);
  }

 private:
  const mcap::Contents& contents_;
  std::map<std::uint16_t, schema::Struct> types_;
};

/// @throws std::runtime_error with one line if there is no such topic in the file
void find_topic(const mcap::Contents& contents, const std::string& topic) {
  std::set<std::string> topics;
  for (const auto& [id, channel] : contents.channels) topics.insert(channel.topic);
  if (topic.empty() || topics.contains(topic)) return;
  throw std::runtime_error(fmt::format("--topic {}: it is not there; there are: {}", topic,
                                       topics.empty() ? "none" : fmt::to_string(fmt::join(topics, ", "))));
}

int dump(const DumpArguments& arguments) {
  try {
    const mcap::MappedFile file(arguments.file);
    const mcap::Reader reader(file.bytes());
    if (!reader.missing().empty()) std::cerr << fmt::format("{}: {}\n", arguments.file, reader.missing());
    find_topic(reader.contents(), arguments.topic);
    Decoder decode(reader.contents());
    reader.for_each([&](const mcap::Message& message) {
      const mcap::Channel& channel = reader.contents().channels.at(message.channel_id);
      if (!arguments.topic.empty() && channel.topic != arguments.topic) return;
      const auto fields = decode(message);
      const schema::Json line{{"topic", channel.topic},
                              {"writer", channel.metadata.contains("writer") ? channel.metadata.at("writer") : ""},
                              {"sequence", message.sequence},
                              {"log_time", std::to_string(message.log_time)},
                              {"publish_time", std::to_string(message.publish_time)},
                              {"sample", fields ? *fields : schema::Json()}};
      std::cout << line.dump() << "\n";
    });
    if (std::cout.flush()) return 0;
    throw std::runtime_error("cannot write to standard output");
  } catch (const std::exception& error) {
    const std::string what = error.what();
    const bool named = what.starts_with(arguments.file + ":");
    std::cerr << fmt::format("skein dump: {}\n", named ? what : arguments.file + ": " + what);
    return kBad;
  }
}

}  // namespace

VerbAction add_dump_verb(CLI::App& app) {
  auto arguments = std::make_shared<DumpArguments>();
  CLI::App* verb = app.add_subcommand("dump", "print the samples of a recording, one JSON object a line");
  verb->add_option("FILE", arguments->file, "recording")->required();
  verb->add_option("--topic", arguments->topic, "of this topic alone: skein/tick");
  verb->add_flag("--json", arguments->json, "what it prints in any case");
  verb->footer(
      "64-bit integers are texts, as in the JSON of protobuf.\nExample: skein dump run.mcap --topic skein/beacon");
  return [arguments] { return dump(*arguments); };
}

}  // namespace skein
