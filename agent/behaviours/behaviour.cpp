#include "agent/behaviours/behaviour.hpp"

#include <stdexcept>

#include "agent/behaviours/rejoined.hpp"
#include "agent/behaviours/rendezvous.hpp"
#include "agent/behaviours/straight.hpp"
#include "agent/behaviours/transit.hpp"

namespace skein {

std::unique_ptr<Behaviour> make_behaviour(const Mission& mission, AgentId self) {
  switch (mission.kind) {
    case MissionKind::Rendezvous:
      return std::make_unique<RendezvousBehaviour>(mission, self);
    case MissionKind::Transit:
      if (mission.transit && mission.transit->planner.name == kStraight) {
        return std::make_unique<StraightBehaviour>(mission, self);
      }
      return std::make_unique<TransitBehaviour>(mission, self);
  }
  throw std::invalid_argument("no behaviour is for this kind of mission");
}

std::unique_ptr<Behaviour> make_rejoined_behaviour(const Mission& mission, AgentId self) {
  if (mission.kind == MissionKind::Rendezvous && mission.planner.replan != 0) {
    return std::make_unique<RendezvousBehaviour>(mission, self, true);
  }
  if (mission.transit && mission.transit->planner.name == kStraight) {
    return std::make_unique<StraightBehaviour>(mission, self);  // needs nothing of its former life
  }
  if (mission.transit && mission.transit->planner.share_maps != 0.0) {
    return std::make_unique<TransitBehaviour>(mission, self, true);
  }
  return std::make_unique<RejoinedBehaviour>(mission.kind == MissionKind::Transit);
}

}  // namespace skein
