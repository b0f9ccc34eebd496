#include "frontends/radio_map/explained_variance.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

namespace walkgraph {
namespace {

Eigen::MatrixXf Random(Eigen::Index rows, Eigen::Index columns, std::mt19937* random) {
  std::normal_distribution<float> normal;
  return Eigen::MatrixXf::NullaryExpr(rows, columns, [&] { return normal(*random); });
}

// Sizes on either side of whole blocks of rows and columns.
TEST(ExplainedVarianceTest, IsTheSolutionsSquareInDoublePrecision) {
  std::mt19937 random(4);
  for (const Eigen::Index n : {1, 2, 3, 4, 5, 8, 31, 130}) {
    const Eigen::MatrixXf root = Random(n, n, &random);
    const Eigen::MatrixXd covariance =
        (root * root.transpose()).cast<double>() + n * Eigen::MatrixXd::Identity(n, n);
    const Eigen::MatrixXf lower = covariance.llt().matrixL().toDenseMatrix().cast<float>();
    for (const Eigen::Index m : {0, 1, 15, 16, 17, 40}) {
      const Eigen::MatrixXf cross = Random(n, m, &random);
      const Eigen::MatrixXd b = cross.cast<double>();
      const Eigen::MatrixXd solved = covariance.llt().solve(b);
      for (const Eigen::ArrayXf& explained :
           {ExplainedVariance(lower, cross), PortableExplainedVariance(lower, cross)}) {
        ASSERT_EQ(explained.size(), m);
        for (Eigen::Index i = 0; i < m; ++i) {
          const double expected = b.col(i).dot(solved.col(i));
          EXPECT_NEAR(explained[i], expected, 1e-4 * expected) << n << " " << m;
        }
      }
    }
  }
}

// What stands above the diagonal is no part of the factor.
TEST(ExplainedVarianceTest, ReadsTheLowerTriangleAlone) {
  std::mt19937 random(5);
  Eigen::MatrixXf lower = Random(9, 9, &random);
  lower.diagonal().array() = 3;
  const Eigen::MatrixXf cross = Random(9, 20, &random);
  const Eigen::ArrayXf full = ExplainedVariance(lower, cross);
  const Eigen::MatrixXf triangle = lower.triangularView<Eigen::Lower>();
  EXPECT_TRUE((full == ExplainedVariance(triangle, cross)).all());
}

}  // namespace
}  // namespace walkgraph
