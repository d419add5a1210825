// A recording that goes to a file. A disk that is full, or gone, ends the recording and not the run.
#pragma once

#include <exception>
#include <string>

#include "groundstation/mcap/file.hpp"
#include "groundstation/record/recording.hpp"

namespace skein {

class RecordingFile {
 public:
  /// A new file; one that is there is emptied. @throws std::runtime_error with one line
  RecordingFile(const std::string& path, const RecordingOrigin& origin)
      : file_(path), recording_([this](mcap::ByteView bytes) { file_.write(bytes); }, origin) {}

  void add(const TakenSample& sample) {
    guarded([&] { recording_.add(sample); });
  }
  void flush() {
    guarded([&] { recording_.flush(); });
  }
  void finish(const mcap::Texts& kept, const nlohmann::ordered_json& report = nullptr) {
    guarded([&] { recording_.finish(kept, report); });
  }
  [[nodiscard]] std::uint64_t samples() const { return recording_.samples(); }
  /// Why nothing is recorded any more, in one line; empty while all is well.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  template <typename Action>
  void guarded(const Action& action) {
    if (!failure_.empty()) return;
    try {
      action();
    } catch (const std::exception& error) {
      failure_ = error.what();
    }
  }

  mcap::OutputFile file_;
  Recording recording_;
  std::string failure_;
};

}  // namespace skein
