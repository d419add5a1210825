// A recording replaces a file when there is something to record.
#include "groundstation/record/recording_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "groundstation/mcap/reader.hpp"
#include "idl/convert/cdr.hpp"
#include "idl/convert/convert.hpp"
#include "tests/simworld/checkpoint/scratch.hpp"

namespace skein {
namespace {

namespace fs = std::filesystem;

class RecordingFileTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
  [[nodiscard]] std::string existing(const std::string& name) const {
    std::ofstream(path(name)) << std::string(5000, 'x');
    return path(name);
  }
  static std::string text_in(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static RecordingOrigin origin() { return {"attached", "geese", nullptr, false}; }
  static Bytes tick() {
    Tick value;
    value.run = 9;
    value.round = 1;
    value.phase = Phase::Flying;
    value.roster = {{1, 1, 11}};
    return to_cdr(to_wire(value, {}));
  }

 private:
  test::Scratch folder_;
};

TEST_F(RecordingFileTest, WithoutASampleAFileStaysAsItIs) {
  const std::string old = existing("old.mcap");
  {
    RecordingFile file(old, origin());
    file.flush();
    file.finish({});
    EXPECT_FALSE(file.begun());
    EXPECT_EQ(file.failure(), "");
  }
  EXPECT_EQ(text_in(old), std::string(5000, 'x'));
}

TEST_F(RecordingFileTest, WithoutASampleThereIsNoNewFile) {
  { RecordingFile(path("new.mcap"), origin()).finish({}); }
  EXPECT_FALSE(fs::exists(path("new.mcap")));
}

TEST_F(RecordingFileTest, ASampleReplacesWhatWasThere) {
  const std::string old = existing("old.mcap");
  RecordingFile file(old, origin());
  const Bytes payload = tick();
  file.add({bus::TopicId::Tick, true, 1, payload});
  file.finish({{"lost", "0"}});
  EXPECT_TRUE(file.begun());
  const mcap::MappedFile mapped(old);
  const mcap::Reader reader(mapped.bytes());
  reader.check();
  EXPECT_EQ(reader.missing(), "");
  EXPECT_EQ(reader.contents().statistics.message_count, 1U);
  EXPECT_EQ(reader.metadata("skein").value().texts.at("swarm"), "geese");
}

TEST_F(RecordingFileTest, AReportIsSomethingToRecord) {
  const std::string old = existing("old.mcap");
  RecordingFile(old, origin()).finish({}, {{"exit_code", 3}});
  const mcap::MappedFile mapped(old);
  EXPECT_TRUE(mcap::Reader(mapped.bytes()).attachment(kReportName).has_value());
}

TEST_F(RecordingFileTest, ADeviceThatTakesNothingIsSaidAtOnce) {
  EXPECT_THROW(RecordingFile("/dev/full", origin()), std::runtime_error);
  EXPECT_THROW(RecordingFile(path("none/a.mcap"), origin()), std::runtime_error);
}

}  // namespace
}  // namespace skein
