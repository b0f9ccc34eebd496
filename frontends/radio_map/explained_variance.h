#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_EXPLAINED_VARIANCE_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_EXPLAINED_VARIANCE_H_

#include <Eigen/Core>

namespace walkgraph {

// |L^-1 b|^2 for every column b of `cross` (n x m), L the Cholesky factor of a covariance (n x n,
// its lower triangle): what n samples take off the variance at m places. In single precision. Most
// of a site's training is spent here, so that processors with AVX2 and FMA do it their own way; the
// last digits differ from those of others.
Eigen::ArrayXf ExplainedVariance(const Eigen::MatrixXf& lower, const Eigen::MatrixXf& cross);

// The same on any processor.
Eigen::ArrayXf PortableExplainedVariance(const Eigen::MatrixXf& lower,
                                         const Eigen::MatrixXf& cross);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_EXPLAINED_VARIANCE_H_
