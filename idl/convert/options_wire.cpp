#include "idl/convert/parts.hpp"

namespace skein {

wire::RendezvousPlanner wire_options(const RendezvousOptions& options) {
  wire::RendezvousPlanner out;
  require_bound(options.name.size(), out.name().max_size, "planner.name");
  out.name(options.name);
  out.particles(options.particles);
  out.generations(options.generations);
  out.length_weight(options.length_weight);
  out.inertia_start(options.inertia_start);
  out.inertia_end(options.inertia_end);
  out.cognitive(options.cognitive);
  out.social(options.social);
  out.search_min_chords(options.search_min_chords);
  out.search_max_chords(options.search_max_chords);
  out.velocity_limit(options.velocity_limit);
  out.reinitialise_probability(options.reinitialise_probability);
  out.check_points(options.check_points);
  out.dense_points(options.dense_points);
  out.penalty(options.penalty);
  out.length_penalty(options.length_penalty);
  out.clearance_margin_m(options.clearance_margin_m);
  out.equalise_directions(options.equalise_directions);
  out.equalise_rounds(options.equalise_rounds);
  out.cooperate(options.cooperate);
  out.own_reference(options.own_reference);
  out.refresh_costs(options.refresh_costs);
  out.equalise(options.equalise);
  out.length_tolerance_m(options.length_tolerance_m);
  out.crossover_probability(options.crossover_probability);
  out.mutation_probability(options.mutation_probability);
  out.max_segments(options.max_segments);
  out.replan(options.replan);
  out.rounds_per_step(options.rounds_per_step);
  return out;
}

RendezvousOptions plain_options(const wire::RendezvousPlanner& options) {
  RendezvousOptions out;
  out.name = options.name().to_string();
  out.particles = options.particles();
  out.generations = options.generations();
  out.length_weight = options.length_weight();
  out.inertia_start = options.inertia_start();
  out.inertia_end = options.inertia_end();
  out.cognitive = options.cognitive();
  out.social = options.social();
  out.search_min_chords = options.search_min_chords();
  out.search_max_chords = options.search_max_chords();
  out.velocity_limit = options.velocity_limit();
  out.reinitialise_probability = options.reinitialise_probability();
  out.check_points = options.check_points();
  out.dense_points = options.dense_points();
  out.penalty = options.penalty();
  out.length_penalty = options.length_penalty();
  out.clearance_margin_m = options.clearance_margin_m();
  out.equalise_directions = options.equalise_directions();
  out.equalise_rounds = options.equalise_rounds();
  out.cooperate = options.cooperate();
  out.own_reference = options.own_reference();
  out.refresh_costs = options.refresh_costs();
  out.equalise = options.equalise();
  out.length_tolerance_m = options.length_tolerance_m();
  out.crossover_probability = options.crossover_probability();
  out.mutation_probability = options.mutation_probability();
  out.max_segments = options.max_segments();
  out.replan = options.replan();
  out.rounds_per_step = options.rounds_per_step();
  return out;
}

}  // namespace skein
