#include "planner/rendezvous/stages.hpp"

#include <algorithm>

#include "planner/rendezvous/cost/cost.hpp"

namespace skein::rendezvous {
namespace {

/// More than the patience of the aligner, so that a state that publishes nothing new stays as it is.
constexpr std::int32_t kQuietRounds = 5;

void add_sample(StateHash& hash, const Representative& sample) {
  hash.add(sample.agent).add(sample.stage).add(sample.violated).add(std::span<const double>(sample.particle));
}

}  // namespace

bool anyone_in_trouble(const Representative& own, std::span<const Representative> peers) {
  const auto troubled = [](const Representative& sample) { return has_own_trouble(sample.violated); };
  return troubled(own) || std::ranges::any_of(peers, troubled);
}

bool takes_segment(const Representative& own, std::span<const Representative> peers) {
  return has_own_trouble(own.violated) || !anyone_in_trouble(own, peers);
}

bool Standstill::lasts(const Representative& own, std::span<const Representative> peers) {
  StateHash hash;
  add_sample(hash, own);
  for (const Representative& peer : peers) add_sample(hash, peer);
  quiet_ = hash.value() == seen_ ? quiet_ + 1 : 0;
  seen_ = hash.value();
  return quiet_ >= kQuietRounds;
}

void Standstill::add_to(StateHash& hash) const {
  if (quiet_ > 0) hash.add(seen_).add(quiet_);
}

std::uint64_t seed_of_stage(std::uint64_t run_seed, std::uint32_t stage) {
  return stage == 1 ? run_seed : StateHash().add(run_seed).add(stage).value();
}

}  // namespace skein::rendezvous
