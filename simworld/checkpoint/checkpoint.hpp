// The checkpoint of a run: what its world needs to go on after it has died, in a folder.
//
// The folder holds one journal (simworld/checkpoint/journal.hpp): first which run it is of, then what decided each
// round, written before the round's tick can be heard, faults on purpose before they are carried out, each start of a
// world after the first, and at last that the run has ended. A world that finds a journal reads who it is, repeats the
// rounds through the same deterministic core, and repeats the tick that is open. Nobody has heard of a round that is
// not in the journal. When it cannot be written any more (a full disk) the run goes on without, and the journal says
// so. Source: event sourcing. Departs from source: none. Complexity: linear in the rounds.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "simworld/checkpoint/journal.hpp"
#include "simworld/lockstep/world_session.hpp"

namespace skein {

/// Whose run a checkpoint holds; all but `run` must agree when it goes on.
struct CheckpointOwner {
  std::uint64_t run = 0;
  std::string scenario;
  std::uint64_t scenario_hash = 0;
  std::uint64_t seed = 0;
  std::string version;
  bool fail_fast = false;
};

/// Why a world cannot start from this checkpoint, in one line.
struct CheckpointRefused : std::runtime_error {
  CheckpointRefused(ExitCode the_code, const std::string& line) : std::runtime_error(line), code(the_code) {}
  ExitCode code;  ///< Usage; StartUp when another world has it open
};

class Checkpoint final : public Recorder {
 public:
  /// Opens the folder, or makes it. @param owner its `run` is that of a run that begins now
  /// @param sync whether each record is on the disk before the run goes on
  /// @throws CheckpointRefused
  Checkpoint(const std::string& folder, const CheckpointOwner& owner, bool sync);

  /// The run's id: of the one that is in the folder, if there is one.
  [[nodiscard]] std::uint64_t run() const { return run_; }
  /// Worlds of the run before this one.
  [[nodiscard]] std::uint32_t restarts() const { return restarts_; }
  /// Repeats the run in a session that was made for it, and lets it go on. Without effect on a run that begins.
  /// @throws CheckpointRefused
  void restore(WorldSession& session, double now_s);

  void round(const RoundInputs& inputs) override;
  void fault(const Fault& fault) override;
  /// The run is over, and its report is written: nobody goes on with it.
  void end(const std::string& reason);
  /// Why rounds are no longer kept; empty while they are.
  [[nodiscard]] const std::string& failure() const { return failure_; }

  /// Whether the folder holds a run.
  [[nodiscard]] static bool exists(const std::string& folder);

 private:
  void put(std::uint32_t kind, std::span<const std::uint8_t> content);
  [[nodiscard]] CheckpointRefused refused(const std::string& what, ExitCode code = ExitCode::Usage) const;
  void take_owner(std::span<const std::uint8_t> content, const CheckpointOwner& owner);
  void look_through(const CheckpointOwner& owner);
  template <typename Act>
  void guarded(const Act& act) const;

  std::string folder_;
  std::unique_ptr<Journal> journal_;
  std::uint64_t run_ = 0;
  std::uint32_t restarts_ = 0;
  std::string failure_;
};

}  // namespace skein
