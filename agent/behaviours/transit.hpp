// Transit: each UAV crosses unknown space to its goal, and shares with its peers what its sensor saw.
//
//   phase     mode                                    publishes                  commands
//   planning  Ready: there is nothing to plan before  nothing                    nothing
//   flying    Flying, Arrived, Unreachable, Deadlock  at decisions: its map      straight to the decision's target
//   flying    by command: Holding, GoingTo, Landing,  the same                   the same; who holds stays, and who
//             Landed                                                             is sent off flies to its place
//   flying    Rejoined: came back after a loss        the same, without intent   nothing that counts
//   finished  as before                               nothing                    nothing
// A decision is taken every decision_s, in the flight steps 1, 1 + D, 1 + 2 D ...; a sample composed in one is heard,
// if the radio carries it (planner/core/radio), in the next. The intent in it stands for the next decision. In between
// the UAV flies on at constant velocity, and its map takes in what its sensor sees. Who came back flies nothing any
// more, but has the swarm's map again as soon as the radio brings it, and passes it on. Commands are obeyed here: the
// motion of the decision is flown to its end, so that right of way holds, then the navigator does its errand; maps and
// intents go on. Who lands is down at once, like who arrives: of what is below the area nothing is known. Source:
// papers/004, sections III and IV. Departs from source: intents; maps by anti-entropy instead of whole.
#pragma once

#include <map>
#include <optional>

#include "agent/behaviours/behaviour.hpp"
#include "planner/core/obstacle_map/obstacle_map.hpp"
#include "planner/core/radio/radio.hpp"
#include "planner/core/radio/radio_budget.hpp"
#include "planner/gridnav/navigator.hpp"

namespace skein {

class TransitBehaviour final : public Behaviour {
 public:
  /// @throws std::invalid_argument if the mission is no transit, has no such vehicle or its options are not legal.
  /// @param rejoined it came back after a loss: it flies nothing, and shares its map again
  TransitBehaviour(const Mission& mission, AgentId self, bool rejoined = false);

  [[nodiscard]] bool can_use(const Representative& /*peer*/) const override { return false; }
  /// Who arrived, landed or came back after a loss hears orders and does nothing.
  bool obey(const Order& order) override;
  RoundOutput on_round(const RoundInput& input) override;
  void add_to(StateHash& hash) const override;

 private:
  enum class Doing : std::uint8_t { Mission = 0, Hold = 1, Goto = 2, Land = 3, Landed = 4 };

  void begin(const Order& order, const Sense& sense);
  void report_command();
  void note_lives(const Tick& tick);
  void listen(const RoundInput& input);
  void look(const CellWindow& sight);
  void hear(const Tick& tick);
  void decide(const Tick& tick, const Sense& sense);
  void share(const Tick& tick, const Sense& sense);
  [[nodiscard]] std::vector<gridnav::Neighbour> neighbours(const Sense& sense, std::uint32_t decision) const;
  [[nodiscard]] std::optional<ObstacleMapSample> compose(const Tick& tick, const Sense& sense, std::uint32_t decision);
  [[nodiscard]] bool is_crowded(const Sense& sense) const;
  [[nodiscard]] std::vector<MapPeer> peers_in_reach(const Sense& sense) const;

  Mission mission_;
  AgentId self_;
  bool rejoined_;
  std::map<AgentId, std::uint32_t> lives_;  ///< incarnations, as the last tick has them
  std::uint32_t silent_until_ = 0;          ///< decision; its former life may have sent in the same frame of the radio
  std::uint32_t steps_per_decision_;
  gridnav::Navigator navigator_;
  ObstacleMap map_;
  RadioReceiver<ObstacleMapSample> receiver_;
  RadioBudget budget_;
  gridnav::NavDecision decision_;  ///< the newest
  Doing doing_ = Doing::Mission;
  std::optional<Order> order_;  ///< of this round
  RoundOutput last_;
};

}  // namespace skein
