#ifndef WALKGRAPH_SOLVERS_BASELINES_DSFF_ERROR_BLOCK_H_
#define WALKGRAPH_SOLVERS_BASELINES_DSFF_ERROR_BLOCK_H_

#include <array>
#include <cstdint>
#include <map>
#include <string_view>

namespace walkgraph {

enum class ErrorBlockMode : std::uint8_t {
  kBlock,  // every error weighs the same: add a block and normalise
  kAging,  // exponential smoothing, the initial normal included
};
inline constexpr std::array<std::string_view, 2> kErrorBlockModeNames = {"block", "aging"};

struct ErrorBlockSettings {
  ErrorBlockMode mode = ErrorBlockMode::kAging;
  double block_mass = 0.3;
  double alpha = 0.2;
};

template <typename Visitor>
void Visit(Visitor& v, ErrorBlockSettings& s) {
  v.Field("mode", s.mode, "how errors are learnt: block or aging (the paper's)");
  v.Field("block_mass", s.block_mass,
          "mass of a block before normalising, height x sigma (the paper's 0.1 at 3 degrees)");
  v.Field("alpha", s.alpha, "weight of the newest block when ageing (the paper's)");
}

// What is known about the error of a relative sensor: a histogram whose bins are one sigma wide,
// centred on the multiples of sigma, without end on either side. It begins as the sensor's normal
// density cut at +-2.5 sigma. Source: equations (18), (19), (27) and (34) of the DSFF paper.
class ErrorBlock {
 public:
  // sigma > 0 in the unit of the sensor.
  ErrorBlock(double sigma, const ErrorBlockSettings& settings);

  // Learns one error, reading minus what was true.
  void Add(double error);

  // Of the histogram taken as constant within bins.
  double Mean() const;
  double Variance() const;
  double MassWithin(double low, double high) const;

  // log density of the true value's deviation from the reading: the sensor's normal density
  // convolved with the mirrored histogram, in 1 over the sensor's unit.
  double LogDensity(double deviation) const;

 private:
  double sigma_;
  ErrorBlockSettings settings_;
  std::map<int, double> mass_;  // by bin
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DSFF_ERROR_BLOCK_H_
