// How long the rendezvous search takes: per particle, per generation, per plan, against the number of UAVs; each with
// the scalar kernel and with every instruction set of this machine.
//
// usage: planner_kernel_bench [--benchmark_filter=Plan/avx2] [--benchmark_repetitions=5 ...]
#include <benchmark/benchmark.h>

#include <string>

#include "tests/planner/rendezvous/kernel/random_batch.hpp"
#include "tests/planner/rendezvous/layouts.hpp"
#include "tests/planner/rendezvous/swarm_run.hpp"

namespace skein::rendezvous {
namespace {

constexpr std::size_t kParticles = 20;
constexpr std::size_t kPoints = 50;

std::vector<Evaluation> random_particles(const Problem& problem) {
  std::vector<Evaluation> particles(kParticles);
  for (std::size_t j = 0; j < kParticles; ++j) {
    RandomStream stream(7, 1, Purpose::Test, j);
    const Interval& range = problem.own().range_m;
    particles[j].controls = {stream.uniform(range.min, range.max), stream.uniform(range.min, range.max)};
  }
  return particles;
}

/// Everything there is to find out about a sub-swarm, by particle: cost, points and separation from two peers.
void particle(benchmark::State& state, Isa isa) {
  const Problem problem = make_problem(test::layout_a(1), 2, kernel::kernel_of(isa));
  std::vector<Evaluation> particles = random_particles(problem);
  SubSwarm swarm(problem);
  std::vector<PeerPath> peers{{1, 200.0, swarm.best().points_m}, {3, 200.0, swarm.best().points_m}};
  LazyCosts costs(problem, kParticles, Evaluate::Always);
  costs.evaluate(problem, particles);
  PeerTable table;
  table.assign(peers, kPoints);
  costs.face(problem, table.peers(), 35061.0, particles);
  for (auto _ : state) {
    costs.evaluate(problem, particles);
    costs.bound(problem, particles);
    benchmark::DoNotOptimize(particles.data());
  }
  state.counters["s_per_particle"] = benchmark::Counter(static_cast<double>(state.iterations() * kParticles),
                                                        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The four steps of the kernel by themselves, for a sub-swarm.
void judge_step(benchmark::State& state, Isa isa) {
  const Problem problem = make_problem(test::layout_a(1), 2, kernel::kernel_of(isa));
  std::vector<Evaluation> particles = random_particles(problem);
  Batch batch(problem, kParticles);
  for (auto _ : state) batch.evaluate(problem, particles);
}

void walk_step(benchmark::State& state, Isa isa) {
  const Problem problem = make_problem(test::layout_a(1), 2, kernel::kernel_of(isa));
  std::vector<Evaluation> particles = random_particles(problem);
  Batch batch(problem, kParticles);
  batch.evaluate(problem, particles);
  std::vector<std::size_t> all(kParticles);
  for (std::size_t j = 0; j < kParticles; ++j) all[j] = j;
  PointTable points(kPoints, kParticles);
  for (auto _ : state) batch.walk(problem, all, points);
}

/// One generation of UAV 2, averaged over all generations of a search among standing peers.
void generation(benchmark::State& state, Isa isa, Evaluate when) {
  const Problem problem = make_problem(test::layout_a(1), 2, kernel::kernel_of(isa));
  const SubSwarm start(problem, when);
  std::vector<PeerPath> peers{{1, 200.0, start.best().points_m}, {3, 200.0, start.best().points_m}};
  for (Vec2& point : peers[0].points_m) point += Vec2(0.0, -2000.0);
  for (Vec2& point : peers[1].points_m) point += Vec2(0.0, 2000.0);
  SubSwarm swarm = start;
  for (auto _ : state) {
    if (swarm.generation() == problem.options.generations) {
      state.PauseTiming();
      swarm = start;
      state.ResumeTiming();
    }
    swarm.advance(problem, peers, 35061.0);
  }
}

/// A whole plan of three UAVs, first round to Ready, seed by seed.
void plan(benchmark::State& state, Isa isa) {
  std::uint64_t seed = 0;
  for (auto _ : state) {
    const test::SwarmRun run = test::run_swarm(test::layout_a(seed++ % 20), 200, {}, kernel::kernel_of(isa));
    if (!run.all(PlanStatus::Ready)) state.SkipWithError("a plan failed");
  }
}

/// The same in space, among cylinders, boxes and hills.
void plan_in_space(benchmark::State& state, Isa isa) {
  std::uint64_t seed = 0;
  for (auto _ : state) {
    const test::SwarmRun run = test::run_swarm(test::layout_space(seed++ % 20), 200, {}, kernel::kernel_of(isa));
    if (!run.all(PlanStatus::Ready)) state.SkipWithError("a plan failed");
  }
}

/// The search of one agent among N - 1 peers on a ring: its share of a plan, by generation.
void share(benchmark::State& state, Isa isa) {
  const Mission mission = test::ring(1, static_cast<int>(state.range(0)), 20000.0, 5000.0);
  std::vector<std::vector<Representative>> rounds;
  const auto keep = [&](int, test::SwarmRun& run) {
    rounds.emplace_back();
    for (std::size_t i = 1; i < run.last.size(); ++i) rounds.back().push_back(run.last[i].representative);
  };
  const int generations = mission.planner.generations;
  (void)test::run_swarm(mission, generations + 1, keep, kernel::kernel_of(Isa::Baseline));
  for (auto _ : state) {
    state.PauseTiming();
    Planner planner(mission, 1, kernel::kernel_of(isa));
    (void)planner.advance({});
    state.ResumeTiming();
    for (int g = 1; g <= generations; ++g)
      benchmark::DoNotOptimize(planner.advance(rounds[static_cast<std::size_t>(g)]));
  }
  state.counters["s_per_generation"] =
      benchmark::Counter(static_cast<double>(state.iterations() * static_cast<benchmark::IterationCount>(generations)),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void add_benchmarks() {
  for (const Isa isa : kIsas) {
    if (!is_supported(isa)) continue;
    const auto named = [&](const char* what) { return std::string(what) + "/" + std::string(name_of(isa)); };
    benchmark::RegisterBenchmark(named("Particle").c_str(), particle, isa)->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(named("Judge20").c_str(), judge_step, isa)->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(named("Walk20").c_str(), walk_step, isa)->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(named("GenerationInFull").c_str(), generation, isa, Evaluate::Always)
        ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(named("GenerationOnDemand").c_str(), generation, isa, Evaluate::OnDemand)
        ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(named("Plan").c_str(), plan, isa)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(named("PlanInSpace").c_str(), plan_in_space, isa)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(named("Share").c_str(), share, isa)
        ->Arg(3)
        ->Arg(10)
        ->Arg(30)
        ->Arg(100)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace skein::rendezvous

int main(int argc, char** argv) {
  skein::rendezvous::add_benchmarks();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
