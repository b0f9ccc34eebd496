#ifndef WALKGRAPH_EVAL_RANDOM_H_
#define WALKGRAPH_EVAL_RANDOM_H_

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace walkgraph {

// The finaliser of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): every output bit hangs on every
// input bit. Used instead of <random>, whose distributions differ between standard libraries.
constexpr std::uint64_t MixBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// FNV-1a, 64 bits: the same number on every machine. `hash` continues an earlier piece of the text.
constexpr std::uint64_t HashText(std::string_view text, std::uint64_t hash = 0xcbf29ce484222325u) {
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  return hash;
}

// SplitMix64 generator. Not called Random: the simulator has a class of that name, and a program
// that links both would keep the inline constructor of one of them for both.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  std::uint64_t Next() {
    state_ += 0x9e3779b97f4a7c15u;
    return MixBits(state_);
  }

  // Uniform in [0, count); the bias of count / 2^32 is far under what resampling can show.
  // Precondition: 0 < count < 2^32.
  std::size_t Index(std::size_t count) {
    return static_cast<std::size_t>(((Next() >> 32) * count) >> 32);
  }

 private:
  std::uint64_t state_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_RANDOM_H_
