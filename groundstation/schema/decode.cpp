#include "groundstation/schema/decode.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace skein::schema {
namespace {

constexpr std::size_t kEncapsulation = 4;

/// Takes values off the bytes; once anything is missing, all that follows is zero and good() is false.
class CdrReader {
 public:
  CdrReader(std::span<const std::uint8_t> body, bool little) : body_(body), little_(little) {}

  [[nodiscard]] bool good() const { return good_; }
  [[nodiscard]] std::size_t left() const { return body_.size() - at_; }

  template <typename Number>
  Number number() {
    at_ = std::min(body_.size(), (at_ + sizeof(Number) - 1) / sizeof(Number) * sizeof(Number));
    std::array<std::uint8_t, sizeof(Number)> bytes{};
    const auto from = take(sizeof(Number));
    if (!good_) return Number{};
    std::ranges::copy(from, bytes.begin());
    if (little_ != (std::endian::native == std::endian::little)) std::ranges::reverse(bytes);
    return std::bit_cast<Number>(bytes);
  }

  Json text() {
    const auto bytes = take(number<std::uint32_t>());  // with a zero at its end
    if (!good_ || bytes.empty() || bytes.back() != 0) return refuse();
    return std::string(bytes.begin(), bytes.end() - 1);
  }

  Json refuse() {
    good_ = false;
    return nullptr;
  }

 private:
  std::span<const std::uint8_t> take(std::size_t size) {
    good_ = good_ && size <= left();
    if (!good_) return {};
    at_ += size;
    return body_.subspan(at_ - size, size);
  }

  std::span<const std::uint8_t> body_;
  bool little_;
  bool good_ = true;
  std::size_t at_ = 0;
};

Json real(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0.0 ? "-inf" : "inf";
  return value;
}

Json structure(const Struct& type, CdrReader& reader);

Json boolean(CdrReader& reader) {
  const auto octet = reader.number<std::uint8_t>();
  return octet > 1 ? reader.refuse() : Json(octet == 1);
}

Json item_of(const Field& field, CdrReader& reader) {
  switch (field.basic) {
    case Basic::Boolean:
      return boolean(reader);
    case Basic::Octet:
      return reader.number<std::uint8_t>();
    case Basic::Char:
      return std::string(1, static_cast<char>(reader.number<std::uint8_t>()));
    case Basic::Short:
      return reader.number<std::int16_t>();
    case Basic::UShort:
      return reader.number<std::uint16_t>();
    case Basic::Long:
      return reader.number<std::int32_t>();
    case Basic::ULong:
      return reader.number<std::uint32_t>();
    case Basic::LongLong:
      return std::to_string(reader.number<std::int64_t>());
    case Basic::ULongLong:
      return std::to_string(reader.number<std::uint64_t>());
    case Basic::Float:
      return real(static_cast<double>(reader.number<float>()));
    case Basic::Double:
      return real(reader.number<double>());
    case Basic::String:
      return reader.text();
    case Basic::Struct:
      return structure(*field.type, reader);
  }
  return reader.refuse();
}

/// Null if the bytes are none; of a struct what comes before.
Json item(const Field& field, CdrReader& reader) {
  Json found = item_of(field, reader);
  return reader.good() || field.basic == Basic::Struct ? found : Json();
}

Json value(const Field& field, CdrReader& reader) {
  if (field.shape == Shape::One) return item(field, reader);
  const std::uint32_t length = field.shape == Shape::Array ? field.length : reader.number<std::uint32_t>();
  const bool too_long = field.shape == Shape::Sequence && field.length != 0 && length > field.length;
  if (!reader.good() || too_long || length > reader.left()) return reader.refuse();
  Json items = Json::array();
  for (std::uint32_t i = 0; i < length && reader.good(); ++i) items.push_back(item(field, reader));
  return items;
}

Json structure(const Struct& type, CdrReader& reader) {
  Json object = Json::object();
  for (const Field& field : type.fields) {
    object[field.name] = value(field, reader);
    if (!reader.good()) break;
  }
  return object;
}

void find_null(const Json& a, const Json& partial, const std::string& path, std::optional<Difference>& found) {
  if (found) return;
  if (partial.is_null()) {
    found = {path, a, partial};
  } else if (partial.is_object()) {
    for (const auto& [key, inside] : partial.items()) {
      find_null(a.is_object() ? a.value(key, Json()) : Json(), inside, path.empty() ? key : path + "." + key, found);
    }
  } else if (partial.is_array()) {
    for (std::size_t i = 0; i < partial.size(); ++i) {
      const bool there = a.is_array() && i < a.size();
      find_null(there ? a[i] : Json(), partial[i], path + "[" + std::to_string(i) + "]", found);
    }
  }
}

void find(const Json& a, const Json& b, const std::string& path, std::optional<Difference>& found) {
  if (found || a == b) {
    // 0.0 and -0.0 are equal as numbers, not as bytes
    const bool zeros = !found && a.is_number_float() && b.is_number_float() &&
                       std::signbit(a.get<double>()) != std::signbit(b.get<double>());
    if (zeros) found = {path, a, b};
    if (found || !a.is_structured()) return;
  }
  if (a.is_object() && b.is_object()) {
    for (const auto& [key, inside] : a.items()) {
      find(inside, b.value(key, Json()), path.empty() ? key : path + "." + key, found);
    }
  } else if (a.is_array() && b.is_array()) {
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
      find(i < a.size() ? a[i] : Json(), i < b.size() ? b[i] : Json(), path + "[" + std::to_string(i) + "]", found);
    }
  } else if (!found) {
    found = {path, a, b};
  }
}

}  // namespace

std::optional<Json> decode(const Struct& type, std::span<const std::uint8_t> payload) {
  if (payload.size() < kEncapsulation || payload[0] != 0 || payload[1] > 1) return std::nullopt;
  CdrReader reader(payload.subspan(kEncapsulation), payload[1] == 1);
  Json fields = structure(type, reader);
  return reader.good() ? std::optional(std::move(fields)) : std::nullopt;
}

Json decode_partly(const Struct& type, std::span<const std::uint8_t> payload) {
  if (payload.size() < kEncapsulation || payload[0] != 0 || payload[1] > 1) return nullptr;
  CdrReader reader(payload.subspan(kEncapsulation), payload[1] == 1);
  return structure(type, reader);
}

std::optional<Difference> first_null(const Json& a, const Json& partial) {
  std::optional<Difference> found;
  find_null(a, partial, "", found);
  return found;
}

std::optional<Difference> first_difference(const Json& a, const Json& b) {
  std::optional<Difference> found;
  find(a, b, "", found);
  return found;
}

}  // namespace skein::schema
