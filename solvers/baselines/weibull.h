#ifndef WALKGRAPH_SOLVERS_BASELINES_WEIBULL_H_
#define WALKGRAPH_SOLVERS_BASELINES_WEIBULL_H_

namespace walkgraph {

// A Weibull density of signal strength, shifted since dBm are negative:
// P(rssi < x) = 1 - exp(-((x - shift) / scale)^shape) above the shift, 0 below.
struct Weibull {
  double shape = 0;
  double scale_db = 0;
  double shift_dbm = 0;
};

// The one with the given shape, mean and standard deviation (all but the mean positive).
Weibull WeibullFromMoments(double shape, double mean_dbm, double sd_db);

// Probability of the 1 dB bin centred on `rssi_dbm`.
double BinProbability(const Weibull& weibull, double rssi_dbm);

// Third standardised moment of a Weibull density: 2 for shape 1, 0 near 3.6, -0.64 for 10.
double WeibullSkewness(double shape);

// The shape with the given skewness, limited to [1, 10].
double WeibullShape(double skewness);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_WEIBULL_H_
