// The search of one UAV, by the planner's name: a particle sub-swarm or a genetic population, behind one interface.
//
// Both are plain values with the same functions: from the representatives of the generation before to the next
// generation, its best by modified cost (the representative) and its best by own cost.
// Source: papers/001, sections 3.2 and 4.1. Departs from source: none. Complexity: that of the search chosen.
#pragma once

#include <variant>

#include "planner/rendezvous/swarm/genetic_population.hpp"
#include "planner/rendezvous/swarm/sub_swarm.hpp"

namespace skein::rendezvous {

template <typename Space>
class SearchIn {
 public:
  using Problem = ProblemIn<Space>;
  using Evaluation = EvaluationIn<Space>;
  using PeerPath = PeerPathIn<Space>;

  /// Generation 0. The genetic population is that of planner `ccga`; every other name searches by a sub-swarm.
  explicit SearchIn(const Problem& problem)
      : search_(problem.options.name == "ccga" ? Either(GeneticPopulationIn<Space>(problem))
                                               : Either(SubSwarmIn<Space>(problem))) {}

  /// The next generation; parameters as of SubSwarm::advance.
  void advance(const Problem& problem, const kernel::Peers& peers, std::optional<double> reference_length_m) {
    std::visit([&](auto& search) { search.advance(problem, peers, reference_length_m); }, search_);
  }

  [[nodiscard]] std::int32_t generation() const {
    return std::visit([](const auto& search) { return search.generation(); }, search_);
  }
  [[nodiscard]] const Evaluation& best() const {
    return std::visit([](const auto& search) -> const Evaluation& { return search.best(); }, search_);
  }
  [[nodiscard]] const Evaluation& own_best() const {
    return std::visit([](const auto& search) -> const Evaluation& { return search.own_best(); }, search_);
  }
  void add_to(StateHash& hash) const {
    std::visit([&](const auto& search) { search.add_to(hash); }, search_);
  }

 private:
  using Either = std::variant<SubSwarmIn<Space>, GeneticPopulationIn<Space>>;
  Either search_;
};

using Search = SearchIn<Planar>;

}  // namespace skein::rendezvous
