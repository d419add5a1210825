// A file of records that only grows, and says of each whether it is whole.
//
// A record is a head of 32 bytes (mark, kind, length, sum of the content, sum of the head itself; little endian) and
// its content. append() hands it to the kernel before it returns: it survives the death of the process, and with `sync`
// that of the machine. What a process was writing when it died is a prefix of a record: such a rest at the end of the
// file is cut off. Anything else that does not fit its sums is damage, and is refused. The sums are mixed 64-bit words,
// against accidents, not against malice. One process at a time has a journal open (flock; the lock dies with it).
// Source: own. Departs from source: none. Complexity: O(1) memory a record, linear time in its bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>

#include "idl/convert/cdr.hpp"

namespace skein {

/// The journal cannot be used: one line says why.
struct JournalFault : std::runtime_error {
  enum class Kind : std::uint8_t {
    Unusable,  ///< the file cannot be opened, read or written
    InUse,     ///< another process has it open
    Damaged,   ///< a record does not fit its sums
  };
  JournalFault(Kind the_kind, const std::string& line) : std::runtime_error(line), kind(the_kind) {}
  Kind kind;
};

class Journal {
 public:
  using Take = std::function<void(std::uint32_t kind, std::span<const std::uint8_t> content)>;

  /// Opens the file, or makes it. @param sync whether a record is on the disk when append() returns
  /// @throws JournalFault
  Journal(const std::string& path, bool sync);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Calls `take` for each record, in order, and cuts a torn one off the end. @throws JournalFault, and what `take`
  /// does
  void read(const Take& take);
  /// @throws JournalFault; then the file may end in a torn record, and must not be appended to any more
  void append(std::uint32_t kind, std::span<const std::uint8_t> content);
  /// Forgets all records. @throws JournalFault
  void clear();

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  [[nodiscard]] JournalFault fault(JournalFault::Kind kind, const std::string& what) const;
  /// @return how many bytes there were, `into.size()` at most
  std::size_t read_at(std::uint64_t place, std::span<std::uint8_t> into) const;

  std::string path_;
  bool sync_;
  int file_ = -1;
  Bytes buffer_;
};

}  // namespace skein
