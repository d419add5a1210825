// Records of an MCAP file to bytes and back, by their fields() (groundstation/mcap/records.hpp).
//
// Putting appends; taking never reads past the end: once something is missing all that follows is empty, and decode()
// gives nothing. Source: https://mcap.dev/spec, Serialization. Departs from source: none. Complexity: linear.
#pragma once

#include <concepts>
#include <optional>

#include "groundstation/mcap/records.hpp"
#include "simworld/checkpoint/byte_order.hpp"

namespace skein::mcap {

class Put {
 public:
  explicit Put(Bytes& into) : into_(into) {}

  void operator()(const auto&... values) { (put(values), ...); }
  void short_bytes(ByteView bytes) { sized<std::uint32_t>(bytes); }
  void long_bytes(ByteView bytes) { sized<std::uint64_t>(bytes); }
  void rest(ByteView bytes) { into_.insert(into_.end(), bytes.begin(), bytes.end()); }

 private:
  template <typename Length>
  void sized(ByteView bytes) {
    put_number(into_, static_cast<Length>(bytes.size()));
    rest(bytes);
  }
  template <std::unsigned_integral Number>
  void put(Number number) {
    put_number(into_, number);
  }
  void put(const std::string& text) {
    put_number(into_, static_cast<std::uint32_t>(text.size()));
    into_.insert(into_.end(), text.begin(), text.end());
  }
  /// A map or list of pairs, after its length in bytes.
  template <typename Pairs>
  requires requires(const Pairs& pairs) { pairs.begin()->second; }
  void put(const Pairs& pairs) {
    Bytes inside;
    Put archive(inside);
    for (const auto& [key, value] : pairs) archive(key, value);
    short_bytes(inside);
  }

  Bytes& into_;
};

class Take {
 public:
  explicit Take(ByteView bytes) : rest_(bytes) {}

  void operator()(auto&... values) { (take(values), ...); }
  void short_bytes(auto& bytes) { assign(bytes, take_bytes(number<std::uint32_t>())); }
  void long_bytes(auto& bytes) { assign(bytes, take_bytes(number<std::uint64_t>())); }
  void rest(auto& bytes) { assign(bytes, take_bytes(rest_.size())); }
  /// Whether everything was there, and nothing is left over.
  [[nodiscard]] bool whole() const { return good_ && rest_.empty(); }

 private:
  template <typename Number>
  Number number() {
    const ByteView bytes = take_bytes(sizeof(Number));
    return good_ ? read_number<Number>(bytes) : Number{};
  }
  ByteView take_bytes(std::uint64_t size) {
    good_ = good_ && size <= rest_.size();
    if (!good_) return {};
    const ByteView bytes = rest_.first(static_cast<std::size_t>(size));
    rest_ = rest_.subspan(bytes.size());
    return bytes;
  }
  static void assign(ByteView& into, ByteView bytes) { into = bytes; }
  static void assign(Bytes& into, ByteView bytes) { into.assign(bytes.begin(), bytes.end()); }
  template <std::unsigned_integral Number>
  void take(Number& into) {
    into = number<Number>();
  }
  void take(std::string& into) {
    const ByteView bytes = take_bytes(number<std::uint32_t>());
    into.assign(bytes.begin(), bytes.end());
  }
  template <typename Key, typename Value>
  void take(std::map<Key, Value>& into) {
    take_pairs<Key, Value>([&](Key key, Value value) { return into.emplace(std::move(key), std::move(value)).second; });
  }
  template <typename First, typename Second>
  void take(std::vector<std::pair<First, Second>>& into) {
    take_pairs<First, Second>([&](First first, Second second) {
      into.emplace_back(first, second);
      return true;
    });
  }
  template <typename First, typename Second>
  void take_pairs(const auto& add) {
    Take inside(take_bytes(number<std::uint32_t>()));
    while (inside.good_ && !inside.rest_.empty()) {
      First first{};
      Second second{};
      inside(first, second);
      if (inside.good_) good_ = add(std::move(first), std::move(second)) && good_;  // no key twice
    }
    good_ = good_ && inside.good_;
  }

  ByteView rest_;
  bool good_ = true;
};

/// Appends the whole record, with opcode and length.
template <typename Record>
void append(Bytes& into, const Record& record) {
  into.push_back(static_cast<std::uint8_t>(Record::kOpcode));
  const std::size_t length_at = into.size();
  put_number(into, std::uint64_t{0});
  Put archive(into);
  fields(archive, record);
  Bytes length;
  put_number(length, static_cast<std::uint64_t>(into.size() - length_at - sizeof(std::uint64_t)));
  std::copy(length.begin(), length.end(), into.begin() + static_cast<std::ptrdiff_t>(length_at));
}

/// Of a record's content, without opcode and length. Nothing if the bytes are no such record.
template <typename Record>
[[nodiscard]] std::optional<Record> decode(ByteView content) {
  Take archive(content);
  Record record;
  fields(archive, record);
  return archive.whole() ? std::optional(std::move(record)) : std::nullopt;
}

/// A record in its place.
struct Framed {
  Opcode opcode{};
  ByteView content;
  std::size_t size = 0;  ///< with opcode and length
};

/// The record at `offset`; nothing if it is not all there.
[[nodiscard]] inline std::optional<Framed> record_at(ByteView bytes, std::uint64_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < kRecordHead) return std::nullopt;
  const ByteView from = bytes.subspan(static_cast<std::size_t>(offset));
  const auto length = read_number<std::uint64_t>(from.subspan(1, sizeof(std::uint64_t)));
  if (length > from.size() - kRecordHead) return std::nullopt;
  const auto size = static_cast<std::size_t>(length);
  return Framed{static_cast<Opcode>(from.front()), from.subspan(kRecordHead, size), kRecordHead + size};
}

}  // namespace skein::mcap
