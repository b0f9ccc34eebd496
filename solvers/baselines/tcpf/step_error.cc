#include "solvers/baselines/tcpf/step_error.h"

#include <cmath>
#include <numbers>

namespace walkgraph {
namespace {

double NormalDensity(double t, const HeadingError& error) {
  const double z = (t - error.mean_rad) / error.sigma_rad;
  return std::exp(-0.5 * z * z) / (error.sigma_rad * std::sqrt(2 * std::numbers::pi));
}

// Simpson's rule over [begin, end].
template <typename Function>
double Integrate(double begin, double end, Function function) {
  constexpr int kIntervals = 400;
  const double h = (end - begin) / kIntervals;
  double sum = function(begin) + function(end);
  for (int i = 1; i < kIntervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * function(begin + i * h);
  return sum * h / 3;
}

}  // namespace

double ProbabilityWithin(double limit_rad, const HeadingError& error) {
  const double scale = error.sigma_rad * std::numbers::sqrt2;
  return 0.5 * (std::erf((limit_rad - error.mean_rad) / scale) +
                std::erf((limit_rad + error.mean_rad) / scale));
}

double ExpectedStepError(double length_m, const HeadingError& error) {
  const auto weighted = [&](double t) {
    return NormalDensity(t, error) * 2 * length_m * std::abs(std::sin(t / 2));
  };
  // In two parts, so that the kink at zero is no interior point of a parabola.
  const double reach = 8 * error.sigma_rad;
  const double begin = error.mean_rad - reach, end = error.mean_rad + reach;
  if (begin >= 0 || end <= 0) return Integrate(begin, end, weighted);
  return Integrate(begin, 0, weighted) + Integrate(0, end, weighted);
}

}  // namespace walkgraph
