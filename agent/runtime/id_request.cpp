#include "agent/runtime/id_request.hpp"

#include <algorithm>

namespace skein {
namespace {

constexpr double kAsk_s = 0.25;

}  // namespace

IdRequest::IdRequest(std::uint64_t nonce, bus::AgentPort& port, double now_s)
    : nonce_(nonce), port_(port), heard_world_s_(now_s) {
  port_.wake_after(bus::kOnTick);
}

void IdRequest::poll(double now_s) {
  inbox_.clear();
  port_.take(inbox_);
  for (const bus::AgentInbound& sample : inbox_) {
    if (const auto* tick = std::get_if<wire::Tick>(&sample)) on_tick(*tick, now_s);
  }
  if (!id_ && !over_ && now_s - last_sent_s_ >= kAsk_s) send(AgentMode::Waiting, now_s);
}

double IdRequest::idle_s(double now_s) const {
  return std::clamp(last_sent_s_ + kAsk_s - now_s, 0.0, kAsk_s);
}

void IdRequest::leave(double now_s) {
  send(AgentMode::Leaving, now_s);
}

void IdRequest::on_tick(const wire::Tick& sample, double now_s) {
  const Checked<Tick> checked = from_wire(sample, {});
  if (!checked.ok()) return;
  const Tick& tick = checked.value();
  heard_world_ = true;
  heard_world_s_ = now_s;
  round_ = tick.round;
  over_ = tick.phase == Phase::Finished;
  const auto own = std::ranges::find(tick.assigned, nonce_, &Assignment::nonce);
  if (own != tick.assigned.end()) id_ = own->agent;
}

void IdRequest::send(AgentMode mode, double now_s) {
  Beacon beacon;
  beacon.nonce = nonce_;
  beacon.round = round_;
  beacon.mode = mode;
  port_.publish(to_wire(beacon, {static_cast<std::int64_t>(now_s * 1e9), 0}));
  last_sent_s_ = now_s;
}

}  // namespace skein
