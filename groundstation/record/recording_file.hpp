// A recording that goes to a file. A disk that is full, or gone, ends the recording and not the run. A file that is
// there is replaced when there is something to record, a sample or a report, and stays as it is if there never is.
#pragma once

#include <exception>
#include <string>
#include <utility>

#include "groundstation/mcap/file.hpp"
#include "groundstation/record/recording.hpp"

namespace skein {

class RecordingFile {
 public:
  /// @throws std::runtime_error with one line
  RecordingFile(const std::string& path, const RecordingOrigin& origin)
      : file_(path), begun_(!file_.is_regular()), recording_([this](mcap::ByteView bytes) { write(bytes); }, origin) {}

  void add(const TakenSample& sample) {
    guarded([&] {
      begin();
      recording_.add(sample);
    });
  }
  void flush() {
    guarded([&] { recording_.flush(); });
  }
  void finish(const mcap::Texts& kept, const nlohmann::ordered_json& report = nullptr) {
    if (!report.is_null()) guarded([&] { begin(); });
    if (begun_) guarded([&] { recording_.finish(kept, report); });
  }
  /// Whether there is a file.
  [[nodiscard]] bool begun() const { return begun_; }
  [[nodiscard]] std::uint64_t samples() const { return recording_.samples(); }
  /// Why nothing is recorded any more, in one line; empty while all is well.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  void write(mcap::ByteView bytes) {
    if (begun_) {
      file_.write(bytes);
    } else {
      held_.insert(held_.end(), bytes.begin(), bytes.end());
    }
  }
  void begin() {
    if (!std::exchange(begun_, true)) file_.write(held_);
  }
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
  bool begun_;        ///< what is not a file of the disk says at once whether it can be written
  mcap::Bytes held_;  ///< from before
  Recording recording_;
  std::string failure_;
};

}  // namespace skein
