// A checkpoint lets the same run go on, and refuses every other in one line.
#include "simworld/checkpoint/checkpoint.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "tests/simworld/checkpoint/recorded_run.hpp"
#include "tests/simworld/checkpoint/scratch.hpp"

namespace skein {
namespace {

using test::Scratch;
using test::Stage;

CheckpointOwner owner() {
  return {test::kRun, "small", 0xabc, 5, "0.1.0", false};
}

/// Why the folder is refused, or nothing.
std::string refusal(const std::string& folder, const CheckpointOwner& who, ExitCode code = ExitCode::Usage) {
  try {
    const Checkpoint checkpoint(folder, who, false);
    return "";
  } catch (const CheckpointRefused& refused) {
    EXPECT_EQ(refused.code, code);
    return refused.what();
  }
}

TEST(Checkpoint, ARunGoesOnUnderItsIdAndItsRestartsAreCounted) {
  const Scratch folder;
  EXPECT_FALSE(Checkpoint::exists(folder.path()));
  {
    const Checkpoint first(folder.path(), owner(), true);
    EXPECT_EQ(first.run(), test::kRun);
    EXPECT_EQ(first.restarts(), 0U);
  }
  EXPECT_TRUE(Checkpoint::exists(folder.path()));
  CheckpointOwner again = owner();
  again.run = 99;
  for (std::uint32_t restarts = 1; restarts <= 3; ++restarts) {
    const Checkpoint later(folder.path(), again, false);
    EXPECT_EQ(later.run(), test::kRun);
    EXPECT_EQ(later.restarts(), restarts);
  }
}

TEST(Checkpoint, AnotherRunIsRefusedInOneLine) {
  const Scratch folder;
  { const Checkpoint first(folder.path(), owner(), false); }
  const std::string start = "--checkpoint " + folder.path() + ": ";
  CheckpointOwner other = owner();
  other.scenario = "large";
  EXPECT_EQ(refusal(folder.path(), other), start + "its run has scenario \"small\", this one \"large\"");
  other = owner();
  other.scenario_hash = 1;
  EXPECT_EQ(refusal(folder.path(), other), start + "its scenario had another text, or other --set values");
  other = owner();
  other.seed = 6;
  EXPECT_EQ(refusal(folder.path(), other), start + "its run has seed 5, this one 6");
  other = owner();
  other.version = "0.2.0";
  EXPECT_EQ(refusal(folder.path(), other), start + "its run has version \"0.1.0\", this one \"0.2.0\"");
  other = owner();
  other.fail_fast = true;
  EXPECT_EQ(refusal(folder.path(), other), start + "its run has fail_fast false, this one true");
  EXPECT_EQ(refusal(folder.path(), owner()), "");
}

TEST(Checkpoint, ARunThatHasEndedIsRefused) {
  const Scratch folder;
  {
    Checkpoint first(folder.path(), owner(), false);
    first.end("all vehicles arrived");
  }
  EXPECT_EQ(refusal(folder.path(), owner()),
            "--checkpoint " + folder.path() + ": its run has ended: all vehicles arrived");
}

TEST(Checkpoint, OneThatIsOpenOrDamagedOrNoFolderIsRefused) {
  const Scratch folder;
  {
    const Checkpoint first(folder.path(), owner(), false);
    EXPECT_NE(refusal(folder.path(), owner(), ExitCode::StartUp).find("another world has it open"), std::string::npos);
  }
  Bytes bytes = test::read_file(folder.path() + "/journal");
  bytes[40] ^= 1U;
  test::write_file(folder.path() + "/journal", bytes);
  EXPECT_NE(refusal(folder.path(), owner()).find("damaged at byte 32"), std::string::npos);
  EXPECT_NE(refusal(folder.path() + "/journal", owner()).find("cannot make the folder"), std::string::npos);
}

TEST(Checkpoint, AJournalThatNamesNoRunIsRefused) {
  const Scratch folder;
  {
    Journal journal(folder.path() + "/journal", false);
    journal.append(2, Bytes{1, 2});
  }
  EXPECT_NE(refusal(folder.path(), owner()).find("it names no run"), std::string::npos);
}

/// A world that dies after the round with a loss, and the ones that take its place until the end.
TEST(Checkpoint, RoundsAndFaultsAreRepeatedInANewSession) {
  const Scratch folder;
  std::vector<Tick> whole;
  {
    Stage stage(2);
    whole.push_back(stage.start());
    test::play(stage, whole.front(), whole);
  }
  const Fault fault{FaultKind::Stop, 1, Phase::Flying, 900};
  for (std::size_t death = 0; death < 3; ++death) {
    Checkpoint checkpoint(folder.path(), owner(), false);
    test::FakeControl control;
    SessionOptions options;
    options.recorder = &checkpoint;
    options.faults = {fault};
    Stage stage(2, options, &control);
    checkpoint.restore(stage.session, 0.0);
    EXPECT_EQ(stage.session.unused_faults().size(), death < 2 ? 1U : 0U);
    stage.port.sees = {test::nonce_of(1), test::nonce_of(2), test::kNewNonce};
    if (death == 0) {
      ASSERT_EQ(stage.start(), whole[0]);
      continue;
    }
    stage.at(0.0);
    const Tick open = stage.last_tick();
    ASSERT_EQ(open, whole[death - 1]);
    if (death == 1) checkpoint.fault(fault);
    if (death == 2) stage.session.process_ended(2, 0.0);
    test::answer(stage, open);
    stage.at(0.0);
    EXPECT_EQ(stage.last_tick(), whole[death]);
  }
}

/// No file of this process grows over a size, while it lives.
class FileLimit {
 public:
  explicit FileLimit(std::size_t bytes) : before_(limit()), handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    rlimit lower = before_;
    lower.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &lower);
  }
  ~FileLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;

 private:
  static rlimit limit() {
    rlimit now{};
    getrlimit(RLIMIT_FSIZE, &now);
    return now;
  }
  rlimit before_;
  void (*handler_)(int);
};

TEST(Checkpoint, OneThatCannotBeWrittenAnyMoreIsGivenUpAndSaysWhyNobodyCanGoOn) {
  const Scratch folder;
  {
    Checkpoint checkpoint(folder.path(), owner(), false);
    const FileLimit limit(test::read_file(folder.path() + "/journal").size() + 10);
    EXPECT_EQ(checkpoint.failure(), "");
    checkpoint.round(RoundInputs{});
    EXPECT_EQ(checkpoint.failure(), folder.path() + "/journal: File too large");
    checkpoint.round(RoundInputs{});
    checkpoint.end("all vehicles arrived");
  }
  EXPECT_EQ(refusal(folder.path(), owner()), "--checkpoint " + folder.path() +
                                                 ": it could not be written to the end: " + folder.path() +
                                                 "/journal: File too large");
}

TEST(Checkpoint, AFullDiskAtTheStartIsRefused) {
  const Scratch folder;
  std::filesystem::create_symlink("/dev/full", folder.path() + "/journal");
  EXPECT_NE(refusal(folder.path(), owner()).find("No space left on device"), std::string::npos);
}

}  // namespace
}  // namespace skein
