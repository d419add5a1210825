// Where commands and injections wait for the round that takes them, and where the answers stand that ticks say.
//
// A command is taken once, by its id; a copy changes nothing. It waits until a round is decided, and takes effect with
// the next tick, or is refused with a reason, or expires when its deadline passes before. What became of it is said in
// all ticks of the next kSaid_s seconds, and again when somebody acknowledged it: observers read best effort. Orders
// and obstacles of another run are repeated at its rounds; of these nothing is said. Source: docs/steering.md. Departs
// from source: none. Complexity: O(commands that wait) a round.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "simworld/lockstep/steered.hpp"

namespace skein {

class CommandDesk {
 public:
  /// @param orders, injections of another run, to be repeated
  CommandDesk(std::vector<OrderedAt> orders, std::vector<InjectedAt> injections)
      : orders_(std::move(orders)), injections_(std::move(injections)) {}

  void take(const Command& command, double now_s);
  void take(const Inject& inject, double now_s);
  /// An id that another world of this run has taken; and what is to be repeated up to a round has been.
  void remember(const Steered& steered, std::uint32_t round);

  /// Whether anything waits.
  [[nodiscard]] bool empty() const { return waiting_.empty() && doing_.empty(); }
  /// Whether an order of a kind waits.
  [[nodiscard]] bool told(OrderKind kind) const;
  /// Whether what waits, and has not expired, ends the agent's part in the run: an abort, or a kill or restart of it.
  [[nodiscard]] bool ends(AgentId agent, double now_s) const;
  /// Answers those whose deadline has passed.
  void expire(double now_s);
  /// Takes out the injections that act on processes.
  [[nodiscard]] std::vector<Injection> take_faults();
  /// Takes out what waits: what nothing is said against, and what is due of another run. At most 16 orders; the rest
  /// waits for the next round. @param round that it takes effect in
  [[nodiscard]] Steered take_due(std::uint32_t round,
                                 const std::function<std::optional<Objection>(const Order&)>& objection, double now_s);
  /// The tick of that round says `orders`; what else was taken out for it came too late.
  void took_effect(std::uint32_t round, const std::vector<Order>& orders, bool finished, double now_s);
  /// Answers what something is said against; of injections the objection gets nullptr.
  void refuse(const std::function<std::optional<Objection>(const Order*)>& objection, double now_s);
  /// Takes out all orders of a kind, which take effect in a round.
  void accept_all(OrderKind kind, std::uint32_t round, double now_s);
  void answer(std::uint64_t id, const Objection& why, double now_s);
  void accept(std::uint64_t id, std::uint32_t round, double now_s);

  /// What a tick says now, with what the run knows of acknowledgements.
  [[nodiscard]] std::vector<OrderAnswer> answers(const std::vector<OrderRecord>& known, double now_s);

  /// What was to be repeated, and whose round never came.
  [[nodiscard]] const std::vector<OrderedAt>& unused_orders() const { return orders_; }
  [[nodiscard]] const std::vector<InjectedAt>& unused_injections() const { return injections_; }

 private:
  struct Waiting {
    std::optional<Order> order;
    std::optional<Injection> injection;
    double until_s = 0.0;
    [[nodiscard]] std::uint64_t id() const { return order ? order->id : injection->id; }
  };
  struct Said {
    OrderAnswer answer;
    double since_s = 0.0;
  };
  void put(OrderAnswer answer, double now_s);

  std::vector<OrderedAt> orders_;
  std::vector<InjectedAt> injections_;
  std::vector<Waiting> waiting_;
  std::vector<Waiting> doing_;  ///< taken out for the coming tick
  std::set<std::uint64_t> taken_;
  std::vector<Said> said_;
};

}  // namespace skein
