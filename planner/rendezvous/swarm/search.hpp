// The search of one UAV, by the planner's name: a particle sub-swarm or a genetic population, and for joined segments
// their sub-swarm, behind one interface.
//
// All are plain values with the same functions: from the representatives of the generation before to the next
// generation, its best by modified cost (the representative) and its best by own cost.
// Source: papers/001, sections 3.2 and 4.1. Departs from source: none. Complexity: that of the search chosen.
#pragma once

#include <utility>
#include <variant>

#include "planner/rendezvous/swarm/genetic_population.hpp"
#include "planner/rendezvous/swarm/joined_swarm.hpp"
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

  /// Generation 0 of paths of so many segments; `before` as of JoinedSwarmIn. Joined segments are searched by a
  /// sub-swarm whatever the name.
  SearchIn(const Problem& problem, std::size_t segments, const ph::Controls& before)
      : SearchIn(segments > 1 ? SearchIn(JoinedSwarmIn<Space>(problem, segments, before)) : SearchIn(problem)) {}

  /// The next generation; parameters as of SubSwarm::advance.
  void advance(const Problem& problem, const PeerTableIn<Space>& peers, std::optional<double> reference_length_m) {
    if (auto* joined = std::get_if<JoinedSwarmIn<Space>>(&search_)) {
      return joined->advance(problem, peers.paths(), reference_length_m);
    }
    if (auto* genetic = std::get_if<GeneticPopulationIn<Space>>(&search_)) {
      return genetic->advance(problem, peers.peers(), reference_length_m);
    }
    std::get<SubSwarmIn<Space>>(search_).advance(problem, peers.peers(), reference_length_m);
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
  explicit SearchIn(JoinedSwarmIn<Space> joined) : search_(std::move(joined)) {}

  using Either = std::variant<SubSwarmIn<Space>, GeneticPopulationIn<Space>, JoinedSwarmIn<Space>>;
  Either search_;
};

using Search = SearchIn<Planar>;

}  // namespace skein::rendezvous
