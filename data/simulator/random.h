#ifndef WALKGRAPH_DATA_SIMULATOR_RANDOM_H_
#define WALKGRAPH_DATA_SIMULATOR_RANDOM_H_

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace walkgraph {

// Random numbers that are the same with every standard library: the engine is specified to the bit,
// the distributions of <random> are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  // Independent of this one and of every fork with another number, however much each is used.
  Random Fork(std::uint64_t number) const { return Random(seed_of_forks_ ^ Mix(number + 1)); }

  // Uniform in [0, 1) on 53 bits.
  double Uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }

  // Uniform in 0..count-1; count is far below 2^53.
  int Index(int count) { return static_cast<int>(Uniform() * count); }

  // Standard normal by Box and Muller.
  double Normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * Uniform());
  }
  double Normal(double mean, double sigma) { return mean + sigma * Normal(); }

 private:
  // The finaliser of splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
  static std::uint64_t Mix(std::uint64_t x) {
    x *= 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
  }

  std::mt19937_64 engine_;
  std::uint64_t seed_of_forks_ = engine_();
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_RANDOM_H_
