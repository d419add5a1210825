#include "simworld/checkpoint/journal.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "planner/core/hash/state_hash.hpp"
#include "simworld/checkpoint/byte_order.hpp"

namespace skein {
namespace {

constexpr std::uint32_t kMark = 0x314a4b53;  // "SKJ1"
constexpr std::size_t kHead = 32;
constexpr std::uint64_t kMostContent = std::uint64_t{1} << 32U;

std::uint64_t sum_of(std::span<const std::uint8_t> bytes) {
  StateHash hash(bytes.size());
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) hash.add(read_number<std::uint64_t>(bytes));
  for (const std::uint8_t byte : bytes) hash.add(byte);
  return hash.value();
}

struct Head {
  std::uint32_t kind = 0;
  std::uint64_t length = 0;
  std::uint64_t sum = 0;
};

void put_head(Bytes& into, const Head& head) {
  put_number(into, kMark);
  put_number(into, head.kind);
  put_number(into, head.length);
  put_number(into, head.sum);
  put_number(into, sum_of(into));
}

bool read_head(std::span<const std::uint8_t> bytes, Head& head) {
  const bool good = read_number<std::uint32_t>(bytes) == kMark &&
                    read_number<std::uint64_t>(bytes.subspan(24)) == sum_of(bytes.first(24));
  head.kind = read_number<std::uint32_t>(bytes.subspan(4));
  head.length = read_number<std::uint64_t>(bytes.subspan(8));
  head.sum = read_number<std::uint64_t>(bytes.subspan(16));
  return good && head.length <= kMostContent;
}

}  // namespace

Journal::Journal(const std::string& path, bool sync) : path_(path), sync_(sync) {
  file_ = open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file_ < 0) throw fault(JournalFault::Kind::Unusable, std::strerror(errno));
  if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    close(file_);
    if (error == EWOULDBLOCK) throw fault(JournalFault::Kind::InUse, "another world has it open");
    throw fault(JournalFault::Kind::Unusable, std::strerror(error));
  }
}

Journal::~Journal() {
  close(file_);
}

JournalFault Journal::fault(JournalFault::Kind kind, const std::string& what) const {
  return {kind, fmt::format("{}: {}", path_, what)};
}

std::size_t Journal::read_at(std::uint64_t place, std::span<std::uint8_t> into) const {
  std::size_t done = 0;
  while (done < into.size()) {
    const ssize_t size = pread(file_, into.data() + done, into.size() - done, static_cast<off_t>(place + done));
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) throw fault(JournalFault::Kind::Unusable, std::strerror(errno));
    if (size == 0) break;
    done += static_cast<std::size_t>(size);
  }
  return done;
}

void Journal::read(const Take& take) {
  const off_t end = lseek(file_, 0, SEEK_END);
  if (end < 0) throw fault(JournalFault::Kind::Unusable, std::strerror(errno));
  const auto size = static_cast<std::uint64_t>(end);
  std::uint64_t place = 0;
  for (Head head; size - place >= kHead; place += kHead + head.length) {
    std::array<std::uint8_t, kHead> bytes{};
    if (read_at(place, bytes) < kHead) throw fault(JournalFault::Kind::Unusable, "it shrinks while it is read");
    if (!read_head(bytes, head)) throw fault(JournalFault::Kind::Damaged, fmt::format("damaged at byte {}", place));
    if (size - place - kHead < head.length) break;
    buffer_.resize(static_cast<std::size_t>(head.length));
    if (read_at(place + kHead, buffer_) < buffer_.size() || sum_of(buffer_) != head.sum) {
      throw fault(JournalFault::Kind::Damaged, fmt::format("damaged at byte {}", place + kHead));
    }
    take(head.kind, buffer_);
  }
  if (place < size && ftruncate(file_, static_cast<off_t>(place)) != 0) {
    throw fault(JournalFault::Kind::Unusable, std::strerror(errno));
  }
}

void Journal::append(std::uint32_t kind, std::span<const std::uint8_t> content) {
  buffer_.clear();
  put_head(buffer_, {kind, content.size(), sum_of(content)});
  buffer_.insert(buffer_.end(), content.begin(), content.end());
  for (std::span<const std::uint8_t> rest = buffer_; !rest.empty();) {
    const ssize_t size = write(file_, rest.data(), rest.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) throw fault(JournalFault::Kind::Unusable, std::strerror(errno));
    rest = rest.subspan(static_cast<std::size_t>(size));
  }
  if (sync_ && fdatasync(file_) != 0) throw fault(JournalFault::Kind::Unusable, std::strerror(errno));
}

void Journal::clear() {
  if (ftruncate(file_, 0) != 0) throw fault(JournalFault::Kind::Unusable, std::strerror(errno));
}

}  // namespace skein
