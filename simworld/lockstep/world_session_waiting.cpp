#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "simworld/lockstep/world_session.hpp"

namespace skein {
namespace {

constexpr double kMission_s = 2.0;  ///< an agent that lacks the mission for so long gets it again

}  // namespace

void WorldSession::poll_waiting(double now_s) {
  if (topics_.mission.samples == 0) {
    if (now_s - times_.created_s < options_.settle_s) return;
    publish_mission(now_s);
  }
  take_orders_waiting(now_s);
  if (state_ != State::Waiting) return;
  world_matched_ = port_.matched();
  const bool waits = options_.wait_start && !admission_.closed() && !desk_.told(OrderKind::Start);
  if (const auto roster = admission_.roster(world_matched_); roster && waits) {
    startable_s_ = now_s;  // nobody is missing but who says so
  } else if (roster && !admission_.closed()) {
    admission_.close();
    tick_.roster = *roster;
  }
  if (admission_.closed()) return start(now_s);
  if (now_s - std::max(times_.created_s, startable_s_) > options_.startup_timeout_s) {
    const std::string missing = fmt::format("{}", fmt::join(admission_.missing(world_matched_), ", "));
    return refuse_start(fmt::format("start-up timed out after {} s: {} of {} agents matched; missing: {} ({})",
                                    options_.startup_timeout_s, matched(), mission_.vehicles.size(), missing,
                                    admission_.obstacles(world_matched_)),
                        now_s);
  }
  if (!admission_.lacks_mission()) all_have_mission_s_ = now_s;
  if (now_s - std::max(all_have_mission_s_, mission_sent_s_) >= kMission_s) publish_mission(now_s);
  if (now_s - last_sent_s_ >= kWaitingTick_s) publish_tick(now_s);
}

/// Opens round 1, unless it is held on purpose.
void WorldSession::start(double now_s) {
  if (is_held(now_s) || state_ != State::Waiting) return;
  state_ = State::Running;
  times_.started_s = now_s;
  const Steered steered = take_start(now_s);
  record_round(steered, now_s);
  const Tick first = run_.begin(tick_.roster, std::exchange(lost_, {}), back_, steered);
  desk_.took_effect(first.round, first.orders, run_.finished(), now_s);
  go_on(first, now_s);
}

/// @pre all live agents have answered the open tick
bool WorldSession::is_recorded(double now_s) {
  if (gate_.passes(tick_, [this](AgentId agent) { return is_live(agent); })) return true;
  if (gate_.waits_s(tick_.round, now_s) - away_s_ >= deadline_s_) gate_.give_up();
  return gate_.given_up();
}

void WorldSession::refuse_start(const std::string& reason, double now_s, ExitCode code) {
  if (state_ != State::Waiting) return;
  start_failure_ = reason;
  interrupt(reason, static_cast<int>(code), now_s);
}

}  // namespace skein
