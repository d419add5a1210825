#include "simworld/checkpoint/round_record.hpp"

#include <array>
#include <bit>

#include "simworld/checkpoint/byte_order.hpp"

namespace skein {
namespace {

constexpr std::array kTopicCounts{&TopicCounts::mission, &TopicCounts::tick,           &TopicCounts::sense,
                                  &TopicCounts::beacon,  &TopicCounts::representative, &TopicCounts::obstacle_map};
constexpr std::array kTimes{&PhaseTimes::created_s, &PhaseTimes::started_s, &PhaseTimes::flying_s,
                            &PhaseTimes::finished_s};

void put_double(Bytes& into, double value) {
  put_number(into, std::bit_cast<std::uint64_t>(value));
}

void put_figures(Bytes& into, const SessionFigures& figures) {
  put_double(into, figures.now_s);
  for (double PhaseTimes::*time : kTimes) put_double(into, figures.times.*time);
  for (TopicCount TopicCounts::*topic : kTopicCounts) {
    put_number(into, (figures.topics.*topic).samples);
    put_number(into, (figures.topics.*topic).bytes);
  }
  put_number(into, figures.late_steps);
}

void put_entries(Bytes& into, const std::vector<RosterEntry>& entries) {
  put_number(into, static_cast<std::uint32_t>(entries.size()));
  for (const RosterEntry& entry : entries) {
    put_number(into, entry.agent);
    put_number(into, entry.incarnation);
    put_number(into, entry.nonce);
  }
}

/// Empty for none.
template <typename Value>
void put_sample(Bytes& into, const std::optional<Value>& value) {
  const Bytes bytes = value ? to_cdr(to_wire(*value, {})) : Bytes{};
  put_number(into, static_cast<std::uint32_t>(bytes.size()));
  into.insert(into.end(), bytes.begin(), bytes.end());
}

/// Takes what was put off the front; once anything is missing or wrong, all that follows is empty.
class Taker {
 public:
  Taker(std::span<const std::uint8_t> bytes, const WireContext& context) : rest_(bytes), context_(context) {}

  template <typename Number>
  Number number() {
    const auto bytes = take(sizeof(Number));
    return good_ ? read_number<Number>(bytes) : Number{};
  }
  double real() { return std::bit_cast<double>(number<std::uint64_t>()); }
  /// @return how many items of at least `least` bytes follow
  std::uint32_t count(std::size_t least) {
    const auto items = number<std::uint32_t>();
    good_ = good_ && items <= rest_.size() / least;
    return good_ ? items : 0;
  }
  template <typename Value, typename Wire>
  void sample(std::optional<Value>& into) {
    sample<Value, Wire>(into, context_);
  }
  template <typename Value, typename Wire>
  void sample(std::optional<Value>& into, const WireContext& context) {
    const auto bytes = take(count(1));
    if (bytes.empty()) return;
    const std::optional<Wire> wire = from_cdr<Wire>(bytes);
    good_ = good_ && wire.has_value();
    if (!good_) return;
    Checked<Value> checked = from_wire(*wire, context);
    good_ = checked.ok();
    if (good_) into = std::move(checked).value();
  }
  [[nodiscard]] bool whole() const { return good_ && rest_.empty(); }
  void refuse() { good_ = false; }

 private:
  std::span<const std::uint8_t> take(std::size_t size) {
    good_ = good_ && size <= rest_.size();
    if (!good_) return {};
    const auto bytes = rest_.first(size);
    rest_ = rest_.subspan(size);
    return bytes;
  }

  std::span<const std::uint8_t> rest_;
  const WireContext& context_;
  bool good_ = true;
};

SessionFigures take_figures(Taker& taker) {
  SessionFigures figures;
  figures.now_s = taker.real();
  for (double PhaseTimes::*time : kTimes) figures.times.*time = taker.real();
  for (TopicCount TopicCounts::*topic : kTopicCounts) {
    (figures.topics.*topic).samples = taker.number<std::uint64_t>();
    (figures.topics.*topic).bytes = taker.number<std::uint64_t>();
  }
  figures.late_steps = taker.number<std::uint32_t>();
  return figures;
}

std::vector<RosterEntry> take_entries(Taker& taker) {
  std::vector<RosterEntry> entries(taker.count(16));
  for (RosterEntry& entry : entries) {
    entry.agent = taker.number<AgentId>();
    entry.incarnation = taker.number<std::uint32_t>();
    entry.nonce = taker.number<std::uint64_t>();
  }
  return entries;
}

void put_steered(Bytes& into, const Steered& steered) {
  put_number(into, static_cast<std::uint32_t>(steered.orders.size()));
  for (const Order& order : steered.orders) put_sample(into, std::optional(Command{0, order, 0.0}));
  put_number(into, static_cast<std::uint32_t>(steered.injections.size()));
  for (const Injection& injection : steered.injections) put_sample(into, std::optional(Inject{0, injection, 0.0}));
}

void take_steered(Taker& taker, Steered& steered) {
  const WireContext any_run;
  steered.orders.resize(taker.count(4));
  for (Order& order : steered.orders) {
    std::optional<Command> command;
    taker.sample<Command, wire::Command>(command, any_run);
    if (!command) return taker.refuse();
    order = command->order;
  }
  steered.injections.resize(taker.count(4));
  for (Injection& injection : steered.injections) {
    std::optional<Inject> inject;
    taker.sample<Inject, wire::Inject>(inject, any_run);
    if (!inject) return taker.refuse();
    injection = inject->injection;
  }
}

}  // namespace

Bytes to_bytes(const RoundInputs& inputs) {
  Bytes bytes;
  put_number(bytes, inputs.round);
  put_number(bytes, inputs.world_hash);
  put_figures(bytes, inputs.figures);
  put_entries(bytes, inputs.roster);
  put_number(bytes, static_cast<std::uint32_t>(inputs.lost.size()));
  for (const Loss& loss : inputs.lost) {
    put_number(bytes, loss.agent);
    put_number(bytes, static_cast<std::uint8_t>(loss.reason));
  }
  put_entries(bytes, inputs.back);
  put_steered(bytes, inputs.steered);
  put_number(bytes, static_cast<std::uint32_t>(inputs.answers.size()));
  for (const Answer& answer : inputs.answers) {
    put_sample(bytes, answer.beacon);
    put_sample(bytes, answer.representative);
    put_sample(bytes, answer.obstacle_map);
  }
  return bytes;
}

std::optional<RoundInputs> round_inputs_from(std::span<const std::uint8_t> bytes, const WireContext& context) {
  Taker taker(bytes, context);
  RoundInputs inputs;
  inputs.round = taker.number<std::uint32_t>();
  inputs.world_hash = taker.number<std::uint64_t>();
  inputs.figures = take_figures(taker);
  inputs.roster = take_entries(taker);
  inputs.lost.resize(taker.count(5));
  for (Loss& loss : inputs.lost) {
    loss.agent = taker.number<AgentId>();
    loss.reason = static_cast<LossReason>(taker.number<std::uint8_t>());
    if (loss.reason > LossReason::Rejoined) taker.refuse();
  }
  inputs.back = take_entries(taker);
  take_steered(taker, inputs.steered);
  inputs.answers.resize(taker.count(12));
  for (Answer& answer : inputs.answers) {
    taker.sample<Beacon, wire::Beacon>(answer.beacon);
    taker.sample<Representative, wire::Representative>(answer.representative);
    taker.sample<ObstacleMapSample, wire::ObstacleMap>(answer.obstacle_map);
  }
  return taker.whole() ? std::optional(std::move(inputs)) : std::nullopt;
}

}  // namespace skein
