#include "simworld/checkpoint/checkpoint.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "simworld/checkpoint/round_record.hpp"

namespace skein {
namespace {

enum Kind : std::uint32_t { kOwner = 1, kRound = 2, kFault = 3, kRestart = 4, kEnd = 5, kBroken = 6 };

constexpr const char* kFile = "/journal";

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string text_of_bytes(std::span<const std::uint8_t> bytes) {
  return {bytes.begin(), bytes.end()};
}

nlohmann::json json_of(const CheckpointOwner& owner) {
  return {{"run", owner.run},
          {"scenario", owner.scenario},
          {"scenario_hash", owner.scenario_hash},
          {"seed", owner.seed},
          {"version", owner.version},
          {"wire_version", wire::kWireVersion},
          {"fail_fast", owner.fail_fast}};
}

/// What differs between a run that is recorded and one that wants to go on with it; empty if nothing does.
std::string difference(const nlohmann::json& recorded, const nlohmann::json& own) {
  for (const char* key : {"version", "wire_version", "scenario", "scenario_hash", "seed", "fail_fast"}) {
    const auto found = recorded.find(key);
    if (found == recorded.end()) return "it names no run";
    if (*found == own.at(key)) continue;
    if (std::string_view(key) == "scenario_hash") return "its scenario had another text, or other --set values";
    return fmt::format("its run has {} {}, this one {}", key, found->dump(), own.at(key).dump());
  }
  const auto run = recorded.find("run");
  return run != recorded.end() && run->is_number_unsigned() && *run != 0U ? "" : "it names no run";
}

}  // namespace

CheckpointRefused Checkpoint::refused(const std::string& what, ExitCode code) const {
  return {code, fmt::format("--checkpoint {}: {}", folder_, what)};
}

template <typename Act>
void Checkpoint::guarded(const Act& act) const {
  try {
    act();
  } catch (const JournalFault& fault) {
    throw refused(fault.what(), fault.kind == JournalFault::Kind::InUse ? ExitCode::StartUp : ExitCode::Usage);
  }
}

bool Checkpoint::exists(const std::string& folder) {
  std::error_code error;
  const auto size = std::filesystem::file_size(folder + kFile, error);
  return !error && size > 0;
}

Checkpoint::Checkpoint(const std::string& folder, const CheckpointOwner& owner, bool sync) : folder_(folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw refused(fmt::format("cannot make the folder: {}", error.message()));
  guarded([&] {
    journal_ = std::make_unique<Journal>(folder + kFile, sync);
    look_through(owner);
    if (run_ == 0) {
      run_ = owner.run;
      journal_->append(kOwner, bytes_of(json_of(owner).dump()));
    } else {
      ++restarts_;
      journal_->append(kRestart, {});
    }
  });
}

void Checkpoint::look_through(const CheckpointOwner& owner) {
  journal_->read([&](std::uint32_t kind, std::span<const std::uint8_t> content) {
    if (kind == kBroken) throw refused("it could not be written to the end: " + text_of_bytes(content));
    if (run_ == 0) {
      if (kind != kOwner) throw refused("it names no run");
      take_owner(content, owner);
    } else if (kind == kRestart) {
      ++restarts_;
    } else if (kind == kEnd) {
      throw refused("its run has ended: " + text_of_bytes(content));
    }
  });
}

void Checkpoint::take_owner(std::span<const std::uint8_t> content, const CheckpointOwner& owner) {
  const auto recorded = nlohmann::json::parse(content.begin(), content.end(), nullptr, false);
  const std::string other = recorded.is_object() ? difference(recorded, json_of(owner)) : "it names no run";
  if (!other.empty()) throw refused(other);
  run_ = recorded.at("run").get<std::uint64_t>();
}

void Checkpoint::restore(WorldSession& session, double now_s) {
  if (restarts_ == 0) return;
  const Mission& mission = session.run().mission();
  const std::vector<AgentId> ids = ids_of(mission);
  WireContext context;
  context.run = run_;
  context.known = ids;
  if (mission.transit) context.grid = grid_of(*mission.transit);
  const auto take = [&](std::uint32_t kind, std::span<const std::uint8_t> content) {
    if (kind == kRound) {
      const std::optional<RoundInputs> inputs = round_inputs_from(content, context);
      if (!inputs) throw refused("it holds a round that is not one");
      session.replay(*inputs);
    } else if (kind == kFault) {
      const ParsedFault parsed = parse_fault(text_of_bytes(content));
      if (!parsed.fault) throw refused("it holds a fault that is not one");
      session.replay(*parsed.fault);
    }
  };
  try {
    guarded([&] { journal_->read(take); });
    session.resume(restarts_, now_s);
  } catch (const std::logic_error& error) {
    throw refused(error.what());
  }
}

void Checkpoint::round(const RoundInputs& inputs) {
  put(kRound, to_bytes(inputs));
}

void Checkpoint::fault(const Fault& fault) {
  put(kFault, bytes_of(text_of(fault)));
}

void Checkpoint::end(const std::string& reason) {
  put(kEnd, bytes_of(reason));
}

/// A journal with a gap must not be gone on with: it is cut to the reason.
void Checkpoint::put(std::uint32_t kind, std::span<const std::uint8_t> content) {
  if (!failure_.empty()) return;
  try {
    journal_->append(kind, content);
  } catch (const JournalFault& fault) {
    failure_ = fault.what();
  }
  if (failure_.empty()) return;
  try {
    journal_->clear();
    journal_->append(kBroken, bytes_of(failure_));
  } catch (const JournalFault&) {
    // what is left is empty or torn: another world begins anew, and finds agents of this one
  }
}

}  // namespace skein
