// A recording of a run: the samples of the bus, as they are on the wire, in an MCAP file.
//
// A message is a sample's DDS payload (encoding `cdr`, schema encoding `omgidl`, the project's own IDL). A channel is a
// topic, a writer (world or agent) and, of keyed topics, the agent that it is about: what the world repeats of an agent
// is a channel of its own. sequence is the number that DDS gave the sample (in process: a count from 1), so that a gap
// in it is a loss; one channel of a process with several agents has gaps by nature.
//   log_time     = simulated time of the sample's round, in ns, plus the round's number in ns
//   publish_time = the sender's clock when it published (stamp_ns), monotonic, of its machine
// Departs from the field's practice (log_time = wall time of reception): runs go as fast as the machine can, so that
// wall time says nothing of a flight; a nanosecond a round keeps rounds in order while simulated time stands still.
// Metadata: `skein` (who recorded, versions), `skein.scenario` (hash, seed, overrides; beside the attached text),
// `skein.run` (id, seed, name: what the mission says), `skein.kept` (at the end: what was kept and lost).
// Source: https://mcap.dev/spec/registry. Departs from source: as said. Complexity: linear in the bytes.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "groundstation/mcap/writer.hpp"
#include "groundstation/record/sample_head.hpp"
#include "simworld/scenario/scenario.hpp"

namespace skein {

inline constexpr const char* kScenarioName = "scenario.yaml";
inline constexpr const char* kReportName = "report.json";

/// Who records, and of what.
struct RecordingOrigin {
  std::string recorder;                ///< "in-process", "barrier" (nothing can be missing), "attached" (best effort)
  std::string swarm;                   ///< empty in process
  const Scenario* scenario = nullptr;  ///< nullptr: not known
  bool fail_fast = false;
};

struct TakenSample {
  bus::TopicId topic = bus::TopicId::Tick;
  bool from_world = false;     ///< else from an agent
  std::uint64_t sequence = 0;  ///< of its DDS writer; 0: to be counted here
  std::span<const std::uint8_t> payload;
};

/// Where samples go.
using TakeSample = std::function<void(const TakenSample&)>;

class Recording {
 public:
  /// @throws what `sink` throws (all below)
  Recording(mcap::Writer::Sink sink, const RecordingOrigin& origin);

  /// Bytes that are no sample are counted and left out.
  void add(const TakenSample& sample);
  /// So that what was taken outlives this process.
  void flush() { writer_.flush(); }
  /// @param kept goes into the metadata; @param report is attached, unless it is null
  void finish(const mcap::Texts& kept, const nlohmann::ordered_json& report = nullptr);

  [[nodiscard]] std::uint64_t samples() const { return writer_.messages(); }
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  struct Known {
    std::uint16_t id = 0;
    std::uint32_t counted = 0;
  };
  using ChannelKey = std::tuple<bus::TopicId, bool, AgentId>;
  Known& channel(const TakenSample& sample, AgentId agent);
  void note_run(const TakenSample& sample, const SampleHead& head);
  void note_time(const TakenSample& sample, const SampleHead& head);
  [[nodiscard]] std::uint64_t time_of(std::uint32_t round) const;
  [[nodiscard]] std::uint32_t newest() const { return times_.empty() ? 0 : times_.rbegin()->first; }

  mcap::Writer writer_;
  std::map<bus::TopicId, std::uint16_t> schemas_;
  std::map<ChannelKey, Known> channels_;
  std::map<std::uint32_t, std::uint64_t> times_;  ///< ns of each round's tick
  std::optional<std::uint64_t> run_;
  std::uint64_t refused_ = 0;
};

}  // namespace skein
