// What an agent does that came back after a loss and cannot take part any more: it answers, and holds its course. On a
// straight transit, and in a rendezvous that plans anew under way, it takes part again instead, and on a transit that
// shares maps it shares its own again (make_rejoined_behaviour).
//
//   phase     mode      publishes  commands
//   planning  Rejoined  nothing    nothing
//   flying    Rejoined  nothing    straight on (the world obeys if the vehicle is the agent's own again)
//   finished  Rejoined  nothing    nothing
// Everything of its former life is gone: no plan, no sub-swarm.
#pragma once

#include "agent/behaviours/behaviour.hpp"

namespace skein {

class RejoinedBehaviour final : public Behaviour {
 public:
  /// @param deaf it obeys nobody: the transit by cells, whose peers keep clear of where it drifts
  explicit RejoinedBehaviour(bool deaf = false) : deaf_(deaf) {}

  [[nodiscard]] bool can_use(const Representative& /*peer*/) const override { return true; }
  bool obey(const Order& /*order*/) override { return deaf_; }
  RoundOutput on_round(const RoundInput& input) override;
  [[nodiscard]] bool resumes_anywhere(bool /*stale*/) const override { return true; }
  void add_to(StateHash& hash) const override;

 private:
  bool deaf_;
  RoundOutput last_;
};

}  // namespace skein
