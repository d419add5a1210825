// Files as the MCAP writer and reader use them: bytes out, each call at once, and a whole file as a view.
//
// Source: none. Departs from source: none. Complexity: a system call a write; reading maps the file.
#pragma once

#include <string>

#include "groundstation/mcap/records.hpp"

namespace skein::mcap {

/// A new file. One that is there is emptied by the first write, and a new one without a write is no file in the end.
/// What was written is the system's, so it outlives a SIGKILL.
class OutputFile {
 public:
  /// @throws std::runtime_error with one line (both)
  explicit OutputFile(std::string path);
  void write(ByteView bytes);
  /// Else a device, a pipe.
  [[nodiscard]] bool is_regular() const { return is_regular_; }

  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

 private:
  std::string path_;
  int descriptor_;
  bool is_new_ = false;
  bool is_regular_ = false;
  bool is_written_ = false;
};

/// A file's bytes, for as long as the object lives. What is appended meanwhile is not seen.
class MappedFile {
 public:
  /// @throws std::runtime_error with one line
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  [[nodiscard]] ByteView bytes() const { return bytes_; }

 private:
  ByteView bytes_;
};

}  // namespace skein::mcap
