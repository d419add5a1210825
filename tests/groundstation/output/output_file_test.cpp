// What was there before a file is written stays until the new one is whole; outputs are told from inputs.
#include "groundstation/output/output_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

namespace skein {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class OutputFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  [[nodiscard]] std::string in_folder(const std::string& name) const { return folder + "/" + name; }
  static std::string text_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static std::string refusal(const std::string& path, const std::vector<std::string>& others = {}) {
    try {
      check_output(path, others);
      return "";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }
  [[nodiscard]] std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }

  const std::string folder = (fs::temp_directory_path() / ("skein-output-" + std::to_string(::getpid()))).string();
};

TEST_F(OutputFile, ACheckLeavesWhatIsThereAndMakesNothing) {
  std::ofstream(in_folder("old")) << "old";
  EXPECT_EQ(refusal(in_folder("old")), "");
  EXPECT_EQ(refusal(in_folder("new")), "");
  EXPECT_EQ(text_of(in_folder("old")), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFile, WhatCannotBeWrittenIsRefused) {
  EXPECT_EQ(refusal(folder), "cannot write " + folder + ": it is a folder");
  EXPECT_THAT(refusal(in_folder("none/x")), HasSubstr("none/x: No such file or directory"));
  EXPECT_THAT(refusal("/proc/nowhere"), HasSubstr("cannot write /proc/nowhere: "));
  EXPECT_THAT(refusal(""), HasSubstr("a file needs a name"));
}

TEST_F(OutputFile, AnotherFileOfTheCommandIsRefusedUnderWhateverName) {
  std::ofstream(in_folder("in")) << "in";
  fs::create_symlink(in_folder("in"), in_folder("link"));
  fs::create_hard_link(in_folder("in"), in_folder("hard"));
  const std::string roundabout = folder + "/../" + fs::path(folder).filename().string() + "/in";
  for (const std::string& path : {in_folder("in"), in_folder("link"), in_folder("hard"), roundabout}) {
    EXPECT_THAT(refusal(path, {"", in_folder("in")}), HasSubstr("reads or writes it as " + in_folder("in")));
  }
  EXPECT_THAT(refusal(in_folder("new"), {in_folder("./new")}), HasSubstr("reads or writes it"));
  EXPECT_EQ(refusal(in_folder("new"), {in_folder("in"), ""}), "");
  EXPECT_EQ(refusal("/dev/null", {"/dev/null"}), "");
}

TEST_F(OutputFile, ReplacesAFileWithItsPermissionsAndFollowsLinks) {
  const std::string path = in_folder("old");
  std::ofstream(path) << "something longer";
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(path, in_folder("link"));
  write_output(in_folder("link"), "new");
  EXPECT_EQ(text_of(path), "new");
  EXPECT_TRUE(fs::is_symlink(in_folder("link")));
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  write_output(in_folder("made"), "made");
  EXPECT_EQ(text_of(in_folder("made")), "made");
  EXPECT_EQ(files(), 3);
}

TEST_F(OutputFile, OnAFullDiskTheOldOneStays) {
  const std::string path = in_folder("old");
  std::ofstream(path) << "old";
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const struct rlimit small { 100, before.rlim_max };
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(write_output(path, std::string(1000, 'x')), std::runtime_error);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(text_of(path), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFile, DevicesAreWrittenAsTheyAre) {
  EXPECT_NO_THROW(write_output("/dev/null", "bytes"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_THROW(write_output("/dev/full", "bytes"), std::runtime_error);
}

}  // namespace
}  // namespace skein
