#include "agent/behaviours/rejoined.hpp"

namespace skein {

RoundOutput RejoinedBehaviour::on_round(const RoundInput& input) {
  last_.mode = AgentMode::Rejoined;
  last_.commanded_velocity_mps = input.sense == nullptr ? Vec3::Zero() : input.sense->velocity_mps;
  return last_;
}

void RejoinedBehaviour::add_to(StateHash& hash) const {
  hash.add(last_.mode).add(last_.commanded_velocity_mps);
}

}  // namespace skein
