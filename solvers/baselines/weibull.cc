#include "solvers/baselines/weibull.h"

#include <cmath>

namespace walkgraph {
namespace {

// Moments of the density with scale 1 and shift 0 (Weibull 1951).
double UnitMean(double shape) { return std::tgamma(1 + 1 / shape); }
double UnitSd(double shape) {
  const double mean = UnitMean(shape);
  return std::sqrt(std::tgamma(1 + 2 / shape) - mean * mean);
}

double Above(const Weibull& weibull, double rssi_dbm) {
  const double x = (rssi_dbm - weibull.shift_dbm) / weibull.scale_db;
  return x > 0 ? std::exp(-std::pow(x, weibull.shape)) : 1.0;
}

}  // namespace

Weibull WeibullFromMoments(double shape, double mean_dbm, double sd_db) {
  Weibull weibull;
  weibull.shape = shape;
  weibull.scale_db = sd_db / UnitSd(shape);
  weibull.shift_dbm = mean_dbm - weibull.scale_db * UnitMean(shape);
  return weibull;
}

double BinProbability(const Weibull& weibull, double rssi_dbm) {
  return Above(weibull, rssi_dbm - 0.5) - Above(weibull, rssi_dbm + 0.5);
}

double WeibullSkewness(double shape) {
  const double mean = UnitMean(shape), sd = UnitSd(shape);
  return (std::tgamma(1 + 3 / shape) - 3 * mean * sd * sd - mean * mean * mean) / (sd * sd * sd);
}

double WeibullShape(double skewness) {
  double low = 1, high = 10;  // the skewness falls in between
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (WeibullSkewness(middle) > skewness ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace walkgraph
