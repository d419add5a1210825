// Random numbers that depend on what they are for, never on the order in which they are drawn.
//
// A stream is named by (run seed, agent, purpose, index): word n of a stream is a pure function of that name and n,
// Philox4x64-10(key = (seed, agent * 2^32 + purpose), counter = (n / 4, index, 0, 0))[n mod 4].
// Source: Salmon, Moraes, Dror, Shaw, 'Parallel random numbers: as easy as 1, 2, 3', SC 2011; Debian's Random123.
// Departs from source: own mappings to uniform and normal numbers, so that every machine agrees on them.
// Complexity: O(1) a number.
#pragma once

#include <array>
#include <cstdint>

namespace skein {

/// What a stream is drawn for. Values are part of every golden result: append, never renumber.
enum class Purpose : std::uint32_t {
  SwarmStart = 1,   ///< initial particles of a sub-swarm; index: the particle
  SwarmMove = 2,    ///< a particle's move; index: generation * particles + particle
  Breeding = 3,     ///< a pair of children of a genetic population; index: generation * particles + first child
  JoinedStart = 4,  ///< initial particles of a sub-swarm of joined paths; index: the particle
  JoinedMove = 5,   ///< a move of such a particle; index: generation * particles + particle
  JoinedAlone = 6,  ///< joined paths tried if the best particle fails the proof; index: the try
  JoinedRay = 7,    ///< directions in which joined paths of a length are looked for; index: the direction
  Sensor = 20,      ///< misses and false alarms of a look; index: step * 2^32 + cell
  Layout = 21,      ///< generated scenarios, of agent 0; index: 0 a forest, 1 starts and goals, 2 movers, 3 a swap,
                    ///< from 100 the times of sudden obstacles
  RadioLoss = 22,   ///< whether a receiver misses a sample; agent: the sender, index: receiver, step and round
  Mover = 23,       ///< moves of an obstacle; agent: its id, index: the step, 0 for what it starts with
  Delay = 24,       ///< of what is announced, of agent 0; index: the announcement
  Chaos = 40,       ///< faults of a campaign, of agent 0; index: the run
  Test = 1000,      ///< draws of tests
};

class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint32_t agent, Purpose purpose, std::uint64_t index);

  /// The next 64 random bits.
  std::uint64_t next() {
    if (used_ == words_.size()) refill();
    return words_[used_++];
  }
  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  /// Uniform in [low, high].
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0 .. n - 1, without bias. @throws std::invalid_argument if n is 0.
  std::uint64_t below(std::uint64_t n);
  /// Normal with mean 0 and standard deviation 1 (Box-Muller, two words a number).
  double normal();

 private:
  void refill();

  std::array<std::uint64_t, 2> key_;
  std::uint64_t index_;
  std::uint64_t block_ = 0;
  std::array<std::uint64_t, 4> words_{};
  std::size_t used_ = 4;
};

}  // namespace skein
