#include "simworld/report/steering_report.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "planner/core/lockstep/names.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

Json list_of(const Vec3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

std::string text_of(std::uint64_t id) {
  return fmt::format("{:016x}", id);
}

std::uint64_t id_of(const nlohmann::json& item) {
  const auto text = item.at("id").get<std::string>();
  std::uint64_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id, 16);
  if (error != std::errc{} || end != text.data() + text.size() || id == 0) throw std::runtime_error("id is none");
  return id;
}

std::uint32_t whole(const nlohmann::json& item, const char* key, std::uint32_t least, std::uint32_t most) {
  const nlohmann::json& value = item.at(key);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() < least || value.get<std::uint64_t>() > most) {
    throw std::runtime_error(fmt::format("{} is no whole number from {} to {}", key, least, most));
  }
  return value.get<std::uint32_t>();
}

double real(const nlohmann::json& value, double most) {
  const double number = value.get<double>();
  if (!(std::fabs(number) <= most)) throw std::runtime_error("a number is out of range");
  return number;
}

Vec3 vector_of(const nlohmann::json& list) {
  constexpr double kMost = 1e7;
  if (!list.is_array() || list.size() != 3) throw std::runtime_error("a vector has three numbers");
  return {real(list[0], kMost), real(list[1], kMost), real(list[2], kMost)};
}

constexpr std::uint32_t kMostRounds = 0xffffffff;

OrderedAt order_of(const nlohmann::json& item) {
  OrderedAt at;
  at.round = whole(item, "round", 1, kMostRounds);
  at.order.id = id_of(item);
  at.order.agent = whole(item, "agent", 0, kMaxAgents);
  const auto kind = order_kind_from(item.at("kind").get<std::string>());
  if (!kind) throw std::runtime_error("unknown kind");
  at.order.kind = *kind;
  if (*kind != OrderKind::Goto) return at;
  at.order.to_m = vector_of(item.at("to_m"));
  at.order.speed_mps = std::fabs(real(item.at("speed_mps"), 1e4));
  return at;
}

InjectedAt injection_of(const nlohmann::json& item) {
  InjectedAt at;
  at.round = whole(item, "round", 1, kMostRounds);
  at.injection.id = id_of(item);
  at.injection.position_m = vector_of(item.at("position_m"));
  at.injection.velocity_mps = vector_of(item.at("velocity_mps"));
  at.injection.radius_m = real(item.at("radius_m"), 1e7);
  at.injection.column = item.at("column").get<bool>();
  if (!(at.injection.radius_m > 0.0)) throw std::runtime_error("radius_m is not positive");
  return at;
}

template <typename Item>
std::vector<Item> read_list(const nlohmann::json& report, const char* key, Item (*read)(const nlohmann::json&)) {
  std::vector<Item> items;
  const auto list = report.find(key);
  if (list == report.end()) return items;
  if (!list->is_array()) throw std::runtime_error(fmt::format("the report's {} is no list", key));
  for (const auto& item : *list) {
    try {
      items.push_back(read(item));
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}[{}]: {}", key, items.size(), error.what()));
    }
  }
  return items;
}

}  // namespace

void add_steering(Json& report, const Run& run) {
  Json commands = Json::array();
  for (const OrderRecord& record : run.orders()) {
    const bool has_point = record.order.kind == OrderKind::Goto;
    commands.push_back({{"step", record.step},
                        {"round", record.round},
                        {"id", text_of(record.order.id)},
                        {"agent", record.order.agent},
                        {"kind", name_of(record.order.kind)},
                        {"to_m", has_point ? list_of(record.order.to_m) : Json(nullptr)},
                        {"speed_mps", has_point ? Json(record.order.speed_mps) : Json(nullptr)},
                        {"acknowledged", record.acknowledged}});
  }
  report["commands"] = commands;
  Json injections = Json::array();
  for (const InjectionRecord& record : run.injections()) {
    injections.push_back({{"step", record.step},
                          {"round", record.round},
                          {"id", text_of(record.injection.id)},
                          {"position_m", list_of(record.injection.position_m)},
                          {"velocity_mps", list_of(record.injection.velocity_mps)},
                          {"radius_m", record.injection.radius_m},
                          {"column", record.injection.column}});
  }
  report["injections"] = injections;
}

std::vector<OrderedAt> orders_of(const nlohmann::json& report) {
  return read_list<OrderedAt>(report, "commands", order_of);
}

std::vector<InjectedAt> injections_of(const nlohmann::json& report) {
  return read_list<InjectedAt>(report, "injections", injection_of);
}

}  // namespace skein
