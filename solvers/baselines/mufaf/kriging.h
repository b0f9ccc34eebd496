#ifndef WALKGRAPH_SOLVERS_BASELINES_MUFAF_KRIGING_H_
#define WALKGRAPH_SOLVERS_BASELINES_MUFAF_KRIGING_H_

#include <Eigen/Core>
#include <vector>

namespace walkgraph {

// gamma(0) = 0, gamma(h) = nugget + partial_sill (1.5 h / range - 0.5 (h / range)^3) up to the
// range and nugget + partial_sill beyond. Source: equation (31) of the MUFAF paper, whose symbols
// are swapped in print, after Cressie, Statistics for Spatial Data (1993).
struct SphericalVariogram {
  double nugget = 0;        // dB^2
  double partial_sill = 1;  // dB^2
  double range_m = 1;

  double operator()(double distance_m) const;
  double Sill() const { return nugget + partial_sill; }
};

// Half the mean squared difference of values by distance, equation (28): bins of equal width up to
// half the largest distance.
struct EmpiricalVariogram {
  std::vector<double> distance_m, gamma, pairs;
};
EmpiricalVariogram MeasureVariogram(const std::vector<Eigen::Vector2d>& positions_m,
                                    const Eigen::VectorXd& values, int bins);

// The spherical model nearest to a measured one, least squares weighted by pairs: for each of a
// ladder of ranges the nugget and partial sill (neither negative) that fit best. Flat (a nugget
// alone) where nothing was measured.
SphericalVariogram FitSpherical(const EmpiricalVariogram& measured);

struct Interpolated {
  double value = 0;
  double variance = 0;
  Eigen::VectorXd weights;
  double multiplier = 0;  // of Lagrange, for weights that sum to one; 0 where they need not
};

// Ordinary kriging, equations (32) and (33). Preconditions: not empty, no two positions alike.
Interpolated OrdinaryKriging(const SphericalVariogram& variogram,
                             const std::vector<Eigen::Vector2d>& positions_m,
                             const Eigen::VectorXd& values, const Eigen::Vector2d& target_m);

// The rival: interpolation by the covariance sill - gamma about a mean that is taken as known.
Interpolated CovarianceInterpolation(const SphericalVariogram& variogram, double mean,
                                     const std::vector<Eigen::Vector2d>& positions_m,
                                     const Eigen::VectorXd& values,
                                     const Eigen::Vector2d& target_m);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_MUFAF_KRIGING_H_
